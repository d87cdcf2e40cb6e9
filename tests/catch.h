#pragma once
// Includes Catch2 2 or 3, which differ for these tests only in their headers.
#include "base/error.h"
#if MORULA_CATCH >= 3
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
inline auto ContainsSubstring(const std::string& part) { return Catch::Contains(part); }
#endif

// Sanitizers take all of the address space, and end programs that run out of memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool memoryCanBeLimited = false;
#else
inline constexpr bool memoryCanBeLimited = true;
#endif
