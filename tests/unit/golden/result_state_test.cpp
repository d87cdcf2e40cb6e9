// The list of states: exit codes are equal to the table in golden/README.md, the worst state decides, and limits allow
// failed and insane results alone.
#include "golden/result_state.h"

#include <algorithm>

#include "catch.h"
#include "files/read_file.h"

using namespace morula;

namespace {

/// Returns the cells of the README's row for a state, without blanks around them.
std::vector<std::string> rowOf(const std::string& state) {
  const std::string text = readFile(MORULA_SOURCE_DIR "/golden/README.md"), begin = "\n| " + state + " |";
  const auto at = text.find(begin);
  if (at == text.npos) return {};
  const std::string row = text.substr(at + 2, text.find('\n', at + 1) - at - 2);
  std::vector<std::string> cells;
  for (std::size_t from = 0, to; (to = row.find('|', from)) != row.npos; from = to + 1) {
    const std::string cell = row.substr(from, to - from);
    const auto first = cell.find_first_not_of(' ');
    cells.push_back(first == cell.npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return cells;
}

}  // namespace

TEST_CASE("golden/README.md has every state with its meaning and its exit codes") {
  for (const auto& [state, word, meaning] : choices<ResultState>) {
    INFO(word);
    const auto cells = rowOf(word);
    REQUIRE(cells.size() == 5);
    CHECK(cells[1].starts_with(meaning));
    const std::string code = std::to_string(exitCodeOf(state));
    for (const std::string& column : {cells[3], cells[4]}) CHECK((column.empty() || column == code));
    CHECK_FALSE((cells[3].empty() && cells[4].empty()));
    // A run ended by a signal has the signal's code.
    if (!cells[2].empty() && state != ResultState::unfinished) CHECK(cells[2] == std::to_string(exitCodeOfRun(state)));
  }
}

TEST_CASE("the worst state decides, and limits allow failed and insane results alone") {
  for (const auto& a : choices<ResultState>)
    for (const auto& b : choices<ResultState>) {
      StateCounts counts;
      counts.add(ResultState::fine, 3);
      counts.add(a.value), counts.add(b.value);
      CHECK(counts.worst() == std::max({ResultState::fine, a.value, b.value}));
      const bool isAllowed = a.value == ResultState::failed || a.value == ResultState::insane;
      if (a.value != b.value) continue;
      CHECK(counts.worst({2, 2}) == (isAllowed ? ResultState::fine : a.value));
      CHECK(counts.worst({1, 1}) == a.value);
    }
}
