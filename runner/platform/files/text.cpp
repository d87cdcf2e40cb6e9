#include "files/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace morula {
namespace {

/// Puts a text between quotation marks; those within are doubled.
std::string doubled(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

bool isMadeOf(std::string_view text, std::string_view others) {
  for (const char c : text)
    if (!(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z') && !(c >= '0' && c <= '9') && others.find(c) == others.npos)
      return false;
  return !text.empty();
}

std::string join(const std::vector<std::string>& words, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  return text;
}

std::vector<std::string> partsOf(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::vector<std::string> linesOf(std::string_view text) { return partsOf(text, '\n'); }

std::vector<std::string> wordsOf(std::string_view line) {
  constexpr const char* blanks = " \t\r";
  line = line.substr(0, line.find('#'));
  std::vector<std::string> words;
  for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.emplace_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string markdownCell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string markdownText(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '[' ? "\\[" : std::string(1, c);
  return out;
}

std::string markdownCode(std::string_view text) {
  std::size_t longest = 0, run = 0;  // [backticks] the longest run and the present run
  for (const char c : text) run = c == '`' ? run + 1 : 0, longest = std::max(longest, run);
  const std::string fence(longest + 1, '`'), blank = longest ? " " : "";
  return fence + blank + std::string(text) + blank + fence;
}

std::string csvField(std::string_view text) {
  const bool isPlain =
      !text.empty() && text.find_first_of("\",\r\n") == text.npos && text.front() != ' ' && text.back() != ' ';
  return isPlain ? std::string(text) : doubled(text);
}

std::string sqlName(std::string_view name) { return doubled(name); }

std::string shellWord(std::string_view text) {
  if (isMadeOf(text, "-_=./,:+@%")) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string yamlText(std::string_view text) {
  const bool beginsAsWord = isMadeOf(text.substr(0, 1), "") && text[0] >= 'A';
  // YAML's words for true, false and null hold none of these marks.
  if (beginsAsWord && isMadeOf(text, "-_./") && text.find_first_of("-_./") != text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text)
    if (c == '"' || c == '\\') quoted += '\\', quoted += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else quoted += c;
  return quoted + '"';
}

}  // namespace morula
