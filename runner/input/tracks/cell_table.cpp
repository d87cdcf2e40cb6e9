#include "tracks/cell_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "files/text.h"
#include "tracks/wording.h"
#include "values/delimited_text.h"
#include "yaml/numbers.h"

namespace morula::tracks {
namespace {

/// In the order of TableReader::Column, the headers by which trackers call a column, the best first: in small letters, without anything but letters and
/// digits, and without a unit in brackets. A header serves one column, and a column takes one header.
const std::array<std::vector<std::string_view>, 18> headers{{
    {"trackid", "track", "cellid", "cell", "id", "label", "particle"},
    {"parenttrackid", "parentid", "parent", "motherid", "mother", "parenttrack", "parentcell", "mothercell"},
    {"name", "cellname", "trackname", "cell"},
    {"t", "time", "frame", "positiont", "timepoint", "frameid"},
    {"birth", "born", "birthtime", "birthframe", "begin", "start"},
    {"division", "divisiontime", "divisionframe", "end", "ended", "death", "deathtime", "endtime"},
    {"x", "positionx", "posx", "xum", "centroid2"},
    {"y", "positiony", "posy", "yum", "centroid1"},
    {"z", "positionz", "posz", "zum", "centroid0"},
    {"axisx"},
    {"axisy"},
    {"axisz"},
    {"volume", "volumeum3", "vol"},
    {"radius", "radiusum"},
    {"fate"},
    {"path", "cellpath", "lineagepath"},
    {"cells", "stage", "cellcount", "ncells"},
    {"contacts"},
}};

const scenario::Range usable{.low = -1e30, .high = 1e30}, size{.low = 1e-30, .high = 1e30};

constexpr std::uint64_t maxCells = 1'000'000;

bool isNumber(std::string_view text) { return scenario::parseReal(text).wrong.empty(); }

class TableReader {
 public:
  TableReader(std::string_view text, scenario::Problems& problems, const TableOptions& options)
      : text_(text, problems), problems_(problems), options_(options) {
    column_.fill(-1);
  }

  CellTable read() {
    bool hasHeader = false;
    while (text_.next()) {
      if (hasHeader) readRow();
      else if (!problems_.empty() || !readHeader())  // a problem: the line of headers could not be read
        return std::move(table_);
      else if (table_.form == Form::manTrack) readRow();
      hasHeader = true;
    }
    if (table_.rows.empty() && problems_.empty())
      text_.complain({}, hasHeader ? "there is no row below the header" : "the file is empty",
                     options_.mayBeStages ? "needs a header such as cells,name,x,y,z, and rows"
                                          : "needs a header such as track_id,t,z,y,x,parent_track_id, and rows");
    table_.unquoted = text_.takeUnquoted();
    return std::move(table_);
  }

 private:
  enum Column {
    cell,
    parent,
    name,
    time,
    birth,
    end,
    x,
    y,
    z,
    axisX,
    axisY,
    axisZ,
    volume,
    radius,
    fate,
    path,
    stage,
    contacts,
    columnCount
  };

  const std::vector<std::string_view>& fields() const { return text_.fields(); }
  std::string_view field(int at) const { return fields()[static_cast<std::size_t>(at)]; }

  int knownColumns() const { return options_.mayBeStages ? columnCount : stage; }

  bool readHeader() {
    if (isNumber(fields()[0])) {
      table_.form = Form::manTrack;
      column_[cell] = 0, column_[birth] = 1, column_[end] = 2, column_[parent] = 3;
      headerCount_ = 4;
      if (text_.separator() != ' ' || fields().size() != 4)
        text_.complain({}, "there is no header",
                       "name the columns in the first line, as track_id,t,z,y,x,parent_track_id");
      return problems_.empty();
    }
    headerCount_ = fields().size();
    std::vector<std::string> words;
    for (const auto field : fields()) words.push_back(scenario::headerWord(field));
    std::vector<bool> isUsed(words.size(), false);
    for (const auto& [name, header] : options_.columns) takeNamed(name, header, isUsed);
    if (!problems_.empty()) return false;  // what else is missing may follow from a header that was given wrong
    for (int c = 0; c < knownColumns(); ++c)
      for (const auto& header : headers[static_cast<std::size_t>(c)]) {
        const auto found = std::ranges::find(words, header);
        const auto at = static_cast<std::size_t>(found - words.begin());
        if (found == words.end() || isUsed[at] || column_[static_cast<std::size_t>(c)] >= 0) continue;
        column_[static_cast<std::size_t>(c)] = static_cast<int>(at);
        isUsed[at] = true;
        if (std::find(found + 1, words.end(), header) != words.end())
          text_.complain(fields()[at], "two columns are called " + inQuotes(fields()[at]), "rename or remove one");
      }
    findStages(words, isUsed);
    for (std::size_t i = 0; i < words.size(); ++i)
      if (!isUsed[i]) table_.ignored.emplace_back(fields()[i]);
    return requireColumns();
  }

  /// Finds the columns x_8, y_8 and z_8 of places while eight cells live.
  void findStages(const std::vector<std::string>& words, std::vector<bool>& isUsed) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto axis = std::string_view("xyz").find(words[i].empty() ? ' ' : words[i][0]);
      const auto cells = scenario::parseNatural(words[i].empty() ? words[i] : words[i].substr(1));
      if (axis == std::string_view::npos || !cells.wrong.empty() || cells.value < 1 || cells.value > maxCells) continue;
      int& column = stages_.try_emplace(static_cast<int>(cells.value), std::array{-1, -1, -1}).first->second[axis];
      if (column >= 0)
        text_.complain(fields()[i], "two columns are called " + inQuotes(fields()[i]), "rename or remove one");
      column = static_cast<int>(i), isUsed[i] = true;
    }
  }

  std::string headerInWords() const {
    std::vector<std::string> has;
    for (const auto field : fields()) has.push_back(inQuotes(field));
    return "the header has " + join(has);
  }

  /// Takes a column whose header the user has given.
  void takeNamed(const std::string& name, const std::string& header, std::vector<bool>& isUsed) {
    const auto found = std::ranges::find(fields(), std::string_view(header));
    const auto column = std::ranges::find_if(headers, [word = scenario::headerWord(name)](const auto& words) {
      return std::ranges::find(words, std::string_view(word)) != words.end();
    });
    if (column == headers.end() || column - headers.begin() >= knownColumns())
      problems_.add({1, 1, "--columns"}, "", inQuotes(name) + " is no column that a table can have",
                    options_.mayBeStages
                        ? "needs one of cells, time, name, path, contacts, x, y, z, track_id and parent"
                        : "needs one of track_id, parent, name, path, t, birth, division, x, y, z, axis_x, axis_y, "
                          "axis_z, volume, radius and fate");
    else if (found == fields().end())
      problems_.add({1, 1, "--columns"}, "", "there is no column " + inQuotes(header), headerInWords());
    else {
      const auto at = static_cast<std::size_t>(found - fields().begin());
      column_[static_cast<std::size_t>(column - headers.begin())] = static_cast<int>(at);
      isUsed[at] = true;
    }
  }

  void require(Column column, const std::string& names) {
    if (column_[column] >= 0) return;
    text_.complain(
        {}, "there is no column " + names + "; " + headerInWords(),
        table_.form == Form::stages
            ? "name the columns as cells or time, name or path, x, y, z; or give their headers with --columns "
              "x=HEADER,y=HEADER"
            : "name the columns as track_id, t, z, y, x, parent_track_id, or as cell, parent, birth, "
              "division; or give their headers with --columns parent=HEADER,x=HEADER");
  }

  bool requireStages() {
    table_.form = Form::stages;
    if (column_[stage] >= 0 && column_[time] >= 0)
      text_.complain({},
                     "there is " + inQuotes(field(column_[stage])) + ", a number of cells, and " +
                         inQuotes(field(column_[time])) + ", a time",
                     "remove one of the two: it says when the rows are compared");
    if (column_[time] < 0) require(stage, "cells or time, which says when the rows are compared");
    table_.arePaths = column_[path] >= 0;
    if (column_[path] < 0) column_[path] = column_[name] >= 0 ? column_[name] : column_[cell];
    require(path, "name, cell or path");
    column_[cell] = column_[path];
    require(x, "x or POSITION_X"), require(y, "y or POSITION_Y"), require(z, "z or POSITION_Z");
    return problems_.empty();
  }

  bool requireColumns() {
    const bool hasTimes = column_[birth] >= 0 || column_[end] >= 0;
    if (options_.mayBeStages && (column_[stage] >= 0 || (column_[parent] < 0 && !hasTimes))) return requireStages();
    if (column_[time] >= 0 && hasTimes)
      text_.complain({},
                     "there is " + inQuotes(field(column_[time])) + " as in a table with a row per frame, and " +
                         inQuotes(field(std::max(column_[birth], column_[end]))) + " as in a table with a row per cell",
                     "remove one of the two");
    table_.form = column_[time] >= 0 ? Form::frames : Form::cells;
    if (column_[cell] < 0) column_[cell] = column_[name];
    require(cell, "track_id, cell, id or name");
    if (!hasTimes) require(time, "t, as a row per frame has, nor birth or division, as a row per cell has");
    require(parent, "parent_track_id, parent or mother");
    const bool hasPlaces = column_[x] >= 0 || column_[y] >= 0 || column_[z] >= 0;
    if (table_.form == Form::frames || hasPlaces) require(x, "x or POSITION_X"), require(y, "y or POSITION_Y");
    const bool hasAxis = column_[axisX] >= 0 || column_[axisY] >= 0 || column_[axisZ] >= 0;
    if (hasAxis) require(axisX, "axis_x"), require(axisY, "axis_y"), require(axisZ, "axis_z");
    for (const auto& [cells, columns] : stages_)
      if (table_.form == Form::frames || hasPlaces)
        text_.complain({},
                       "there are columns of places, and others of places among " + std::to_string(cells) + " cells",
                       "keep x, y and z, or x_N, y_N and z_N in a table with a row per cell");
      else if (std::ranges::find(columns, -1) != columns.end())
        text_.complain({}, "of the columns of places among " + std::to_string(cells) + " cells one is absent",
                       "name all of them, as x_" + std::to_string(cells) + ", y_" + std::to_string(cells) + ", z_" +
                           std::to_string(cells));
    table_.isFlat = column_[x] >= 0 && column_[z] < 0;
    return problems_.empty();
  }

  std::string_view fieldOf(Column column) const {
    return column_[column] < 0 ? std::string_view() : field(column_[column]);
  }

  /// Reads a number, which may be absent unless `must`.
  double number(Column column, bool must, const scenario::Range& range = usable) {
    return column_[column] < 0 ? unsaid : number(fieldOf(column), std::string(headers[column].front()), must, range);
  }

  double number(std::string_view field, const std::string& called, bool must, const scenario::Range& range) {
    if (field.empty() || (!must && isUnknown(field))) {
      if (must) text_.complain({}, "there is no " + called, "fill it in, or remove the row");
      return unsaid;
    }
    const auto [value, wrong] = scenario::parseReal(field);
    if (!wrong.empty())
      text_.complain(
          field, inQuotes(field) + " " + wrong,
          must ? "needs a number such as 1.5" : "needs a number such as 1.5, or nothing where it is not known", called);
    else if (!range.holds(value))
      text_.complain(field, inQuotes(field) + (&range == &size ? " is no size" : " is no usable number"),
                     "needs a number " + range.text(), called);
    else return value;
    return unsaid;
  }

  Vector vector(Column first, bool must) {
    const auto part = [&](int i) { return number(static_cast<Column>(first + i), must); };
    return {part(0), part(1), part(2)};
  }

  void readRow() {
    if (fields().size() != headerCount_)
      return text_.complain(
          {}, "has " + std::to_string(fields().size()) + " fields where the header has " + std::to_string(headerCount_),
          "fill in or remove fields; decimals follow a point, and a name with a separator stands in quotes");
    const bool isFrame = table_.form == Form::frames || table_.form == Form::stages;
    Row row{text_.line(), fieldOf(cell), fieldOf(parent), fieldOf(name), fieldOf(path)};
    if (row.cell.empty() && !table_.arePaths)
      text_.complain({}, "the row names no cell", "fill in its track_id or cell");
    row.time = number(time, true);
    if (column_[stage] >= 0) readStage(row);
    row.contacts = fieldOf(contacts);
    row.birth = number(birth, table_.form == Form::manTrack), row.end = number(end, table_.form == Form::manTrack);
    row.place = vector(x, isFrame);
    if (table_.isFlat && row.place.x == row.place.x) row.place.z = 0;
    for (const auto& [cells, columns] : stages_) {
      double at[3];
      for (std::size_t i = 0; i < 3; ++i)
        at[i] = number(field(columns[i]), "xyz"[i] + ("_" + std::to_string(cells)), false, usable);
      row.placesAmong.emplace_back(cells, Point{at[0], at[1], at[2]});
    }
    row.axis = vector(axisX, false);
    row.volume = number(volume, false, size);
    const double r = number(radius, false, size);
    if (row.volume != row.volume) row.volume = 4 * std::numbers::pi / 3 * r * r * r;
    readFate(row);
    table_.rows.push_back(row);
  }

  void readStage(Row& row) {
    const auto [value, wrong] = scenario::parseReal(fieldOf(stage));
    if (wrong.empty() && value >= 1 && value < 1e9 && value == std::floor(value)) row.stage = static_cast<int>(value);
    else
      text_.complain(fieldOf(stage), inQuotes(fieldOf(stage)) + " is no number of cells",
                     "needs a whole number such as 8", "cells");
  }

  void readFate(Row& row) {
    const std::string word = scenario::headerWord(fieldOf(fate));
    const auto isOneOf = [&](std::initializer_list<std::string_view> words) {
      return std::ranges::find(words, word) != words.end();
    };
    row.dies = isOneOf({"dies", "died", "die", "death", "dead", "apoptosis"});
    if (!row.dies && !isOneOf({"", "na", "divides", "divided", "division", "lives", "alive", "end"}))
      text_.complain(fieldOf(fate), inQuotes(fieldOf(fate)) + " is no fate", "needs divides, dies or lives, or nothing",
                     "fate");
  }

  scenario::DelimitedText text_;
  scenario::Problems& problems_;
  const TableOptions& options_;
  CellTable table_;
  std::array<int, columnCount> column_;       // among the fields of a row; -1: there is none
  std::map<int, std::array<int, 3>> stages_;  // columns of places, by the number of cells; -1: there is none
  std::size_t headerCount_ = 0;
};

}  // namespace

CellTable readCellTable(std::string_view text, scenario::Problems& problems, const TableOptions& options) {
  return TableReader(text, problems, options).read();
}

}  // namespace morula::tracks
