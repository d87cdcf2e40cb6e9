#pragma once
// A YAML document as a tree of places and uninterpreted text. What the text means is decided by the
// code that reads the tree, not by YAML: to yaml-cpp 010 is 8 and yes is true.
#include <string>
#include <vector>

#include "yaml/problems.h"
#include "yaml/source_text.h"

namespace morula::scenario {

struct Member;

struct Node {
  enum class Kind {
    null,  // nothing, ~ or null
    scalar,
    sequence,
    map,
    broken,  // a problem has been reported; say no more about it
  };
  Kind kind = Kind::null;
  Place place;
  std::string text;    // text of a scalar
  char style = ' ';    // style of a scalar: ' ' plain, '"', '\'', '|' or '>' as written
  int textColumn = 1;  // column at which the lines of a '|' scalar begin
  std::vector<Node> items;
  std::vector<Member> members;

  bool isPlain() const { return kind == Kind::scalar && style == ' '; }
  const Member* find(std::string_view key) const;
};

struct Member {
  std::string key;
  Place place;
  Node value;
};

/// Reads exactly one document. Problems are syntax errors, anchors, tags, merge keys, further documents, and keys that
/// are no text or occur twice. After a syntax error the node is broken.
Node readYaml(const SourceText& source, Problems& problems);

/// Reads the value of an override: YAML's flow notation after [ { " or ', anything else as plain text.
Node readYamlValue(const std::string& value, const std::string& option, Problems& problems);

/// Puts `value` at `path` ("physics.time_step"), and makes the maps that are missing on the way. In a list the path goes
/// by the name of an entry, the text under its `of` or `name`: "division.rules.EMS.share". Returns "", or the path of a
/// list that has no such entry or several, and is left as it is.
std::string assign(Node& root, const std::string& path, Node value);

/// Removes the value or the entry of a list at `path`. Returns false if there is none.
bool remove(Node& root, const std::string& path);

/// Sets the place of a node, and of all nodes in it, to an option.
void relocate(Node& node, const std::string& option);

/// Returns "a map", "a list", "nothing", or the text in quotes, for messages.
std::string describe(const Node& node);

}  // namespace morula::scenario
