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

// Sanitizers take all of the address space, and end a program that finds no memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool memoryCanBeLimited = false;
#else
inline constexpr bool memoryCanBeLimited = true;
#endif
