#pragma once
// The lines of a golden file's body. Each is `kind key field…`; kind and key name the item, the fields are
// what must agree. All kinds go through this one form, so a new kind is one row in the table of item.cpp.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morula {

enum class FieldType { natural, real, hash, word, text };  // text: the rest of the line, may be empty

struct FieldForm {
  std::string_view name;
  FieldType type;
  bool optional = false;  // "-" when there is none
};

struct ItemForm {
  std::string_view kind;
  std::string_view key;    // what the key is called in messages
  std::string_view check;  // the check that compares it
  std::vector<FieldForm> fields;
};

/// The kinds in their order in the file.
const std::vector<ItemForm>& itemForms();
/// Null for an unknown kind.
const ItemForm* findForm(std::string_view kind);

struct GoldenItem {
  std::string kind;
  std::string key;
  std::vector<std::string> fields;  // canonical text: equal text is equal bits
  int line = 0;                     // in the file it was read from; 0: observed
};

/// Splits off the text before the next space; the rest keeps what follows the space.
std::string_view takeWord(std::string_view& rest);

std::string write(const GoldenItem& item);
/// Reads one line. Throws InputError that begins with `place` ("file:line").
GoldenItem readItem(std::string_view line, const std::string& place);

/// The step at which the item happened, if it says so.
std::optional<std::uint64_t> stepOf(const GoldenItem& item);
/// The path of the cell it is about, if it is about one; "" is the egg.
std::optional<std::string> cellOf(const GoldenItem& item);

}  // namespace morula
