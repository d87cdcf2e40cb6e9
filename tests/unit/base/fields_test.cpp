#include "base/fields.h"

#include <bit>
#include <cmath>
#include <limits>

#include "catch.h"

using namespace morula;

namespace {

const std::vector<std::uint64_t> numbers{0, 1, ~std::uint64_t{0}};
const std::vector<double> reals{0., -0., 1. / 3, INFINITY, -INFINITY, std::numeric_limits<double>::denorm_min(), 1e308};
const std::vector<std::string> texts{"", "a b", std::string("\0\xff", 2)};

std::string written() {
  FieldWriter out;
  out.add("numbers", numbers);
  out.add("reals", reals);
  out.add("texts", texts);
  out.add("nothing", std::vector<double>{});
  return out.bytes();
}

void readAll(std::string_view bytes) {
  FieldReader in(bytes, "test");
  in.numbers("numbers");
  in.reals("reals");
  in.texts("texts");
  in.reals("nothing");
  in.end();
}

}  // namespace

TEST_CASE("Fields come back bit for bit, signs of zeros and infinities included") {
  const std::string bytes = written();
  FieldReader in(bytes, "test");
  CHECK(in.numbers("numbers") == numbers);
  const std::vector<double> back = in.reals("reals");
  REQUIRE(back.size() == reals.size());
  for (std::size_t i = 0; i < reals.size(); ++i)
    CHECK(std::bit_cast<std::uint64_t>(back[i]) == std::bit_cast<std::uint64_t>(reals[i]));
  CHECK(in.texts("texts") == texts);
  CHECK(in.reals("nothing").empty());
  CHECK_NOTHROW(in.end());
}

TEST_CASE("Floats take half the room and come back exactly") {
  const std::vector<double> floats{0.1f, -0.f, 3e38f};
  FieldWriter wide, narrow;
  wide.add("x", floats);
  narrow.add("x", floats, Precision::binary32);
  CHECK(wide.bytes().size() - narrow.bytes().size() == 4 * floats.size());
  CHECK(FieldReader(narrow.bytes(), "test").reals("x") == floats);
}

TEST_CASE("What is not there as expected is refused by name") {
  const std::string bytes = written();
  CHECK_THROWS_WITH(FieldReader(bytes, "test").numbers("other"),
                    ContainsSubstring("test: the field 'other' is missing"));
  CHECK_THROWS_WITH(FieldReader(bytes, "test").reals("numbers"),
                    ContainsSubstring("'numbers' holds values of another kind"));
  CHECK_THROWS_WITH(FieldReader(bytes, "test").end(), ContainsSubstring("follow its last field"));
  CHECK_THROWS_WITH(FieldReader("", "test").numbers("numbers"), ContainsSubstring("'numbers' is missing"));
}

TEST_CASE("Cut short at any length, fields are refused") {
  const std::string bytes = written();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    CHECK_THROWS_AS(readAll(std::string_view(bytes).substr(0, length)), InputError);
  CHECK_NOTHROW(readAll(bytes));
}

TEST_CASE("NaN is neither written nor read") {
  FieldWriter out;
  CHECK_THROWS_AS(out.add("x", std::vector<double>{std::nan("")}), BugError);
  out.add("x", std::vector<double>{1.0});
  std::string bytes = out.bytes();
  bytes[bytes.size() - 1] = '\x7f';
  bytes[bytes.size() - 2] = '\xff';
  CHECK_THROWS_WITH(FieldReader(bytes, "test").reals("x"), ContainsSubstring("'x' holds what is not a number"));
}

TEST_CASE("A count beyond the end takes no memory") {
  FieldWriter out;
  out.add("x", std::vector<double>{1.0});
  std::string bytes = out.bytes();
  bytes[8 + 1 + 1 + 7] = '\x7f';  // the count's highest byte
  CHECK_THROWS_WITH(FieldReader(bytes, "test").reals("x"), ContainsSubstring("more values than there are bytes"));
}
