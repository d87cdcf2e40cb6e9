#include "base/cell_path.h"

#include "base/error.h"

namespace morula {

CellPath CellPath::parse(std::string_view text) {
  CellPath path;
  for (char c : text) {
    if (c != 'A' && c != 'B')
      throw InputError("cell path \"" + std::string(text) + "\": only the letters A and B name daughters");
    path = path.daughter(c == 'B');
  }
  return path;
}

CellPath CellPath::daughter(bool b) const {
  if (depth_ == maxDepth) throw InputError(cellName(text()) + ": a line of descent may hold at most 120 divisions");
  CellPath d = *this;
  if (b) (depth_ < 64 ? d.high_ : d.low_) |= std::uint64_t{1} << (depth_ < 64 ? 63 - depth_ : 127 - depth_);
  ++d.depth_;
  return d;
}

CellPath CellPath::mother() const {
  MORULA_CHECK(depth_ > 0, "the egg has no mother");
  CellPath m = *this;
  --m.depth_;
  (m.depth_ < 64 ? m.high_ : m.low_) &= ~(std::uint64_t{1} << (m.depth_ < 64 ? 63 - m.depth_ : 127 - m.depth_));
  return m;
}

bool CellPath::isAncestorOf(const CellPath& other) const {
  if (other.depth_ < depth_) return false;
  for (int i = 0; i < depth_; ++i)
    if (letter(i) != other.letter(i)) return false;
  return true;
}

std::string CellPath::text() const {
  std::string s(depth_, 'A');
  for (int i = 0; i < depth_; ++i)
    if (letter(i)) s[i] = 'B';
  return s;
}

std::string cellName(std::string_view path) { return path.empty() ? "the egg" : "cell " + std::string(path); }

NumericalError::NumericalError(std::string failed, std::uint64_t at, std::string what, std::string advice, Want missing)
    : std::runtime_error("step " + std::to_string(at) + ", " + cellName(failed) + ": " + what + "; " + advice),
      cell(std::move(failed)),
      step(at),
      quantity(std::move(what)),
      remedy(std::move(advice)),
      want(missing) {}

NumericalError::NumericalError(std::uint64_t at, std::string what, std::string advice, Want missing)
    : std::runtime_error("step " + std::to_string(at) + ": " + what + "; " + advice),
      step(at),
      quantity(std::move(what)),
      remedy(std::move(advice)),
      want(missing) {}

NumericalError::NumericalError(const std::string& told, Want missing) : std::runtime_error(told), want(missing) {}

}  // namespace morula
