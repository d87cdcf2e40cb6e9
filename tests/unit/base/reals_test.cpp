// Arrays of either precision, seen as doubles.
#include "base/reals.h"

#include "catch.h"

using namespace morula;

TEST_CASE("An array keeps what its precision can hold") {
  Reals wide, narrow(Precision::binary32);
  for (Reals* a : {&wide, &narrow}) {
    a->assign(10, 0.5);
    CHECK(a->size() == 10);
    CHECK((*a)[9] == 0.5);
    (*a)[3] = 0.1;
    (*a)[4] += 0.1;
    (*a)[5] = (*a)[3];
  }
  CHECK(wide[3] == 0.1);
  CHECK(narrow[3] == double(0.1f));
  CHECK(wide[4] == 0.5 + 0.1);
  CHECK(narrow[4] == double(float(0.5 + 0.1)));
  CHECK(narrow[5] == narrow[3]);
  CHECK_FALSE(wide == narrow);
}

TEST_CASE("Kernels get the numbers as they lie in memory") {
  Reals wide, narrow(Precision::binary32);
  wide.assign(40, 0);
  narrow.assign(40, 0);
  wide[17] = 0.3, narrow[17] = 0.3;
  const double* d = wide.from(16);
  const float* f = narrow.from(16);
  CHECK(d[1] == 0.3);
  CHECK(f[1] == 0.3f);
  Reals copy = narrow;
  CHECK(copy == narrow);
  float* written = copy.from(0);
  written[2] = 7;
  CHECK(copy[2] == 7);
  CHECK(narrow[2] == 0);
}
