#pragma once
// The words of figures for print, as their SVG and PDF files hold them: how large they are, and where.
#include <zlib.h>

#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace morula::test {

struct PrintedWords {
  std::string text;  // of PDF: ""
  double points;     // size of the font
  double left, top, right,
      bottom;  // [point] from the page's upper left corner, without descenders; of PDF the start alone
};

struct PrintedPage {
  double width = 0, height = 0;  // [point]
  std::vector<PrintedWords> words = {};
};

inline PrintedPage pageOfSvg(const std::string& svg) {
  PrintedPage page;
  std::smatch found;
  if (!std::regex_search(
          svg, found, std::regex("<svg [^>]* width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\" viewBox=\"0 0 ([0-9.]+) ")))
    return page;
  page.width = std::stod(found[1]) * 72 / 25.4, page.height = std::stod(found[2]) * 72 / 25.4;
  const double pixel = page.width / std::stod(found[3]);
  const std::regex element("<text ([^>]*)>([^<]*)</text>");
  for (std::sregex_iterator at(svg.begin(), svg.end(), element), end; at != end; ++at) {
    const std::string attributes = (*at)[1];
    const auto number = [&](const std::string& name) {
      std::smatch value;
      return std::regex_search(attributes, value, std::regex("(?:^| )" + name + "=\"(-?[0-9.]+)\""))
                 ? std::stod(value[1])
                 : NAN;
    };
    const auto has = [&](const char* part) { return attributes.find(part) != std::string::npos; };
    const double size = number("font-size"), length = number("textLength");
    const double back = has("=\"end\"")      ? length
                        : has("=\"middle\"") ? length / 2
                                             : 0,
                 x = number("x"), y = number("y");
    PrintedWords words{(*at)[2], size * pixel, x - back, y - 0.75 * size, x - back + length, y};
    if (has("rotate(-90"))
      words.left = x - 0.75 * size, words.right = x, words.top = y + back - length, words.bottom = y + back;
    for (double* place : {&words.left, &words.top, &words.right, &words.bottom}) *place *= pixel;
    page.words.push_back(words);
  }
  return page;
}

/// Returns the inflated streams of a PDF that zlib can inflate.
inline std::vector<std::string> streamsOf(const std::string& pdf) {
  std::vector<std::string> streams;
  for (std::size_t at = 0; (at = pdf.find("\nstream\n", at)) != pdf.npos;) {
    at += 8;
    const std::size_t end = pdf.find("endstream", at);
    std::string text(1 << 24, '\0');
    z_stream z{};
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(pdf.data() + at));
    z.avail_in = static_cast<uInt>(end - at);
    z.next_out = reinterpret_cast<Bytef*>(text.data()), z.avail_out = static_cast<uInt>(text.size());
    if (inflateInit(&z) != Z_OK) continue;
    if (inflate(&z, Z_FINISH) == Z_STREAM_END) streams.push_back(text.substr(0, z.total_out));
    inflateEnd(&z);
    at = end;
  }
  return streams;
}

struct Turn {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  /// Returns this one after `first`.
  Turn after(const Turn& m) const {
    return {m.a * a + m.b * c, m.a * b + m.b * d,     m.c * a + m.d * c,
            m.c * b + m.d * d, m.e * a + m.f * c + e, m.e * b + m.f * d + f};
  }
};

inline PrintedPage pageOfPdf(const std::string& pdf) {
  PrintedPage page;
  std::smatch box;
  std::string all = pdf;
  for (const std::string& stream : streamsOf(pdf)) all += stream;
  if (std::regex_search(all, box, std::regex("/MediaBox \\[ 0 0 ([0-9.]+) ([0-9.]+) \\]")))
    page.width = std::stod(box[1]), page.height = std::stod(box[2]);
  for (const std::string& stream : streamsOf(pdf)) {
    if (stream.find("BT\n") == stream.npos) continue;
    std::vector<Turn> kept{{}};
    std::vector<double> numbers;
    Turn text;
    double size = 0;
    std::istringstream words(stream);
    for (std::string word; words >> word;) {
      const auto six = [&] { return Turn{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]}; };
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (*end == '\0') {
        numbers.push_back(number);
        continue;
      }
      if (word == "q") kept.push_back(kept.back());
      else if (word == "Q" && kept.size() > 1) kept.pop_back();
      else if (word == "cm" && numbers.size() == 6) kept.back() = kept.back().after(six());
      else if (word == "Tm" && numbers.size() == 6) text = six();
      else if (word == "Tf" && !numbers.empty()) size = numbers.back();
      else if (word.starts_with("/")) continue;  // the name of a font
      else if (word.ends_with("Tj") || word.ends_with("TJ")) {
        const Turn t = kept.back().after(text);
        const double y = page.height - t.f;
        page.words.push_back({"", size * std::sqrt(std::abs(t.a * t.d - t.b * t.c)), t.e, y, t.e, y});
      }
      numbers.clear();
    }
  }
  return page;
}

/// Returns true if the fonts' letters are in the PDF.
inline bool holdsFonts(const std::string& pdf) {
  std::string all = pdf;
  for (const std::string& stream : streamsOf(pdf)) all += stream;
  return all.find("/FontFile") != all.npos;
}

/// Returns what is wrong with a page of this width [mm] with words of 7 pt: words that are not of 6 to 8 pt, are cut, or
/// lie beyond the page; "" if nothing is.
inline std::string wrongOn(const PrintedPage& page, double millimetres) {
  std::ostringstream wrong;
  constexpr double rounding = 0.01;  // [point] files hold three decimals of numbers
  if (std::abs(page.width - millimetres * 72 / 25.4) > rounding) wrong << "the page is " << page.width << " pt wide\n";
  if (page.words.empty()) wrong << "no words\n";
  for (const PrintedWords& w : page.words) {
    const std::string what = "'" + w.text + "' at " + std::to_string(w.left) + ", " + std::to_string(w.top);
    if (!(w.points > 6 - rounding && w.points < 8 + rounding)) wrong << what << " has " << w.points << " pt\n";
    if (!(w.left > 0 && w.top > 0 && w.right < page.width && w.bottom < page.height)) wrong << what << " is outside\n";
    if (w.text.find("…") != w.text.npos) wrong << what << " is cut\n";
  }
  return wrong.str();
}

}  // namespace morula::test
