#pragma once
// Catch2 2 and 3 differ in their headers only, as far as these tests go.
#include "base/error.h"
#if MORULA_CATCH >= 3
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
inline auto ContainsSubstring(const std::string& part) { return Catch::Contains(part); }
#endif
