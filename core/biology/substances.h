#pragma once
// The substances that mean something to the simulator. All others only make genes active.
#include <array>
#include <string>
#include <string_view>

namespace morula::substance {

// [Nilsson 2008, §4.4.1]. Genes produce `divide` and `die`; the simulator, at a division, gives A to one daughter and B
// to the other. Nothing else makes these two, so a cell that holds A or B has been born and has not run a cycle since.
inline const std::string divide = "divide";
inline const std::string die = "die";
inline const std::string a = "A";
inline const std::string b = "B";

// Ours: the values behind wantsToGrow and wantsToConnect [Nilsson 2008, table 4.1].
inline const std::string grow = "grow";        // wantsToGrow +1
inline const std::string shrink = "shrink";    // wantsToGrow −1; with `grow`: 0
inline const std::string connect = "connect";  // wantsToConnect +1
inline const std::string release = "release";  // wantsToConnect −1; with `connect`: 0

/// Substances that act when a gene produces them.
inline const std::array<std::string, 6> acting = {divide, die, grow, shrink, connect, release};

/// True for the eight substances above. A pattern such as 'A*' means the names of its author, never these: every
/// newborn holds A or B.
inline bool isReserved(std::string_view name) {
  if (name == a || name == b) return true;
  for (const std::string& one : acting)
    if (name == one) return true;
  return false;
}

}  // namespace morula::substance
