#pragma once
// One description per key of a study file feeds the reader, the schema for editors and the list for people.
#include <functional>
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
  std::string absent;   // for people: what holds without it; "": it is required
  Json schema;
  std::function<void(Study&, const scenario::Node&, scenario::Problems&)> read;
};

/// In the order in which people should meet them. `keep` and `limits` are maps; what is in them stands behind them.
const std::vector<Key>& keys();

/// Fills the study from the document. Everything the table does not allow becomes a problem.
void readKeys(const scenario::Node& root, Study& study, scenario::Problems& problems);

// Keys whose values have a form of their own.
Key baseKey();
Key varyKey();
Key seedsKey();
Key measuresKey();
Key checkKey();

/// Says that a text is none of these names, and which of them may be meant.
void refuseWord(const scenario::Node& node, const std::string& path, const std::vector<std::string>& names,
                const std::string& allowed, scenario::Problems& problems);

/// Returns the schema of a map with these keys alone.
Json objectSchema(Json properties, Json required);

/// Fills the study's claims from `check`; its axes and measures must have been read.
void readClaims(const scenario::Node& root, Study& study, scenario::Problems& problems);

/// Letters, digits and . _ + -, a letter or digit first, at most 50: names of axes (no '.' or '+') and labels.
bool isLabel(const std::string& text);
inline constexpr const char* labelNeeds =
    "needs letters, digits and . _ + -, a letter or digit first, at most 50 of them";

/// A value of a study file as one line of YAML's flow notation that scenario::readYamlValue reads as the same: how an
/// override holds it. A text without quotes gets none where it reads back as the same without them, so that numbers
/// stay numbers. "null" for an empty value.
std::string overrideText(const scenario::Node& node);

/// Two axes that set the same key, or one a part of what the other sets, are a problem: which of them holds would
/// depend on their order. Returns the names of such axes.
std::set<std::string> checkAxes(const Study& study, scenario::Problems& problems);

inline constexpr std::size_t maxConditions = 10'000, maxReplicates = 1'000'000;

}  // namespace morula::study
