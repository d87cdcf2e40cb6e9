#include <algorithm>
#include <charconv>

#include "drawing/canvas.h"
#include "drawing/png_file.h"
#include "image/base64.h"

namespace morula {
namespace {

/// Returns the number with at most three decimals.
std::string shown(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 3);
  std::string number(text, error == std::errc() ? end : text);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return number == "-0" || number.empty() ? "0" : number;
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + shown(value) + '"'; }

std::string shown(Colour c) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {c.r, c.g, c.b}) text += {digits[channel >> 4], digits[channel & 15]};
  return text;
}

std::string fill(Colour c) { return " fill=\"" + shown(c) + '"'; }

/// Returns the text for XML, in which control characters must not be.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '&') result += "&amp;";
    else if (static_cast<unsigned char>(c) < 0x20) result += "\uFFFD";
    else result += c;
  return result;
}

struct PathData {
  std::string text;
  void add(const char* command, std::initializer_list<Spot> spots) {
    text += command;
    for (const Spot& p : spots) text += ' ' + shown(p.x) + ' ' + shown(p.y);
  }
  void moveTo(Spot a) { add("M", {a}); }
  void lineTo(Spot a) { add("L", {a}); }
  void curveTo(Spot a, Spot b, Spot c) { add("C", {a, b, c}); }
};

}  // namespace

SvgFile::SvgFile(int width, int height, const Print& print)
    : bytes_("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Morula -->\n") {
  const auto side = [&](int pixels) {
    return print.onPaper() ? shown(pixels * print.pixel * 25.4 / 72) + "mm" : shown(pixels * print.dots()) + "px";
  };
  bytes_ += "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"" +
            side(width) + "\" height=\"" + side(height) + "\" viewBox=\"0 0 " + shown(width) + ' ' + shown(height) +
            "\">\n<g stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"DejaVu Sans, Verdana, "
            "sans-serif\" xml:space=\"preserve\">\n";
}

void SvgFile::line(const std::vector<Spot>& points, const Stroke& stroke) {
  PathData path;
  trace(path, points, stroke.rounding);
  bytes_ += "<path fill=\"none\" stroke=\"" + shown(stroke.colour) + '"' + attribute("stroke-width", stroke.width) +
            (stroke.dashed ? " stroke-dasharray=\"" + shown(dashes[0]) + ' ' + shown(dashes[1]) + '"' : "") + " d=\"" +
            path.text + "\"/>\n";
}

void SvgFile::disc(Spot centre, double radius, Colour colour) {
  bytes_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) + fill(colour) +
            "/>\n";
}

void SvgFile::area(const std::vector<Spot>& points, Colour colour) {
  PathData path;
  trace(path, points, 0);
  bytes_ += "<path" + fill(colour) + " d=\"" + path.text + "Z\"/>\n";
}

void SvgFile::box(Spot topLeft, double width, double height, Colour colour) {
  bytes_ += "<rect" + attribute("x", topLeft.x) + attribute("y", topLeft.y) + attribute("width", std::max(0.0, width)) +
            attribute("height", std::max(0.0, height)) + fill(colour) + "/>\n";
}

void SvgFile::text(Spot baseline, const std::string& text, const TextStyle& style) {
  if (text.empty()) return;
  bytes_ += "<text" + attribute("x", baseline.x) + attribute("y", baseline.y) + attribute("font-size", style.size);
  // Another font has letters of other widths: they are made as wide as the layout expects.
  bytes_ += attribute("textLength", textWidth(text, style)) + " lengthAdjust=\"spacingAndGlyphs\"";
  if (style.anchor != Anchor::left)
    bytes_ += std::string(" text-anchor=\"") + (style.anchor == Anchor::centre ? "middle\"" : "end\"");
  if (style.bold) bytes_ += " font-weight=\"bold\"";
  if (style.upward) bytes_ += " transform=\"rotate(-90 " + shown(baseline.x) + ' ' + shown(baseline.y) + ")\"";
  if (style.halo > 0)
    bytes_ += " paint-order=\"stroke\" stroke=\"" + shown(paper) + '"' + attribute("stroke-width", 2 * style.halo);
  bytes_ += fill(style.colour) + '>' + escaped(text) + "</text>\n";
}

void SvgFile::image(Spot topLeft, const Image& image, double pixel) {
  bytes_ += "<image" + attribute("x", topLeft.x) + attribute("y", topLeft.y) + attribute("width", pixel * image.width) +
            attribute("height", pixel * image.height) + " xlink:href=\"data:image/png;base64," +
            base64(pngFile(image)) + "\"/>\n";
}

}  // namespace morula
