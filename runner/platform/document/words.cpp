#include "document/words.h"

namespace morula {

Words::Words(std::string text, Emphasis emphasis, std::string hint) {
  if (!text.empty() || emphasis == Emphasis::lineBreak) pieces_.push_back({emphasis, std::move(text), std::move(hint)});
}

Words& Words::operator+=(const Words& more) {
  for (const Piece& piece : more.pieces_)
    if (!pieces_.empty() && piece.emphasis == Emphasis::plain && pieces_.back().emphasis == Emphasis::plain)
      pieces_.back().text += piece.text;
    else pieces_.push_back(piece);
  return *this;
}

std::string Words::text() const {
  std::string text;
  for (const Piece& piece : pieces_)
    text += piece.emphasis == Emphasis::lineBreak   ? "\n"
            : piece.emphasis == Emphasis::subscript ? "_" + piece.text
                                                    : piece.text;
  return text;
}

Words mark(bool good, const std::string& ifGood, const std::string& ifBad, const std::string& hint) {
  return {good ? "✓ " + ifGood : "✗ " + ifBad, good ? Emphasis::good : Emphasis::bad, hint};
}

Words warning() { return {"! Warning", Emphasis::warning}; }

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace morula
