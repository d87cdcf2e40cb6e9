// The grammar of DNA text. A line that cannot be read yields one diagnostic, at the first place where it goes
// wrong. A line with a range is read once for each of its numbers.
#include <algorithm>
#include <charconv>
#include <utility>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "base/text_marks.h"
#include "biology/dna_text.h"

namespace morula::dna_text {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWordPart(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isPunctuation(char c) {
  return c == '(' || c == '|' || c == ',' || c == ')' || c == ':' || c == '!' || c == '{' || c == '}';
}

struct Unreadable {
  Place place;
  std::string text;
};

/// Returns the first character as a message can show it. A letter beyond ASCII comes with its code point, because some
/// look like others or like nothing; an unprintable byte comes as its number.
std::string shown(std::string_view text) {
  constexpr char digits[] = "0123456789ABCDEF";
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) >= 0x20 && byte(0) < 0x7F) return "'" + std::string(text.substr(0, 1)) + "'";
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 1;
  unsigned code =
      length == 1 ? 0 : byte(0) & (0xFF >> (length + 1));  // UTF-8: the bits below the leading ones and a zero
  for (std::size_t i = 1; i < length && code != 0; ++i)
    code = i < text.size() && (byte(i) & 0xC0) == 0x80 ? code << 6 | (byte(i) & 0x3F) : 0;
  if (code == 0) return std::string("0x") + digits[byte(0) >> 4] + digits[byte(0) & 15];
  std::string hex;
  for (int shift = code > 0xFFFF ? 20 : 12; shift >= 0; shift -= 4) hex += digits[code >> shift & 15];
  return "'" + std::string(text.substr(0, length)) + "' (U+" + hex + ")";
}

constexpr std::size_t longestName = 100;  // [letter] max, so that messages and pictures can show a name

constexpr std::size_t maxNames = 20'000;  // max names of all ranges: a short text must not fill the memory
constexpr int largestNumber = 1'000'000;

constexpr auto rangeExample = "; a range is written g{n}(a{n+1}|a{n}) for n in 0..4";
constexpr auto startExample = "; the egg's substances are written START: a0, a1";
constexpr auto geneExample = "; a gene is written g1(product|input, input)";

/// A range as `for n in 0..4`, and the number that n has now.
struct Range {
  Place place;
  std::string variable;
  int first = 0, last = 0, now = 0;
};

/// Reads one line from left to right; a line with a range, for the range's present number.
class Cursor {
 public:
  Cursor(std::string_view line, Place begin, const Range* range = nullptr) : line_(line), begin_(begin), range_(range) {
    begin_.isRepeated = range != nullptr;
    while (!line_.empty() && isSpace(line_.back())) line_.remove_suffix(1);
    skipSpace();
  }

  bool atEnd() const { return at_ == line_.size(); }
  char next() const { return atEnd() ? '\0' : line_[at_]; }
  bool atWord() const { return !atEnd() && isLetter(next()); }
  std::string_view rest() const { return line_.substr(at_); }
  Place place() const { return {begin_.line, begin_.column + static_cast<int>(at_), begin_.isRepeated}; }

  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    skipSpace();
    return true;
  }

  /// Takes a name, or reports that `what` is missing.
  Word word(const std::string& what) {
    if (!atWord()) {
      if (isDigit(next()) || next() == '_' || next() == '{')
        fail(what + " begins with " + shown(rest()) + "; a name begins with a letter");
      failUnexpected(what + " is missing" + (atEnd() ? " at the end of the line" : " before " + shown(rest())));
    }
    Word word{"", place()};
    const std::size_t begin = at_;
    while (isWordPart(next()) || next() == '{')
      word.text += next() == '{' ? numberInBraces() : std::string(1, line_[at_++]);
    if (word.text.size() > longestName) {
      at_ = begin;
      fail(what + " of " + std::to_string(word.text.size()) + " letters; a name has at most " +
           std::to_string(longestName));
    }
    ++words;
    skipSpace();
    return word;
  }

  /// Takes a whole number of a range.
  int number() {
    int value = largestNumber + 1;
    const auto [end, error] = std::from_chars(line_.data() + at_, line_.data() + line_.size(), value);
    if (error != std::errc{} || value < 0 || value > largestNumber)
      fail("needs a whole number from 0 to " + std::to_string(largestNumber) + " here" + rangeExample);
    at_ = static_cast<std::size_t>(end - line_.data());
    skipSpace();
    return value;
  }

  [[noreturn]] void fail(const std::string& text) const { throw Unreadable{place(), text}; }

  /// Reports the next character itself if no line of DNA could hold it, else with `text` and the example.
  [[noreturn]] void failUnexpected(const std::string& text) const {
    if (!atEnd() && !isPunctuation(next()) && !isWordPart(next()))
      fail("unexpected character " + shown(rest()) +
           "; names are made of letters, digits and '_', and begin with a letter");
    fail(text + example);
  }

  std::string example = geneExample;   // example of what would be right
  std::size_t words = 0, numbers = 0;  // names taken so far, and braces in them

 private:
  /// Takes {n}, {n+1} or {n-1}. Returns the number that the braces stand for.
  std::string numberInBraces() {
    if (!range_) fail("'{' has a meaning only where a range ends the line" + std::string(rangeExample));
    const std::string& n = range_->variable;
    const std::string forms = "write {" + n + "}, {" + n + "+1} or {" + n + "-1}";
    const std::size_t begin = at_;
    take('{');
    const std::size_t name = at_;
    while (isWordPart(next())) ++at_;
    if (line_.substr(name, at_ - name) != n) {
      at_ = name;
      fail("the range of this line is of '" + n + "'; " + forms);
    }
    skipSpace();
    int value = range_->now;
    if (take('+')) value += number();
    else if (take('-')) value -= number();
    if (next() != '}') fail("'}' is missing; " + forms);
    ++at_;  // spaces are not skipped: the next letters belong to the name
    if (value < 0) {
      const std::string braces(line_.substr(begin, at_ - begin));
      at_ = begin;
      fail(braces + " is " + std::to_string(value) + " for " + n + " = " + std::to_string(range_->now) +
           ", and names hold no sign; begin the range at " + std::to_string(range_->now - value));
    }
    ++numbers;
    return std::to_string(value);
  }

  void skipSpace() {
    while (!atEnd() && isSpace(next())) ++at_;
  }

  std::string_view line_;
  Place begin_;
  const Range* range_;
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
    throw Unreadable{gene.repressors.front().place,
                     "gene '" + gene.name.text + "' has no input that makes it active; name at least one without '!'"};
  if (!cursor.atEnd()) cursor.fail("text after the gene; write one gene per line, and # before a comment");
  return gene;
}

bool meansStart(const std::string& word) {
  static const std::vector<std::string> candidates = {"START"};
  return !closest(word, candidates).empty();
}

/// Reads one line. Returns how many braces the line's first word holds.
std::size_t readLine(Cursor& cursor, Lines& lines) {
  if (cursor.atEnd()) return 0;
  const Place begin = cursor.place();
  Word first = cursor.word("a gene's name");
  const std::size_t inName = cursor.numbers;
  if (first.text == "START" && cursor.next() != '(') {
    lines.hasStartLine = true;
    const bool readableSoFar = std::exchange(lines.areNamesKnown, false);
    readStart(cursor, lines);  // throws if it cannot be read
    lines.areNamesKnown = readableSoFar;
  } else if (first.text == "START") {
    throw Unreadable{begin, "START cannot name a gene; take another name, for example g1"};
  } else if (cursor.take('(')) {
    lines.genes.push_back(readGene(cursor, std::move(first)));
  } else if (meansStart(first.text)) {
    lines.hasStartLine = true;
    lines.areNamesKnown = false;
    throw Unreadable{begin, "'" + first.text + "' begins no line of DNA" + startExample};
  } else {
    cursor.failUnexpected("'(' is missing after the gene's name '" + first.text + "'");
  }
  return inName;
}

/// Returns where a range begins: at a `for` behind a complete line, where nothing else can stand; npos without a range.
std::size_t rangeBegin(std::string_view line) {
  for (std::size_t at = line.find("for", 1); at < line.size(); at = line.find("for", at + 1)) {
    const std::size_t before = line.find_last_not_of(" \t", at - 1);
    if (isWordPart(line[at - 1]) || (at + 3 < line.size() && isWordPart(line[at + 3])) || before == line.npos) continue;
    if (isWordPart(line[before]) || line[before] == ')' || line[before] == '}') return at;
  }
  return line.npos;
}

Range readRange(Cursor cursor) {
  Range range;
  range.place = cursor.place();
  cursor.example = rangeExample;
  cursor.word("for");
  range.variable = cursor.word("the range's variable").text;
  const auto missing = [&](const std::string& what, const std::string& after) {
    cursor.fail(what + " is missing after '" + after + "'" + rangeExample);
  };
  if (cursor.rest().substr(0, 2) != "in" || cursor.word("in").text != "in") missing("'in'", range.variable);
  range.first = range.now = cursor.number();
  if (!cursor.take('.') || !cursor.take('.')) missing("'..'", std::to_string(range.first));
  range.last = cursor.number();
  if (!cursor.atEnd()) cursor.fail("text after the range; a line has one range, and # before a comment");
  if (range.last < range.first)
    throw Unreadable{range.place, "the range holds no number; write for " + range.variable + " in " +
                                      std::to_string(range.last) + ".." + std::to_string(range.first)};
  return range;
}

/// Reads a line once for each number of its range.
void readRepeated(std::string_view line, Place begin, Range range, Lines& lines) {
  const std::string braces = "{" + range.variable + "}";
  for (; range.now <= range.last; ++range.now) {
    Cursor cursor(line, begin, &range);
    const Word first = Cursor(cursor).word("a gene's name");
    const std::size_t inName = readLine(cursor, lines);
    if (first.text != "START" && inName == 0)
      throw Unreadable{first.place,
                       "all genes of the range would be called '" + first.text + "'; write " + first.text + braces};
    if (cursor.numbers == inName)
      throw Unreadable{range.place, "the range changes nothing, for no substance holds " + braces +
                                        "; write it where its number belongs, or remove the range"};
    lines.repeatedNames += cursor.words;
    if (lines.repeatedNames > maxNames)
      throw Unreadable{range.place, "ranges write more than " + std::to_string(maxNames) +
                                        " names in all (some 5000 genes); shorten them"};
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
  if (isUtf16(text)) {
    diagnostics.add(begin, "the file is UTF-16; save it as UTF-8");
    return lines;
  }
  text = withoutByteOrderMark(text);
  for (Place place = begin; !text.empty(); ++place.line) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line = line.substr(0, line.find('#'));
    try {
      if (const auto found = findInvisible(line))
        throw Unreadable{{place.line, place.column + static_cast<int>(found->at)},
                         found->name + " stands in the line; remove it, or replace it by a space"};
      if (const std::size_t range = rangeBegin(line); range != line.npos) {
        const Place behind{place.line, place.column + static_cast<int>(range)};
        readRepeated(line.substr(0, range), place, readRange(Cursor(line.substr(range), behind)), lines);
      } else {
        Cursor cursor(line, place);
        readLine(cursor, lines);
      }
    } catch (const Unreadable& problem) {
      diagnostics.add(problem.place, problem.text);
      rememberWords(line, lines.unreadableWords);
      if (line.find('{') != line.npos) lines.areNamesKnown = false;
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
  constexpr std::size_t most = 50;  // a picture mistaken for DNA has an error in each line
  const auto all = lines(file, path);
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i) text += (i ? "\n" : "") + all[i];
  if (all.size() > most) text += "\n" + file + ": … and " + std::to_string(all.size() - most) + " more like these";
  throw InputError(text);
}

}  // namespace morula::dna_text
