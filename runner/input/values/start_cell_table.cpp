// The table of cells that a scenario begins with: `cells: {file: cells.csv}`.
#include <algorithm>
#include <array>
#include <numbers>

#include "base/maths.h"
#include "simulation/start_cells.h"
#include "values/cell_names.h"
#include "values/delimited_text.h"
#include "values/parameter.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

constexpr const char* startColumns = "x, y, z, radius (or volume or scale), vx, vy, vz, mass, name and substances";

class StartCellReader {
 public:
  StartCellReader(std::string_view text, const std::string& file, const Scenario& scenario, Reading& reading)
      : problems_(file), text_(text, problems_), file_(file), scenario_(scenario), reading_(reading) {
    column_.fill(-1);
  }

  /// Returns the cells, and names() of the same number. Throws InputError with all mistakes of the table.
  std::vector<StartCell> read() {
    std::vector<StartCell> cells;
    if (text_.next()) readHeader();
    while (problems_.empty() && text_.next()) cells.push_back(readRow());
    if (cells.empty() && problems_.empty())
      text_.complain({}, "there is no row",
                     std::string("needs a header with columns of ") + startColumns + ", and rows");
    problems_.throwIfAny();
    return cells;
  }

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<int>& lines() const { return lines_; }

 private:
  enum Column { x, y, z, vx, vy, vz, radius, volume, scale, mass, name, substances, columnCount };
  /// [Column] The headers of a column, the best first, as headerWord gives them.
  static inline const std::array<std::vector<std::string>, columnCount> headers{
      {{"x", "positionx", "posx", "xum"},
       {"y", "positiony", "posy", "yum"},
       {"z", "positionz", "posz", "zum"},
       {"vx", "velocityx"},
       {"vy", "velocityy"},
       {"vz", "velocityz"},
       {"radius", "radiusum", "r"},
       {"volume", "volumeum3", "vol"},
       {"scale"},
       {"mass"},
       {"name", "cellname", "cell"},
       {"substances", "substance", "kind", "type", "state"}}};
  static constexpr Range anyPositive{.low = 0, .openLow = true};

  bool has(Column c) const { return column_[c] >= 0; }
  std::string_view field(Column c) const {
    return has(c) ? text_.fields()[static_cast<std::size_t>(column_[c])] : std::string_view();
  }

  void readHeader() {
    headerCount_ = text_.fields().size();
    for (std::size_t i = 0; i < headerCount_; ++i) {
      const std::string_view header = text_.fields()[i];
      const auto column = std::ranges::find_if(
          headers, [&](const auto& words) { return std::ranges::find(words, headerWord(header)) != words.end(); });
      if (column == headers.end()) {
        text_.complain(header, "'" + std::string(header) + "' is no column of start cells",
                       std::string("needs some of ") + startColumns);
        continue;
      }
      int& place = column_[static_cast<std::size_t>(column - headers.begin())];
      if (place >= 0)
        text_.complain(header,
                       "two columns give the same: '" + std::string(text_.fields()[std::size_t(place)]) + "' and '" +
                           std::string(header) + "'",
                       "remove one of the two");
      place = static_cast<int>(i);
    }
    if (has(radius) + has(volume) + has(scale) > 1)
      text_.complain({}, "radius, volume and scale say the same", "keep one of them");
    if (scenario_.scene.mechanics)
      for (const Column c : {x, y, z})
        if (!has(c))
          text_.complain({}, "there is no column " + headers[c][0], "needs x, y and z of the cells' centres");
  }

  double number(Column c, const Range& range, double otherwise) {
    if (!has(c)) return otherwise;
    const std::string_view given = field(c);
    if (given.empty() && c >= radius) return otherwise;
    const auto number = parseReal(given);
    const char* const called = headers[c][0].c_str();
    if (given.empty()) text_.complain({}, std::string("there is no ") + called, "fill it in, or remove the row");
    else if (!number.wrong.empty() || !range.holds(number.value))
      text_.complain(given, "'" + std::string(given) + "' is no " + called,
                     range.openLow ? "needs a number > 0" : "needs a number, with a point as decimal sign");
    else return number.value;
    return otherwise;
  }

  StartCell readRow() {
    StartCell cell;
    lines_.push_back(text_.line());
    names_.emplace_back();
    if (text_.fields().size() != headerCount_) {
      text_.complain({},
                     "the row has " + std::to_string(text_.fields().size()) + " fields" + ", and the header " +
                         std::to_string(headerCount_),
                     "give a field for each column, empty if unknown");
      return cell;
    }
    cell.at = {number(x, {}, 0), number(y, {}, 0), number(z, {}, 0)};
    cell.velocity = {number(vx, {}, 0), number(vy, {}, 0), number(vz, {}, 0)};
    cell.scale = number(scale, anyPositive, 1);
    if (const auto& mechanics = scenario_.scene.mechanics) {
      const double egg = mechanics->physics.cell.radius;
      if (has(radius)) cell.scale = number(radius, anyPositive, egg) / egg;
      if (!field(volume).empty())
        cell.scale = cubeRoot(number(volume, anyPositive, 1) / (4.0 / 3 * std::numbers::pi)) / egg;
    }
    if (!field(mass).empty()) cell.mass = number(mass, anyPositive, 1);
    if (has(substances)) cell.substances = substancesOf(field(substances));
    if (const std::string_view given = field(name); !given.empty()) {
      if (isCellName(given)) names_.back() = given;
      else
        text_.complain(given, "'" + std::string(given) + "' is no name of a cell", std::string("needs ") + nameAllowed);
    }
    return cell;
  }

  /// Splits the substances of a cell, which blanks, '+' or '|' separate.
  std::optional<std::vector<std::string>> substancesOf(std::string_view text) {
    std::vector<std::string> all;
    for (std::size_t end; !text.empty(); text.remove_prefix(std::min(text.size(), end + 1))) {
      end = std::min(text.find_first_of(" +|"), text.size());
      if (end > 0) all.emplace_back(text.substr(0, end));
    }
    if (all.empty()) return {};
    std::ranges::sort(all);
    if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
      text_.complain(field(substances), "'" + *twice + "' is given twice", "keep one");
    const Place place{1, 1, file_ + ":" + std::to_string(text_.line())};
    for (const std::string& s : all) reading_.substances.push_back({s, place, "cells." + s});
    return all;
  }

  Problems problems_;
  DelimitedText text_;
  std::string file_;
  const Scenario& scenario_;
  Reading& reading_;
  std::array<int, columnCount> column_{};
  std::size_t headerCount_ = 0;
  std::vector<std::string> names_;
  std::vector<int> lines_;
};

}  // namespace

void readStartCellTable(const std::string& text, const std::string& file, const Place& place, Scenario& scenario,
                        Reading& reading) {
  StartCellReader table(text, file, scenario, reading);
  scenario.scene.cells = table.read();
  const std::vector<CellPath> paths = founderPaths(scenario.scene.cells.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::string line = file + ":" + std::to_string(table.lines()[i]);
    reading.startCells.push_back({1, 1, line});
    if (!table.names()[i].empty()) nameCell({paths[i], place, "cells.file", line}, table.names()[i], scenario, reading);
  }
}

}  // namespace morula::scenario
