#pragma once
// One description of each key of a study file, for the reader, the schema for editors and the list for people.
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/study_file.h"
#include "system/json.h"
#include "yaml/node.h"

namespace morula::study {

struct Key {
  std::string path;     // "keep.hashes"
  std::string allowed;  // for people: "none, end or all"
  std::string meaning;  // one line
  std::string absent;   // for people: what holds if the key is absent; "": the key is required
  Json schema;
  std::function<void(Study&, const scenario::Node&, scenario::Problems&)> read;
};

/// Returns the keys in the order in which people should meet them. Keys in the maps `keep` and `limits` follow them.
const std::vector<Key>& keys();

/// Fills the study from the document. Everything the table does not allow becomes a problem.
void readKeys(const scenario::Node& root, Study& study, scenario::Problems& problems);

// Keys whose values have a form of their own.
Key baseKey();
Key varyKey();
Key seedsKey();
Key measuresKey();
Key leaveOutKey();
Key checkKey();

/// Adds the problem that a text is none of these names, and suggests one.
void refuseWord(const scenario::Node& node, const std::string& path, const std::vector<std::string>& names,
                const std::string& allowed, scenario::Problems& problems);

/// Returns the schema of a map with these keys alone.
Json objectSchema(Json properties, Json required);

/// Returns the remedy for a word that is none of `known`: the nearest of them, or all.
std::string nearOf(const std::string& word, const std::vector<std::string>& known);

/// Returns the axis that a member of a map {AXIS: LABEL} names. Adds a problem if there is none.
std::optional<std::size_t> axisNamed(const Study& study, const scenario::Member& member, const std::string& path,
                                     scenario::Problems& problems);
/// Returns the level that a label names. Adds a problem if there is none.
std::optional<std::size_t> levelNamed(const StudyAxis& axis, const scenario::Node& label, const std::string& path,
                                      scenario::Problems& problems);

/// Fills the study's combinations that are left out from `leave-out`; its axes must have been read.
void readLeftOut(const scenario::Node& root, Study& study, scenario::Problems& problems);

/// Fills the study's claims from `check`; its axes and measures must have been read.
void readClaims(const scenario::Node& root, Study& study, scenario::Problems& problems);

/// Returns true for a name of an axis (without '.' and '+') or a label: letters, digits and . _ + -, at most 50, the
/// first a letter or digit.
bool isLabel(const std::string& text);
inline constexpr const char* labelNeeds =
    "needs letters, digits and . _ + -, a letter or digit first, at most 50 of them";

/// Writes a value of a study file as one line of YAML's flow notation, from which scenario::readYamlValue reads an
/// equal value: the form of overrides. A text without quotes gets none if it reads back unchanged, so that numbers stay
/// numbers. An empty value is "null".
std::string overrideText(const scenario::Node& node);

/// Reports pairs of axes that set one key, or of which one sets a part of the other's key: results would depend on
/// their order. Returns the names of such axes.
std::set<std::string> checkAxes(const Study& study, scenario::Problems& problems);

inline constexpr std::size_t maxConditions = 10'000, maxReplicates = 1'000'000;

}  // namespace morula::study
