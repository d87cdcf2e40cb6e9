#include "drawing/text.h"

#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "files/folders.h"

namespace morula {
namespace {

/// One thread's fonts: FreeType's objects are not to be shared between threads.
class Typefaces {
 public:
  Typefaces() {
    if (FT_Init_FreeType(&library_)) return;
    for (const bool bold : {false, true}) {
      const std::string file = findFont(bold);
      if (!file.empty() && FT_New_Face(library_, file.c_str(), 0, &faces_[bold])) faces_[bold] = nullptr;
    }
  }
  ~Typefaces() {
    if (library_) FT_Done_FreeType(library_);  // takes the faces with it
  }
  Typefaces(const Typefaces&) = delete;
  Typefaces& operator=(const Typefaces&) = delete;

  /// At the style's size; null if there is no font.
  FT_Face of(const TextStyle& style) const {
    const FT_Face face = style.bold && faces_[1] ? faces_[1] : faces_[0];
    if (!face || FT_Set_Char_Size(face, 0, FT_F26Dot6(std::lround(style.size * 64)), 72, 72)) return nullptr;
    return face;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face faces_[2] = {nullptr, nullptr};
};

const Typefaces& typefaces() {
  static thread_local const Typefaces mine;
  return mine;
}

/// Takes the first character off a text that is not empty; what is not UTF-8 is U+FFFD, a byte at a time.
char32_t takeUtf8(std::string_view& text) {
  const unsigned char lead = text[0];
  const std::size_t length = lead < 0x80       ? 1
                             : lead >> 5 == 6  ? 2
                             : lead >> 4 == 14 ? 3
                             : lead >> 3 == 30 ? 4
                                               : 0;
  char32_t code = length == 1 ? lead : lead & (0x7F >> length);
  bool good = length > 0 && length <= text.size();
  for (std::size_t k = 1; good && k < length; ++k) {
    const unsigned char next = text[k];
    good = next >> 6 == 2;
    code = code << 6 | (next & 0x3F);
  }
  text.remove_prefix(good ? length : 1);
  return good ? code : U'\uFFFD';
}

/// Calls `visit(pen position)` with each glyph loaded and `after(pen position behind it)`, which says whether
/// to go on; returns where the line ends. Unhinted, so that text scales evenly.
template <class Visit, class After>
double walk(FT_Face face, std::string_view& text, const Visit& visit, const After& after) {
  double pen = 0;
  FT_UInt previous = 0;
  while (!text.empty()) {
    const FT_UInt glyph = FT_Get_Char_Index(face, takeUtf8(text));
    FT_Vector kern{};
    if (previous && glyph && !FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kern))
      pen += kern.x / 64.0;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP)) continue;
    const double advance = face->glyph->linearHoriAdvance / 65536.0;
    visit(pen);
    pen += advance;
    previous = glyph;
    if (!after(pen)) break;
  }
  return pen;
}

constexpr auto always = [](double) { return true; };

void blend(Colour& under, Colour over, int cover) {
  const auto mix = [cover](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t((a * (255 - cover) + b * cover + 127) / 255);
  };
  under = {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

/// Draws the glyph that is loaded, its origin at (x, y); fractions of a pixel count.
void stamp(Image& image, FT_GlyphSlot slot, double x, double y, const TextStyle& style) {
  const int left = int(std::floor(x)), top = int(std::ceil(y));
  if (style.upward) {
    const FT_Matrix turn{0, -0x10000, 0x10000, 0};
    FT_Outline_Transform(&slot->outline, &turn);
  }
  FT_Outline_Translate(&slot->outline, FT_Pos(std::lround((x - left) * 64)),
                       FT_Pos(std::lround((top - y) * 64)));
  if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL)) return;
  const FT_Bitmap& bitmap = slot->bitmap;
  for (int row = 0; row < int(bitmap.rows); ++row)
    for (int column = 0; column < int(bitmap.width); ++column) {
      const int px = left + slot->bitmap_left + column, py = top - slot->bitmap_top + row;
      if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
      blend(image.at(px, py), style.colour, bitmap.buffer[row * bitmap.pitch + column]);
    }
}

}  // namespace

std::string findFont(bool bold) {
  const std::string name = bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf";
  for (const char* folder : {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/",
                             "/usr/share/fonts/dejavu/", "/usr/share/fonts/TTF/",
                             "/usr/share/fonts/ttf-dejavu/", "/usr/local/share/fonts/dejavu/"}) {
    if (fileExists(folder + name)) return folder + name;
  }
  return "";
}

double textWidth(std::string_view text, const TextStyle& style) {
  const FT_Face face = typefaces().of(style);
  return face ? walk(
                    face, text, [](double) {}, always)
              : 0;
}

void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style) {
  const FT_Face face = typefaces().of(style);
  if (!face) return;
  double back = 0;
  if (style.anchor != Anchor::left)
    back = textWidth(text, style) * (style.anchor == Anchor::centre ? 0.5 : 1);
  walk(
      face, text,
      [&](double pen) {
        const double along = pen - back;
        stamp(image, face->glyph, style.upward ? x : x + along, style.upward ? y - along : y, style);
      },
      always);
}

std::string_view beginningWiderThan(std::string_view text, const TextStyle& style, double width) {
  const FT_Face face = typefaces().of(style);
  if (!face) return text;
  // An em more than asked for: the next letter may stand closer to the last one, never by so much.
  std::string_view rest = text;
  walk(
      face, rest, [](double) {}, [&](double pen) { return pen <= width + style.size; });
  return text.substr(0, text.size() - rest.size());
}

std::string shortened(std::string_view text, const TextStyle& style, double width) {
  const std::string_view beginning = beginningWiderThan(text, style, width);
  if (beginning.size() == text.size() && textWidth(text, style) <= width) return std::string(text);
  text = beginning;  // from here down there are as many letters as fit into the width, and a few more
  while (!text.empty()) {
    std::size_t end = text.size() - 1;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
      --end;  // not inside a character
    text = text.substr(0, end);
    const std::string candidate = std::string(text) + "…";
    if (!text.empty() && textWidth(candidate, style) <= width) return candidate;
  }
  return "";
}

}  // namespace morula
