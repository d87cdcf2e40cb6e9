#pragma once
// A Markdown document as tests read it: the commands that it shows with what they print, its paragraphs, and the numbers
// in a text.
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "files/text.h"
#include "launch.h"

namespace morula::test {

inline Words wordsOf(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

inline std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(' ') + 1 - first);
}

inline std::string withSingleBlanks(const std::string& line) {
  std::string text;
  for (const std::string& word : wordsOf(line)) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A command in a block of code of a document, and the lines that it prints. "…" stands for lines, and at the end of a
/// line for its rest.
struct Shown {
  Words command;  // without the program's name
  Words lines;
};

inline std::vector<Shown> shownIn(const std::string& markdown) {
  std::vector<Shown> shown;
  std::istringstream stream(markdown);
  bool inBlock = false, isShown = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inBlock = !inBlock, isShown = false;
    } else if (inBlock && line.starts_with("$ morula ")) {
      const auto words = wordsOf(line);
      shown.push_back({{words.begin() + 2, words.end()}, {}});
      isShown = true;
    } else if (isShown) {
      shown.back().lines.push_back(line);
    }
  }
  return shown;
}

/// A number in a text.
struct Number {
  std::size_t begin = 0, end = 0;
  double value = 0;
  int decimals = 0;  // after the point; of 6e-05 five
};

/// The numbers of a text, in their order. A part of a name (settle-0.03, F1) or of a reference (6.2.3) is none.
inline std::vector<Number> numbersIn(const std::string& text) {
  const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  const auto isName = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == '-');
  };
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t digits = i + (text[i] == '-');
    if (!isDigit(digits)) {
      ++i;
      continue;
    }
    Number number{i, digits, 0, 0};
    while (isDigit(number.end)) ++number.end;
    if (text[number.end] == '.' && isDigit(number.end + 1))
      for (++number.end; isDigit(number.end); ++number.end) ++number.decimals;
    if (text.compare(number.end, 2, "e-") == 0 && isDigit(number.end + 2)) {
      const std::size_t exponent = number.end + 2;
      for (number.end = exponent; isDigit(number.end);) ++number.end;
      number.decimals += std::stoi(text.substr(exponent, number.end - exponent));
    }
    const bool isPart =
        (i > 0 && isName(i - 1)) || isName(number.end) || (text[number.end] == '.' && isDigit(number.end + 1));
    number.value = std::stod(text.substr(i, number.end - i));
    if (!isPart) numbers.push_back(number);
    for (i = number.end; isPart && (isName(i) || (text[i] == '.' && isDigit(i + 1)));) ++i;
  }
  return numbers;
}

/// A paragraph of a document, and the comment below it: <!-- STUDY: PART OF A CLAIM; PART OF A LINE -->.
struct Paragraph {
  std::string text;  // on one line, without code and addresses of links
  std::string study;
  Words chosen;
};

/// Takes what stands between `open` and `close` out of a text.
inline std::string without(const std::string& text, const std::string& open, const std::string& close) {
  std::string rest;
  std::size_t at = 0;
  for (std::size_t begin; (begin = text.find(open, at)) != text.npos;) {
    rest += text.substr(at, begin - at);
    const std::size_t end = text.find(close, begin + open.size());
    if (end == text.npos) return rest;
    at = end + close.size();
  }
  return rest + text.substr(at);
}

inline std::vector<Paragraph> paragraphsOf(const std::string& markdown) {
  std::vector<Paragraph> paragraphs;
  std::istringstream lines(without(markdown, "```", "```") + "\n\n");
  std::string whole;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) {
      if (!line.starts_with("|") && !line.starts_with("#")) whole += (whole.empty() ? "" : " ") + trimmed(line);
      continue;
    }
    Paragraph& paragraph = paragraphs.emplace_back();
    const auto comment = whole.find("<!-- ");
    paragraph.text = without(without(whole.substr(0, comment), "`", "`"), "](", ")");
    if (comment != whole.npos) {
      const std::string words = whole.substr(comment + 5, whole.find(" -->", comment) - comment - 5);
      paragraph.study = words.substr(0, words.find(':'));
      for (const std::string& part : morula::partsOf(words.substr(paragraph.study.size() + 1), ';'))
        paragraph.chosen.push_back(trimmed(part));
    }
    whole.clear();
  }
  return paragraphs;
}

}  // namespace morula::test
