#include "files/safe_name.h"

#include "base/utf8.h"
#include "files/printable.h"

namespace morula {
namespace {

constexpr std::size_t maxBytes = 100, maxExtension = 10;

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view(" .-_+()").find(c) != std::string_view::npos;
}

}  // namespace

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
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // not within a character
    name = name.substr(0, end) + extension;
  }
  return name.empty() ? std::string(fallback) : name;
}

}  // namespace morula
