#pragma once
// Names of an organism's cells. They are presentation alone: the simulator knows lineage paths, and no result depends
// on a name.
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/cell_path.h"

namespace morula {

/// A function that returns a cell's name by its path; absent: the cell has none.
using NameOf = std::function<std::optional<std::string>(const CellPath&)>;

struct CellNames {
  std::map<CellPath, std::string> given;  // by path; the egg's included
  std::vector<std::string> daughters;     // endings that daughters A and B add to their mother's name; or none

  bool empty() const { return given.empty() && daughters.empty(); }

  /// Returns the name that is given for the path, or else the mother's with the daughter's ending. Absent if no rule
  /// gives a name.
  std::optional<std::string> of(const CellPath& path) const;

  /// Returns the cells with this name, by path: at most one in a scenario that was read without problems.
  std::vector<CellPath> find(std::string_view name) const;

  NameOf function() const;
};

/// Returns the cell that a text means: the one with this name, or else with this path. "cell AB" is always the name;
/// "path AB" and "/AB" are always the path; "/" and "egg" are the egg. Otherwise throws InputError, which begins with `where` ("--cell"; may be empty) and
/// suggests a name.
CellPath cellCalled(const CellNames& names, std::string_view text, std::string_view where);

/// Returns "ABa (path AAB)", or for a cell without a name the words of base/cell_path.h: "cell AAB".
std::string cellWords(const NameOf& nameOf, const CellPath& path);

/// Returns a message with "ABa (path AAB)" for each "cell AAB" in it that has a name.
std::string withNames(std::string_view message, const NameOf& nameOf);

/// Returns true if a text may be the name of a cell: 1 to 40 characters, none of them a blank or a control character,
/// the first none of / = + - @. `nameAllowed` says so in words.
bool isCellName(std::string_view text);
extern const char* const nameAllowed;

}  // namespace morula
