#include "contacts/contact_search.h"

#include <string>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"

namespace morula {

std::span<const ContactSearch> allContactSearches() {
  static constexpr ContactSearch all[] = {ContactSearch::grid, ContactSearch::aabbTree,
                                          ContactSearch::spatialHash, ContactSearch::bruteForce};
  return all;
}

const char* name(ContactSearch search) {
  switch (search) {
    case ContactSearch::grid:
      return "grid";
    case ContactSearch::aabbTree:
      return "aabb-tree";
    case ContactSearch::spatialHash:
      return "spatial-hash";
    case ContactSearch::bruteForce:
      return "brute-force";
  }
  return "?";
}

ContactSearch parseContactSearch(std::string_view word) {
  std::vector<std::string> known;
  std::string list;
  for (ContactSearch search : allContactSearches()) {
    if (word == name(search)) return search;
    known.push_back(name(search));
    list += (list.empty() ? "" : ", ") + known.back();
  }
  const std::string meant = closest(word, known);
  throw InputError("'" + std::string(word) + "' is no way to search for contacts; " +
                   (meant.empty() ? "there are " + list : "did you mean '" + meant + "'? There are " + list));
}

}  // namespace morula
