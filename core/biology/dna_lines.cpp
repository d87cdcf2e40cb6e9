// The grammar of DNA text. A line that cannot be read yields one diagnostic, at the first place where it goes
// wrong.
#include <algorithm>
#include <utility>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/dna_text.h"

namespace morula::dna_text {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWordPart(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isPunctuation(char c) { return c == '(' || c == '|' || c == ',' || c == ')' || c == ':' || c == '!'; }

struct Unreadable {
  Place place;
  std::string text;
};

/// The first character as a message can show it: a letter beyond ASCII with its code point, because some look
/// like others or like nothing; what cannot be printed as its byte.
std::string shown(std::string_view text) {
  constexpr char digits[] = "0123456789ABCDEF";
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) >= 0x20 && byte(0) < 0x7F) return "'" + std::string(text.substr(0, 1)) + "'";
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 1;
  unsigned code =
      length == 1 ? 0
                  : byte(0) & (0xFF >> (length + 1));  // UTF-8: the bits below the leading ones and a zero
  for (std::size_t i = 1; i < length && code != 0; ++i)
    code = i < text.size() && (byte(i) & 0xC0) == 0x80 ? code << 6 | (byte(i) & 0x3F) : 0;
  if (code == 0) return std::string("0x") + digits[byte(0) >> 4] + digits[byte(0) & 15];
  std::string hex;
  for (int shift = code > 0xFFFF ? 20 : 12; shift >= 0; shift -= 4) hex += digits[code >> shift & 15];
  return "'" + std::string(text.substr(0, length)) + "' (U+" + hex + ")";
}

constexpr std::size_t longestName = 100;  // [letter] so that messages and pictures can show it

constexpr auto startExample = "; the egg's substances are written START: a0, a1";
constexpr auto geneExample = "; a gene is written g1(product|input, input)";

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

  /// Takes a name, or reports that `what` is missing.
  Word word(const std::string& what) {
    if (!atWord()) {
      if (isDigit(next()) || next() == '_')
        fail(what + " begins with " + shown(rest()) + "; a name begins with a letter");
      failUnexpected(what + " is missing" +
                     (atEnd() ? " at the end of the line" : " before " + shown(rest())));
    }
    std::size_t length = 1;
    while (length < rest().size() && isWordPart(rest()[length])) ++length;
    if (length > longestName)
      fail(what + " of " + std::to_string(length) + " letters; a name has at most " +
           std::to_string(longestName));
    Word word{std::string(rest().substr(0, length)), place()};
    at_ += length;
    skipSpace();
    return word;
  }

  [[noreturn]] void fail(const std::string& text) const { throw Unreadable{place(), text}; }

  /// Reports the next character itself if no line of DNA could hold it, else with `text` and the
  /// example.
  [[noreturn]] void failUnexpected(const std::string& text) const {
    if (!atEnd() && !isPunctuation(next()) && !isWordPart(next()))
      fail("unexpected character " + shown(rest()) +
           "; names are made of letters, digits and '_', and begin with a letter");
    fail(text + example);
  }

  std::string example = geneExample;  // what would be right

 private:
  void skipSpace() {
    while (!atEnd() && isSpace(next())) ++at_;
  }

  std::string_view line_;
  Place begin_;
  std::size_t at_ = 0;
};

void readStart(Cursor& cursor, Lines& lines) {
  cursor.example = startExample;
  if (!cursor.take(':')) cursor.failUnexpected("':' is missing after START");
  if (cursor.atEnd()) cursor.failUnexpected("START names no substance");
  std::vector<Word> words = {cursor.word("a substance")};
  while (!cursor.atEnd()) {
    if (!cursor.take(',')) cursor.failUnexpected("',' is missing after '" + words.back().text + "'");
    words.push_back(cursor.word("a substance"));
  }
  lines.start.insert(lines.start.end(), words.begin(), words.end());
}

GeneLine readGene(Cursor& cursor, Word name) {
  GeneLine gene{std::move(name), cursor.word("the gene's product"), {}, {}};
  if (!cursor.take('|')) {
    if (cursor.next() == ',' && cursor.rest().find('|') != std::string_view::npos)
      cursor.fail("a gene has one product; write one gene for each product");
    cursor.failUnexpected("'|' is missing after the product '" + gene.product.text + "'");
  }
  if (cursor.atEnd() || cursor.next() == ')')
    cursor.fail("gene '" + gene.name.text +
                "' has no input; name at least one, for example a START substance or the product itself");
  std::string last;
  do {
    const bool represses = cursor.take('!');
    Word input = cursor.word(represses ? "a substance behind '!'" : "an input");
    last = input.text;
    (represses ? gene.repressors : gene.inputs).push_back(std::move(input));
  } while (cursor.take(','));
  if (!cursor.take(')')) {
    const std::string after = " after '" + last + "'";
    if (cursor.next() == '|') cursor.fail("a second '|'; inputs are separated by ','");
    if (cursor.atWord() || cursor.next() == '!') cursor.failUnexpected("',' is missing" + after);
    cursor.failUnexpected("')' is missing" + after);
  }
  if (gene.inputs.empty())
    throw Unreadable{
        gene.repressors.front().place,
        "gene '" + gene.name.text + "' has no input that makes it active; name at least one without '!'"};
  if (!cursor.atEnd()) cursor.fail("text after the gene; write one gene per line, and # before a comment");
  return gene;
}

bool meansStart(const std::string& word) {
  static const std::vector<std::string> candidates = {"START"};
  return !closest(word, candidates).empty();
}

void readLine(Cursor& cursor, Lines& lines) {
  if (cursor.atEnd()) return;
  const Place begin = cursor.place();
  Word first = cursor.word("a gene's name");
  if (first.text == "START" && cursor.next() != '(') {
    lines.hasStartLine = true;
    const bool readableSoFar = std::exchange(lines.isStartReadable, false);
    readStart(cursor, lines);  // throws if it cannot be read
    lines.isStartReadable = readableSoFar;
  } else if (first.text == "START") {
    throw Unreadable{begin, "START cannot name a gene; take another name, for example g1"};
  } else if (cursor.take('(')) {
    lines.genes.push_back(readGene(cursor, std::move(first)));
  } else if (meansStart(first.text)) {
    lines.hasStartLine = true;
    lines.isStartReadable = false;
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

Lines readLines(std::string_view text, Place begin, Diagnostics& diagnostics) {
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
      diagnostics.add(problem.place, problem.text);
      rememberWords(line.substr(0, line.find('#')), lines.unreadableWords);
    }
  }
  return lines;
}

std::vector<std::string> Diagnostics::lines(const std::string& file, const std::string& path) {
  std::ranges::stable_sort(list_, [](const Diagnostic& a, const Diagnostic& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line : a.place.column < b.place.column;
  });
  std::vector<std::string> lines;
  for (const Diagnostic& c : list_)
    lines.push_back(file + ":" + std::to_string(c.place.line) + ":" + std::to_string(c.place.column) + ": " +
                    (path.empty() ? "" : path + ": ") + c.text);
  return lines;
}

void Diagnostics::report(const std::string& file, const std::string& path) {
  if (list_.empty()) return;
  constexpr std::size_t most = 50;  // a picture taken for DNA has one per line
  const auto all = lines(file, path);
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i) text += (i ? "\n" : "") + all[i];
  if (all.size() > most)
    text += "\n" + file + ": … and " + std::to_string(all.size() - most) + " more like these";
  throw InputError(text);
}

}  // namespace morula::dna_text
