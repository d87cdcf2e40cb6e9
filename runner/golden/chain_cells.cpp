#include "golden/chain_cells.h"

#include <algorithm>

#include "base/cell_path.h"
#include "golden/number_text.h"

namespace morula {

namespace {

constexpr std::size_t digits = 4;  // of a cell's hash

/// Who was alive after this step, by lineage path, as the golden's lineage tells.
std::vector<CellPath> aliveAt(const GoldenData& golden, std::uint64_t step) {
  std::vector<CellPath> alive;
  for (const GoldenItem& item : golden.items) {
    if (item.kind != "cell") continue;
    const auto born = readNatural(item.fields[1]), ended = readNatural(item.fields[3]);
    if (born && *born <= step && (!ended || *ended > step))
      alive.push_back(item.key == "egg" ? CellPath{} : CellPath::parse(item.key));
  }
  std::sort(alive.begin(), alive.end());
  return alive;
}

}  // namespace

std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenItem& expected,
                                         const GoldenItem& actual) {
  const std::string &e = expected.fields[1], &a = actual.fields[1];
  const std::vector<CellPath> alive = aliveAt(golden, stepOf(expected).value_or(0));
  std::vector<std::string> cells;
  if (e.size() != a.size() || e.size() != digits * alive.size()) return cells;  // another population
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (e.compare(digits * i, digits, a, digits * i, digits) != 0) cells.push_back(alive[i].text());
  return cells;
}

std::string inWords(const std::vector<std::string>& cells) {
  constexpr std::size_t most = 9;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, cells.size()); ++i)
    text += (i ? ", " : "") + (cells[i].empty() ? "the egg" : cells[i]);
  if (cells.size() > most) text += " and " + std::to_string(cells.size() - most) + " more";
  return text;
}

}  // namespace morula
