// The only file that uses yaml-cpp, and only its events: structure, places and text, which 0.7 and 0.8 report alike.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <deque>
#include <sstream>
#include <unordered_map>

#include "files/printable.h"
#include "yaml/node.h"

namespace morula::scenario {
namespace {

constexpr std::size_t maxDepth = 32;
constexpr std::size_t longestKey = 100;  // [byte] max that messages can show, as for substances

struct TooDeep {};

/// Returns true if no character of the text controls terminals or programs. Line ends and tabs are text: DNA has them.
bool isPlainText(const std::string& text) { return printable(text) == text; }
const char* const notPlainText =
    "holds a control character, one that changes the direction of text, or bytes that are not UTF-8";
const char* const plainTextNeeded = "write it without";

/// The last parameter of OnMapStart, which is EmitterStyle::value up to yaml-cpp 0.8 and EmitterStyle after it.
template <class Style>
Style styleOf(void (YAML::EventHandler::*)(const YAML::Mark&, const std::string&, YAML::anchor_t, Style));
using Style = decltype(styleOf(&YAML::EventHandler::OnMapStart));

/// Builds the tree from events, and keeps the current path for messages.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const SourceText& source, Problems& problems) : source_(source), problems_(problems) {}

  Node root;
  bool garbled = false;  // after a mistake that garbles the rest, only that mistake is reported

  void OnDocumentStart(const YAML::Mark& mark) override {
    open_.clear();
    if (++documents_ == 1) return;
    // An unmatched ']' ends the document for yaml-cpp, which then starts another one at the same ']', without end.
    const auto text = rest(mark);
    if (!text.empty() && std::string_view("]},:?").find(text[0]) != text.npos)
      problems_.add(place(mark), "", "not YAML: '" + std::string(1, text[0]) + "' out of place",
                    "check the '[ ]' and '{ }'");
    else problems_.add(place(mark), "", "a second document", "one file is one scenario: remove '---' and what follows");
    garbled = true;
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { put(node(Node::Kind::null, mark, "", anchor)); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    problems_.add(place(mark), path(), "an alias", "write the value itself, without '*'");
    put(node(Node::Kind::broken, mark, "", 0));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    auto scalar = node(Node::Kind::scalar, mark, tag, anchor);
    scalar.text = value;
    if (tag == "!") {  // not plain: the character at the mark tells how it is written
      const auto written = rest(mark);
      scalar.style = written.empty() ? '"' : written[0];
      if (scalar.style == '|') scalar.textColumn = blockColumn(mark.line + 2);
      if (!isClosed(written)) {
        problems_.add(scalar.place, path(), "the quote is not closed in its line",
                      "close it; for a text of several lines write '|'");
        garbled = true;
      }
    }
    // Escapes such as "\x00" and "\e" are found here; SourceText checks the bytes of the file itself.
    if (!isPlainText(value)) {
      problems_.add(scalar.place, path(), "'" + printableLine(value) + "' " + notPlainText, plainTextNeeded);
      scalar.kind = Node::Kind::broken;
    }
    put(std::move(scalar));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Style) override {
    open(put(node(Node::Kind::sequence, mark, tag, anchor)));
  }
  void OnSequenceEnd() override { open_.pop_back(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Style) override {
    open(put(node(Node::Kind::map, mark, tag, anchor)));
  }
  void OnMapEnd() override { open_.pop_back(); }

  /// Returns the line from the mark on.
  std::string_view rest(const YAML::Mark& mark) const {
    const auto line = source_.line(mark.line + 1);
    return line.substr(std::min<std::size_t>(mark.column, line.size()));
  }
  Place place(const YAML::Mark& mark) const { return source_.place(mark.line + 1, mark.column); }

 private:
  struct Open {
    Node* node;           // a map or list that is being filled; its address is valid until it is closed
    bool hasKey = false;  // in a map: the last member waits for its value
    std::string key{};    // key of the member whose value is awaited or open
    std::unordered_map<std::string, int> lines{};  // lines of the map's keys so far
  };

  std::string path() const {
    std::string text;
    for (const auto& frame : open_)
      if (!frame.key.empty() && (frame.hasKey || &frame != &open_.back()))
        text += (text.empty() ? "" : ".") + frame.key;
    return text;
  }

  /// Returns false if the text begins with a quote that it does not close. yaml-cpp would read on, even to the end.
  static bool isClosed(std::string_view text) {
    if (text.empty() || (text[0] != '"' && text[0] != '\'')) return true;
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (text[i] == text[0]) return true;  // or a doubled ', whose second half closes just as well
      if (text[0] == '"' && text[i] == '\\') ++i;
    }
    return false;
  }

  /// Returns the column at which the lines of a block scalar begin, whose first line is `line`.
  int blockColumn(int line) const {
    while (source_.line(line).find_first_not_of(' ') == std::string_view::npos && source_.hasLine(line)) ++line;
    return static_cast<int>(std::min(source_.line(line).find_first_not_of(' '), source_.line(line).size())) + 1;
  }

  Node node(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    Node made;
    made.kind = kind;
    made.place = place(mark);
    if (anchor != 0) problems_.add(made.place, path(), "an anchor", "write values where they belong, without '&'");
    if (!tag.empty() && tag != "?" && tag != "!")
      problems_.add(made.place, path(), "a tag", "the key decides the type: write the value without '!'");
    return made;
  }

  void open(Node* node) {
    if (open_.size() == maxDepth) {
      problems_.add(node->place, "", "maps and lists are nested more than 32 deep", "a scenario needs 4 levels");
      throw TooDeep{};
    }
    open_.push_back({node});
  }

  /// Adds a node to the open map or list, or as the root, and returns its address.
  Node* put(Node node) {
    if (open_.empty()) return documents_ == 1 ? &(root = std::move(node)) : &unread_.emplace_back(std::move(node));
    auto& frame = open_.back();
    if (frame.node->kind != Node::Kind::map) return &frame.node->items.emplace_back(std::move(node));
    if (!frame.hasKey) {
      auto* key = putKey(*frame.node, std::move(node));
      frame.hasKey = true;
      frame.key = frame.node->members.back().key;
      return key;
    }
    frame.hasKey = false;
    auto& member = frame.node->members.back();
    if (node.kind == Node::Kind::null) node.place = member.place;  // yaml-cpp puts "nothing" on the next line
    return &(member.value = std::move(node));
  }

  /// Adds a key to a map. A wrong key becomes "", which later readers skip.
  Node* putKey(Node& map, Node key) {
    const auto owner = path();
    const bool isText = key.kind == Node::Kind::scalar && !key.text.empty();
    if (!isText && key.kind != Node::Kind::broken)
      problems_.add(key.place, owner, "a key that is " + (isText ? "" : describe(key)), "keys are names");
    if (isText && key.text.size() > longestKey) {
      problems_.add(key.place, owner, "a key of " + std::to_string(key.text.size()) + " bytes",
                    "keys have at most " + std::to_string(longestKey));
      key.text.clear();
    }
    if (isText && key.text == "<<") {
      problems_.add(key.place, owner, "a merge key", "write the values themselves");
      key.text.clear();
    }
    if (isText && !key.text.empty())
      if (const auto [first, isNew] = open_.back().lines.emplace(key.text, key.place.line); !isNew) {
        problems_.add(key.place, owner.empty() ? key.text : owner + "." + key.text,
                      "given twice, first in line " + std::to_string(first->second), "keep one");
        key.text.clear();
      }
    map.members.push_back({isText ? key.text : "", key.place, {}});
    return &unread_.emplace_back(std::move(key));
  }

  const SourceText& source_;
  Problems& problems_;
  std::vector<Open> open_;
  std::deque<Node> unread_;  // keys and further documents: parsed, but no part of the tree
  int documents_ = 0;
};

/// Returns the usual remedy for a message of yaml-cpp.
std::string remedy(std::string_view message) {
  if (message.find("illegal map value") != message.npos)
    return "check the indentation, or quote a text that holds ': '";
  if (message.find("end of map") != message.npos)
    return "check the indentation of this line, and the ':' after its key";
  if (message.find("end of sequence") != message.npos) return "check the indentation, and close each '[' with ']'";
  if (message.find("EOF") != message.npos) return "close the quote";
  if (message.find("flow") != message.npos) return "check the '[ ]' and '{ }'";
  return "check indentation, brackets and quotes";
}

}  // namespace

Node readYaml(const SourceText& source, Problems& problems) {
  TreeBuilder builder(source, problems);
  try {
    std::istringstream stream(source.text());
    YAML::Parser parser(stream);
    while (!builder.garbled && parser.HandleNextDocument(builder)) {}
  } catch (const YAML::Exception& error) {
    problems.add(error.mark.is_null() ? Place{} : builder.place(error.mark), "", "not YAML: " + error.msg,
                 remedy(error.msg));
    builder.root.kind = Node::Kind::broken;
  } catch (const TooDeep&) { builder.root.kind = Node::Kind::broken; }
  if (builder.garbled) builder.root.kind = Node::Kind::broken;
  return std::move(builder.root);
}

Node readYamlValue(const std::string& value, const std::string& option, Problems& problems) {
  Node node;
  node.place.option = option;
  if (value.empty() || value == "~" || value == "null") return node;
  if (std::string_view("[{\"'").find(value[0]) == std::string_view::npos) {
    node.kind = Node::Kind::scalar;
    node.text = value;
    if (isPlainText(value)) return node;
    problems.add({1, 1, option}, "", "'" + printableLine(value) + "' " + notPlainText, plainTextNeeded);
    node.kind = Node::Kind::broken;
    return node;
  }
  Problems own("");
  const SourceText source(value, own);
  node = own.empty() ? readYaml(source, own) : node;
  if (!own.empty()) {
    problems.add({1, 1, option}, "", "'" + value + "' is not a YAML value", "check brackets, quotes and keys");
    node.kind = Node::Kind::broken;
  }
  relocate(node, option);
  return node;
}

}  // namespace morula::scenario
