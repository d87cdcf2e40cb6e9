#include "base/text_marks.h"

#include "base/utf8.h"

namespace morula {
namespace {

std::string wordsFor(char32_t c) {
  switch (c) {
    case 0xA0: return "no-break space";
    case 0xAD: return "soft hyphen";
    case 0x200B: return "zero-width space";
    case 0x200C: return "zero-width non-joiner";
    case 0x200D: return "zero-width joiner";
    case 0x2028: return "line separator";
    case 0x2029: return "paragraph separator";
    case 0x202F: return "narrow no-break space";
    case 0x3000: return "ideographic space";
    case 0xFEFF: return "byte order mark";
    default: break;
  }
  if (c == 0x1680 || (c >= 0x2000 && c <= 0x200A) || c == 0x205F) return "wide or narrow space";
  const bool turnsOrJoins =
      c == 0x61C || (c >= 0x200E && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F);
  return turnsOrJoins ? "invisible mark" : "";
}

}  // namespace

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

bool isUtf16(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

std::string nameOfInvisible(char32_t c) {
  const std::string words = wordsFor(c);
  if (words.empty()) return {};
  constexpr char digits[] = "0123456789ABCDEF";
  std::string code = "U+";
  for (int shift = 12; shift >= 0; shift -= 4) code += digits[(c >> shift) & 15];
  return code + ' ' + words;
}

std::optional<InvisibleCharacter> findInvisible(std::string_view line) {
  int column = 1;
  for (std::size_t at = 0; at < line.size(); ++column) {
    const std::string_view rest = line.substr(at);
    const int length = utf8Length(rest);
    if (length == 0) return {};
    if (length > 1)
      if (std::string name = nameOfInvisible(utf8Value(rest, length)); !name.empty())
        return InvisibleCharacter{at, column, std::move(name)};
    at += static_cast<std::size_t>(length);
  }
  return {};
}

}  // namespace morula
