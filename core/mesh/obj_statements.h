#pragma once
// The lines of a Wavefront OBJ text, cut into words that know where they stand.
#include <string_view>
#include <vector>

namespace morula {

struct ObjWord {
  std::string_view text;
  int line, column;  // 1-based; columns in bytes
};

// Cuts the text into statements: the words of a line, without comments. A backslash at the end of a line
// joins the next one to it. Line ends are LF, CR LF or CR.
class ObjStatements {
 public:
  explicit ObjStatements(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // a byte order mark
  }

  // False at the end of the text. Statements without words are passed over.
  bool next(std::vector<ObjWord>& words) {
    words.clear();
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (isLineEnd(c)) {
        takeLineEnd();
        if (!words.empty()) return true;
      } else if (joinsLines()) {
        ++at_;
        takeLineEnd();
      } else if (c == '#') {
        while (at_ < text_.size() && !isLineEnd(text_[at_])) ++at_;
      } else if (isSpace(c)) {
        ++at_;
      } else {
        const std::size_t begin = at_;
        while (at_ < text_.size() && isWordPart()) ++at_;
        words.push_back({text_.substr(begin, at_ - begin), line_, static_cast<int>(begin - lineBegin_) + 1});
      }
    }
    return !words.empty();
  }

 private:
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  bool joinsLines() const { return text_[at_] == '\\' && at_ + 1 < text_.size() && isLineEnd(text_[at_ + 1]); }
  bool isWordPart() const {
    const char c = text_[at_];
    return !isSpace(c) && !isLineEnd(c) && c != '#' && !joinsLines();
  }
  void takeLineEnd() {
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++line_;
    lineBegin_ = at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, lineBegin_ = 0;
  int line_ = 1;
};

}  // namespace morula
