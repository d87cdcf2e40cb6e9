#include "files/printable.h"

#include "base/utf8.h"

namespace morula {
namespace {

bool isHarmful(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c <= 0x9F) || c == 0x061C || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

/// Returns `prefix` and the last `digits` hexadecimal digits of the number.
std::string escape(const char* prefix, char32_t number, int digits) {
  std::string text = prefix;
  for (int i = digits - 1; i >= 0; --i) text += "0123456789abcdef"[number >> (4 * i) & 15];
  return text;
}

std::string escapeIn(std::string_view text, bool oneLine) {
  std::string out;
  while (!text.empty()) {
    const int length = utf8Length(text);
    const char32_t c = length ? utf8Value(text, length) : static_cast<unsigned char>(text[0]);
    const std::size_t taken = length ? static_cast<std::size_t>(length) : 1;
    if (!length) out += escape("\\x", c, 2);
    else if (c == '\n') out += oneLine ? "\\n" : "\n";
    else if (c == '\t') out += oneLine ? "\\t" : "\t";
    else if (c == '\r' && oneLine) out += "\\r";
    else if (!isHarmful(c)) out += text.substr(0, taken);
    // From DEL on characters are escaped as in JSON, so that JSON remains JSON.
    else out += c < 0x7F ? escape("\\x", c, 2) : escape("\\u", c, 4);
    text.remove_prefix(taken);
  }
  return out;
}

constexpr std::size_t maxBytes = 100, maxExtension = 10;

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view(" .-_+()").find(c) != std::string_view::npos;
}

}  // namespace

std::string printable(std::string_view text) { return escapeIn(text, false); }

std::string printableLine(std::string_view text) { return escapeIn(text, true); }

std::string safeName(std::string_view text, std::string_view fallback) {
  if (const auto slash = text.rfind('/'); slash != text.npos) text.remove_prefix(slash + 1);
  while (!text.empty() && text[0] == '.') text.remove_prefix(1);
  std::string name;
  while (!text.empty()) {
    const auto length = static_cast<std::size_t>(utf8Length(text));
    const auto character = text.substr(0, length);
    if (length == 1) name += isPlain(text[0]) ? text[0] : '_';
    else if (length > 1 && printable(character) == character) name += character;
    else name += '_';
    text.remove_prefix(length ? length : 1);
  }
  if (name.size() > maxBytes) {
    const auto dot = name.rfind('.');
    const std::string extension = dot != name.npos && name.size() - dot <= maxExtension ? name.substr(dot) : "";
    std::size_t end = maxBytes - extension.size();
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // a character is not cut
    name = name.substr(0, end) + extension;
  }
  return name.empty() ? std::string(fallback) : name;
}

}  // namespace morula
