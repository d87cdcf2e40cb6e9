#include "yaml/node.h"

#include <algorithm>
#include <utility>

namespace morula::scenario {

const Member* Node::find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
  return found == members.end() ? nullptr : &*found;
}

namespace {

/// Returns true if an entry of a list is called by this name: it is a map with the name under `of` or `name`.
bool isCalled(const Node& entry, const std::string& name) {
  if (entry.kind != Node::Kind::map) return false;
  for (const char* key : {"of", "name"})
    if (const Member* member = entry.find(key); member && member->value.kind == Node::Kind::scalar)
      return member->value.text == name;
  return false;
}

/// Returns the one entry of a list that is called by this name; null if there is none, or several.
Node* entryCalled(Node& list, const std::string& name) {
  Node* found = nullptr;
  for (Node& entry : list.items) {
    if (!isCalled(entry, name)) continue;
    if (found) return nullptr;
    found = &entry;
  }
  return found;
}

}  // namespace

std::string assign(Node& root, const std::string& path, Node value) {
  Node* at = &root;
  for (std::size_t begin = 0; begin <= path.size();) {
    const auto end = std::min(path.find('.', begin), path.size());
    const auto key = path.substr(begin, end - begin);
    const std::string before = path.substr(0, begin == 0 ? 0 : begin - 1);
    begin = end + 1;
    if (at->kind == Node::Kind::sequence && !at->items.empty()) {
      Node* const entry = entryCalled(*at, key);
      if (!entry) return before;
      at = entry;
      continue;
    }
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
  return {};
}

bool remove(Node& root, const std::string& path) {
  Node* at = &root;
  for (std::size_t begin = 0;;) {
    const auto end = std::min(path.find('.', begin), path.size());
    const auto key = path.substr(begin, end - begin);
    const bool isLast = end == path.size();
    begin = end + 1;
    if (at->kind == Node::Kind::sequence) {
      Node* const entry = entryCalled(*at, key);
      if (!entry) return false;
      if (isLast) at->items.erase(at->items.begin() + (entry - at->items.data()));
      if (isLast) return true;
      at = entry;
      continue;
    }
    const auto member =
        std::find_if(at->members.begin(), at->members.end(), [&](const Member& m) { return m.key == key; });
    if (member == at->members.end()) return false;
    if (isLast) at->members.erase(member);
    if (isLast) return true;
    at = &member->value;
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
