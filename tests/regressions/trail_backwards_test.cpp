// trail --from 10 --to 5 read before the beginning of an array. It is a usage error.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("trail: an interval that ends before it begins is refused") {
  const auto run = launch({"trail", "scenarios/thesis/unique-four.yaml", "--from", "10", "--to", "5"});
  CAPTURE(run.err);
  CHECK(run.code == 2);
  CHECK(run.out.empty());
  CHECK(run.err.find("--from") != std::string::npos);
}
