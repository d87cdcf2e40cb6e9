#include "base/vec3.h"

#include "catch.h"

using namespace morula;

TEST_CASE("Vectors add, scale and compare by component") {
  const Vector a{1, 2, 3}, b{10, -20, 40};
  CHECK(a + b == Vector{11, -18, 43});
  CHECK(b - a == Vector{9, -22, 37});
  CHECK(-a == Vector{-1, -2, -3});
  CHECK(a * 2.0 == Vector{2, 4, 6});
  CHECK(2.0 * a == a * 2.0);
  CHECK(b / 10.0 == Vector{1, -2, 4});
  Vector c = a;
  c += b;
  CHECK(c == a + b);
  c -= b;
  CHECK(c == a);
  c *= -1.0;
  CHECK(c == -a);
  for (const Vector& other : {Vector{0, 2, 3}, Vector{1, 0, 3}, Vector{1, 2, 0}}) CHECK(a != other);
  CHECK(Vector{} == Vector{0, 0, 0});
}

TEST_CASE("Scalar, vector and triple products") {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(cross(x, y) == z);
  CHECK(cross(y, z) == x);
  CHECK(cross(z, x) == y);
  CHECK(dot(Vector{1, 2, 3}, Vector{4, 5, 6}) == 32);
  CHECK(norm(Vector{2, 3, 6}) == 7);
  // Small whole numbers are exact, so the identities hold to the bit: the cross product is perpendicular to both
  // factors and changes its sign with their order, and [Lagrange] |a × b|² = |a|² |b|² − (a · b)².
  for (int i = 0; i < 1000; ++i) {
    const Vector a{i % 10 - 4.0, i / 10 % 10 - 5.0, i / 100 - 3.0}, b{i * 7 % 11 - 5.0, i * 3 % 13 - 6.0, i % 5 - 2.0};
    const Vector n = cross(a, b);
    REQUIRE(dot(n, a) == 0);
    REQUIRE(dot(n, b) == 0);
    REQUIRE(cross(b, a) == -n);
    REQUIRE(dot(n, n) == dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
  }
}
