#include "contacts/contact_search.h"

#include <string>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"

namespace morula {

ContactSearch parseContactSearch(std::string_view word) {
  std::vector<std::string> known;
  std::string list;
  for (const auto& [search, name, meaning] : choices<ContactSearch>) {
    if (word == name) return search;
    known.push_back(name);
    list += (list.empty() ? "" : ", ") + known.back();
  }
  const std::string meant = closest(word, known);
  throw InputError("'" + std::string(word) + "' is no way to search for contacts; " +
                   (meant.empty() ? "there are " + list : "did you mean '" + meant + "'? There are " + list));
}

}  // namespace morula
