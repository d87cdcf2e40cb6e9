#include "golden/item.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/cell_path.h"
#include "base/error.h"
#include "golden/number_text.h"

namespace morula {

namespace {

using enum FieldType;

bool isHash(std::string_view word) {
  return word.size() == 32 && word.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

void checkField(const FieldForm& form, std::string_view given, const std::string& place) {
  const auto demand = [&](bool holds, const char* wanted) {
    if (!holds)
      throw InputError(place + ": " + std::string(form.name) + ": '" + std::string(given) + "'; " + wanted +
                       " is expected");
  };
  if (form.optional && given == "-") return;
  switch (form.type) {
    case natural:
      demand(readNatural(given).has_value(), "a whole number from 0");
      break;
    case real: {
      const std::optional<double> value = readReal(given);
      // One spelling per number, so that equal text is equal bits and the other way round.
      demand(value && std::isfinite(*value) && exactText(*value) == given,
             "a finite number, written as shortly as it can be");
      break;
    }
    case hash:
      demand(isHash(given), "a hash of 32 hexadecimal digits");
      break;
    case word:
      demand(!given.empty(), "a word");
      break;
    case text:
      break;
  }
}

}  // namespace

std::string_view takeWord(std::string_view& rest) {
  const std::size_t space = rest.find(' ');
  const std::string_view word = rest.substr(0, space);
  rest = space == std::string_view::npos ? std::string_view() : rest.substr(space + 1);
  return word;
}

const std::vector<ItemForm>& itemForms() {
  static const std::vector<ItemForm> forms{
      {"count", "name", "counts", {{"count", natural}}},
      {"cell",
       "path",
       "lineage",
       {{"born", real},
        {"born_step", natural},
        {"ended", real, true},
        {"ended_step", natural, true},
        {"fate", word},
        {"state", text}}},
      {"generation", "number", "lineage", {{"cells", natural}, {"hash", hash}}},
      {"time_step", "step", "time_steps", {{"time", real}, {"time_step", real}}},
      {"bits", "domain", "bits", {{"hash", hash}}},
      {"step_hash", "step", "step_hashes", {{"hash", hash}, {"cells", text}}},
      {"image", "name", "images", {{"renderer", word}, {"hash", hash}}},
      {"cost", "name", "costs", {{"count", natural}}},
      {"value", "name", "values", {{"step", natural}, {"value", real}}},
  };
  return forms;
}

const ItemForm* findForm(std::string_view kind) {
  const auto& forms = itemForms();
  const auto found =
      std::find_if(forms.begin(), forms.end(), [&](const ItemForm& f) { return f.kind == kind; });
  return found == forms.end() ? nullptr : &*found;
}

std::string write(const GoldenItem& item) {
  std::string line = item.kind + ' ' + item.key;
  for (const std::string& field : item.fields)
    if (!field.empty()) line += ' ' + field;
  return line;
}

GoldenItem readItem(std::string_view line, const std::string& place) {
  GoldenItem item;
  item.kind = takeWord(line);
  const ItemForm* form = findForm(item.kind);
  if (!form) {
    std::string kinds;
    for (const ItemForm& f : itemForms()) kinds += (kinds.empty() ? "" : ", ") + std::string(f.kind);
    throw InputError(place + ": '" + item.kind + "' begins no line of a golden file; one of " + kinds +
                     " is expected");
  }
  item.key = takeWord(line);
  if (item.key.empty())
    throw InputError(place + ": the line ends after '" + item.kind + "'; its " + std::string(form->key) +
                     " is expected");
  if (item.kind == "cell" && item.key != "egg") {
    try {
      CellPath::parse(item.key);
    } catch (const InputError& e) { throw InputError(place + ": path: " + e.what()); }
  }
  if (form->key == "step" || form->key == "number") checkField({form->key, natural}, item.key, place);
  for (const FieldForm& field : form->fields) {
    const std::string_view word = field.type == text ? line : takeWord(line);
    if (word.empty() && field.type != text)
      throw InputError(place + ": the line is cut short; " + std::string(field.name) + " is expected");
    checkField(field, word, place);
    item.fields.emplace_back(word);
    if (field.type == text) line = {};
  }
  if (!line.empty())
    throw InputError(place + ": '" + std::string(line) + "' follows the end of the line; remove it");
  return item;
}

std::optional<std::uint64_t> stepOf(const GoldenItem& item) {
  if (item.kind == "time_step" || item.kind == "step_hash") return readNatural(item.key);
  if (item.kind == "value") return readNatural(item.fields.at(0));
  if (item.kind == "cell") return readNatural(item.fields.at(1));
  return std::nullopt;
}

std::optional<std::string> cellOf(const GoldenItem& item) {
  if (item.kind == "cell") return item.key == "egg" ? "" : item.key;
  if (item.kind != "value") return std::nullopt;
  // when/who/what: who is "organism", "egg" or a path.
  const std::size_t first = item.key.find('/');
  if (first == std::string::npos) return std::nullopt;
  const std::string who = item.key.substr(first + 1, item.key.find('/', first + 1) - first - 1);
  if (who == "organism") return std::nullopt;
  return who == "egg" ? "" : who;
}

}  // namespace morula
