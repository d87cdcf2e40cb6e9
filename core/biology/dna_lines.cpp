// The grammar of DNA text. A line that cannot be read yields one complaint, at the first place where it goes
// wrong.
#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/dna_text.h"

namespace morula::dna_text {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWordPart(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isPunctuation(char c) { return c == '(' || c == '|' || c == ',' || c == ')' || c == ':'; }

struct Unreadable {
  Place place;
  std::string text;
};

/// One character as a message can show it: a whole UTF-8 sequence, or \x and two digits if it cannot be
/// printed.
std::string printable(std::string_view text) {
  const auto byte = static_cast<unsigned char>(text.front());
  if (byte < 0x20 || byte == 0x7F) {
    constexpr char digits[] = "0123456789abcdef";
    return {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
  }
  std::size_t length = 1;
  if (byte >= 0xC0)
    while (length < 4 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
      ++length;
  else if (byte >= 0x80) return "a byte that is not UTF-8";
  return std::string(text.substr(0, length));
}

/// Reads one line from left to right.
class Cursor {
 public:
  Cursor(std::string_view line, Place begin) : line_(line.substr(0, line.find('#'))), begin_(begin) {
    while (!line_.empty() && isSpace(line_.back())) line_.remove_suffix(1);
    skipSpace();
  }

  bool atEnd() const { return at_ == line_.size(); }
  char next() const { return atEnd() ? '\0' : line_[at_]; }
  bool atWord() const { return !atEnd() && isLetter(next()); }
  std::string_view rest() const { return line_.substr(at_); }
  Place place() const { return {begin_.line, begin_.column + static_cast<int>(at_)}; }

  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    skipSpace();
    return true;
  }

  /// Takes a name, or complains that `what` is missing.
  Word word(const std::string& what) {
    if (!atWord()) {
      if (isDigit(next()) || next() == '_')
        fail(what + " begins with '" + next() + "'; a name begins with a letter, for example a" + next());
      failUnexpected(what + " is missing" + (atEnd() ? " at the end of the line" : " before " + shown()));
    }
    Word word{"", place()};
    while (!atEnd() && isWordPart(next())) word.text += line_[at_++];
    skipSpace();
    return word;
  }

  [[noreturn]] void fail(const std::string& text) const { throw Unreadable{place(), text}; }

  /// Complains about the next character itself if no line of DNA could hold it there, else with `text`.
  [[noreturn]] void failUnexpected(const std::string& text) const {
    if (!atEnd() && !isPunctuation(next()) && !isWordPart(next()))
      fail("unexpected character " + shown() +
           "; names are made of letters, digits and '_', and begin with a letter");
    fail(text + "; a gene is written g1(product|input, input)");
  }

  std::string shown() const { return "'" + printable(rest()) + "'"; }

 private:
  void skipSpace() {
    while (!atEnd() && isSpace(next())) ++at_;
  }

  std::string_view line_;
  Place begin_;
  std::size_t at_ = 0;
};

constexpr auto startExample = "; the egg's substances are written START: a0, a1";

void readStart(Cursor& cursor, Lines& lines) {
  if (!cursor.take(':')) cursor.fail(std::string("':' is missing after START") + startExample);
  if (cursor.atEnd()) cursor.fail(std::string("START names no substance") + startExample);
  std::vector<Word> words = {cursor.word("a substance")};
  while (!cursor.atEnd()) {
    if (cursor.atWord()) cursor.fail("',' is missing after '" + words.back().text + "'" + startExample);
    if (!cursor.take(',')) cursor.failUnexpected("START holds " + cursor.shown());
    words.push_back(cursor.word("a substance"));
  }
  lines.start.insert(lines.start.end(), words.begin(), words.end());
}

GeneLine readGene(Cursor& cursor, Word name) {
  GeneLine gene{std::move(name), cursor.word("the gene's product"), {}};
  if (!cursor.take('|')) {
    if (cursor.next() == ',' && cursor.rest().find('|') != std::string_view::npos)
      cursor.fail("a gene has one product; write one gene for each product");
    cursor.failUnexpected("'|' is missing after the product '" + gene.product.text + "'");
  }
  if (cursor.atEnd() || cursor.next() == ')')
    cursor.fail("gene '" + gene.name.text +
                "' has no input; name at least one, for example a START substance or the product itself");
  do { gene.inputs.push_back(cursor.word("an input")); } while (cursor.take(','));
  if (!cursor.take(')')) {
    const std::string after = " after '" + gene.inputs.back().text + "'";
    if (cursor.next() == '|') cursor.fail("a second '|'; inputs are separated by ','");
    if (cursor.atWord()) cursor.failUnexpected("',' is missing" + after);
    cursor.failUnexpected("')' is missing" + after);
  }
  if (!cursor.atEnd())
    cursor.fail("text after the gene: " + cursor.shown() +
                "; write one gene per line, and # before a comment");
  return gene;
}

void readLine(Cursor& cursor, Lines& lines) {
  if (cursor.atEnd()) return;
  const Place begin = cursor.place();
  Word first = cursor.word("a gene's name");
  if (first.text == "START") {
    lines.hasStartLine = true;
    if (cursor.next() == '(')
      throw Unreadable{begin, "START cannot name a gene; take another name, for example g1"};
    readStart(cursor, lines);
  } else if (cursor.take('(')) {
    lines.genes.push_back(readGene(cursor, std::move(first)));
  } else if (equalButForCase(first.text, "START") || cursor.next() == ':') {
    lines.hasStartLine = true;
    throw Unreadable{begin, "'" + first.text + "' begins no line of DNA" + startExample};
  } else {
    cursor.failUnexpected("'(' is missing after the gene's name '" + first.text + "'");
  }
}

void rememberWords(std::string_view line, std::set<std::string>& words) {
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && isWordPart(line[end])) ++end;
    if (end > at) words.emplace(line.substr(at, end - at));
    at = std::max(end, at + 1);
  }
}

}  // namespace

Lines readLines(std::string_view text, Place begin, Complaints& complaints) {
  Lines lines;
  lines.begin = begin;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // some editors' mark for UTF-8
  for (Place place = begin; !text.empty(); ++place.line) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    Cursor cursor(line, place);
    try {
      readLine(cursor, lines);
    } catch (const Unreadable& problem) {
      complaints.add(problem.place, problem.text);
      rememberWords(line.substr(0, line.find('#')), lines.unreadableWords);
    }
  }
  return lines;
}

void Complaints::report(const std::string& file, const std::string& path) {
  if (list_.empty()) return;
  std::ranges::stable_sort(list_, [](const Complaint& a, const Complaint& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line : a.place.column < b.place.column;
  });
  constexpr std::size_t most = 50;  // a picture taken for DNA has one per line
  std::string text;
  for (std::size_t i = 0; i < std::min(list_.size(), most); ++i) {
    const Complaint& c = list_[i];
    text += (i ? "\n" : "") + file + ":" + std::to_string(c.place.line) + ":" +
            std::to_string(c.place.column) + ": " + (path.empty() ? "" : path + ": ") + c.text;
  }
  if (list_.size() > most)
    text += "\n" + file + ": … and " + std::to_string(list_.size() - most) + " more like these";
  throw InputError(text);
}

}  // namespace morula::dna_text
