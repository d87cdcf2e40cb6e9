#pragma once
// Text with emphasis: a sentence, or the content of a table's cell. It may have any origin; code that shows it (html.h,
// text.h) makes it safe.
#include <cstdint>
#include <string>
#include <vector>

namespace morula {

enum class Emphasis { plain, bold, italic, code, quiet, subscript, good, warning, bad, link, lineBreak };

class Words {
 public:
  struct Piece {
    Emphasis emphasis;
    std::string text, hint;  // hint: shown when the pointer is over the text; of a link: the place on its page, as "id"
    bool operator==(const Piece&) const = default;
  };

  Words() = default;
  Words(std::string text, Emphasis emphasis = Emphasis::plain, std::string hint = {});
  Words(const char* text) : Words(std::string(text)) {}

  Words& operator+=(const Words& more);
  friend Words operator+(Words a, const Words& b) { return a += b; }
  bool operator==(const Words&) const = default;

  bool empty() const { return pieces_.empty(); }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Returns the text without emphasis.
  std::string text() const;

 private:
  std::vector<Piece> pieces_;
};

inline Words bold(std::string text) { return {std::move(text), Emphasis::bold}; }
inline Words code(std::string text) { return {std::move(text), Emphasis::code}; }
inline Words quiet(std::string text) { return {std::move(text), Emphasis::quiet}; }
/// Returns "✓ holds" or "✗ does not hold".
Words mark(bool good, const std::string& ifGood, const std::string& ifBad, const std::string& hint = {});
/// Returns "! Warning", to precede a sentence.
Words warning();

/// Returns "1 cell", "2 cells".
std::string counted(std::uint64_t count, const std::string& what);

/// Returns "a", "a and b", "a, b and c"; of more than `most` texts the first ones and the number of the others.
template <class Text>
Text listed(const std::vector<Text>& texts, std::size_t most = 6) {
  const bool all = texts.size() <= most;
  const std::size_t count = all ? texts.size() : most;
  Text text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += all && i + 1 == count ? " and " : ", ";
    text += texts[i];
  }
  if (!all) text += " and " + std::to_string(texts.size() - most) + " more";
  return text;
}

}  // namespace morula
