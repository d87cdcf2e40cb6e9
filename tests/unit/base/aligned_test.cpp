#include "base/aligned.h"

#include <cstdint>

#include "catch.h"

using namespace morula;

TEST_CASE("Arrays of any size begin on a cache line, large ones on a huge page") {
  for (const std::size_t size : {1u, 7u, 4096u, 262143u, 262144u, 1000001u}) {
    AlignedVector<double> array(size, 1.0);
    const auto address = reinterpret_cast<std::uintptr_t>(array.data());
    CHECK(address % 64 == 0);
    if (size * sizeof(double) >= 2 << 20) CHECK(address % (2 << 20) == 0);
    CHECK(array.back() == 1.0);
  }
}
