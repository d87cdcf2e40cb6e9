#include "yaml/node.h"

#include <algorithm>
#include <utility>

namespace morula::scenario {

const Member* Node::find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
  return found == members.end() ? nullptr : &*found;
}

void assign(Node& root, const std::string& path, Node value) {
  Node* at = &root;
  const std::string option = value.place.option;
  for (std::size_t begin = 0; begin <= path.size();) {
    const auto end = std::min(path.find('.', begin), path.size());
    const auto key = path.substr(begin, end - begin);
    begin = end + 1;
    if (at->kind != Node::Kind::map) {
      *at = Node{};
      at->kind = Node::Kind::map;
      at->place = value.place;
    }
    auto* member = const_cast<Member*>(std::as_const(*at).find(key));
    if (!member) member = &at->members.emplace_back(Member{key, value.place, {}});
    at = &member->value;
    if (begin > path.size()) member->place = value.place;
  }
  *at = std::move(value);
}

bool remove(Node& root, const std::string& path) {
  Node* at = &root;
  for (std::size_t begin = 0;;) {
    const auto end = std::min(path.find('.', begin), path.size());
    const auto member = std::find_if(at->members.begin(), at->members.end(),
                                     [key = path.substr(begin, end - begin)](const Member& m) { return m.key == key; });
    if (member == at->members.end()) return false;
    if (end == path.size()) {
      at->members.erase(member);
      return true;
    }
    at = &member->value;
    begin = end + 1;
  }
}

void relocate(Node& node, const std::string& option) {
  node.place.option = option;
  for (auto& item : node.items) relocate(item, option);
  for (auto& member : node.members) {
    member.place.option = option;
    relocate(member.value, option);
  }
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null: return "nothing";
    case Node::Kind::sequence: return "a list";
    case Node::Kind::map: return "a map";
    default: return "'" + (node.text.size() > 40 ? node.text.substr(0, 40) + "…" : node.text) + "'";
  }
}

}  // namespace morula::scenario
