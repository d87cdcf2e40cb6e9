#include "drawing/drawn_text.h"

#include <cairo-ft.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

#include "base/utf8.h"
#include "drawing/cairo.h"
#include "image/image.h"

namespace morula {
namespace {

using Face = CairoPointer<cairo_font_face_t, cairo_font_face_destroy>;
using ScaledFont = CairoPointer<cairo_scaled_font_t, cairo_scaled_font_destroy>;
using FontOptions = CairoPointer<cairo_font_options_t, cairo_font_options_destroy>;

const cairo_font_options_t* unhinted() {
  static const FontOptions options = [] {
    FontOptions o(cairo_font_options_create());
    cairo_font_options_set_hint_style(o.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(o.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(o.get(), CAIRO_ANTIALIAS_GRAY);
    return o;
  }();
  return options.get();
}

ScaledFont scaled(cairo_font_face_t* face, double size) {
  cairo_matrix_t asIs, sized;
  cairo_matrix_init_identity(&asIs);
  cairo_matrix_init_scale(&sized, size, size);
  return ScaledFont(cairo_scaled_font_create(face, &sized, &asIs, unhinted()));
}

/// Returns the font from its file. Asked by name, fontconfig would read its settings, and perhaps write a cache into
/// the user's home directory.
Face findFace(bool bold) {
  for (const std::string folder :
       {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/dejavu/",
        "/usr/share/fonts/TTF/", "/usr/share/fonts/ttf-dejavu/", "/usr/local/share/fonts/dejavu/"}) {
    const std::string file = folder + (bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf");
    FcPattern* pattern = FcPatternCreate();
    FcPatternAddString(pattern, FC_FILE, reinterpret_cast<const FcChar8*>(file.c_str()));
    Face face(cairo_ft_font_face_create_for_pattern(pattern));
    FcPatternDestroy(pattern);
    if (cairo_scaled_font_status(scaled(face.get(), 10).get()) == CAIRO_STATUS_SUCCESS) return face;
  }
  return Face(cairo_toy_font_face_create("sans-serif", CAIRO_FONT_SLANT_NORMAL,
                                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL));
}

cairo_font_face_t* face(bool bold) {
  static const std::array<Face, 2> faces{findFace(false), findFace(true)};
  return faces[bold].get();
}

struct Letters {
  std::string text;                 // valid UTF-8 without NUL
  std::vector<std::size_t> starts;  // first byte of each letter in `text`, and the end
};

/// Returns the letters of a text. A byte that is not UTF-8 becomes U+FFFD.
Letters lettersOf(std::string_view text) {
  Letters letters;
  while (!text.empty() && letters.starts.size() < maxLetters) {
    const int length = text[0] == 0 ? 0 : utf8Length(text);
    letters.starts.push_back(letters.text.size());
    letters.text += length > 0 ? text.substr(0, length) : "\uFFFD";
    text.remove_prefix(std::max(1, length));
  }
  letters.starts.push_back(letters.text.size());
  return letters;
}

constexpr const char* ellipsis = "…";

/// Returns the places [pixel] at which letters begin, and the end of the last one.
std::vector<double> edgesOf(const Letters& letters, const TextStyle& style) {
  const ScaledFont font = scaled(face(style.bold), style.size);
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  const std::string text = letters.text + ellipsis;  // the ellipsis begins where the text ends
  const auto status = cairo_scaled_font_text_to_glyphs(font.get(), 0, 0, text.data(), int(text.size()), &glyphs, &count,
                                                       nullptr, nullptr, nullptr);
  const std::unique_ptr<cairo_glyph_t, decltype(&cairo_glyph_free)> owned(glyphs, cairo_glyph_free);
  requireSuccess(status);
  std::vector<double> edges;
  for (int i = 0; i < count; ++i) edges.push_back(glyphs[i].x);
  return edges;
}

}  // namespace

std::string validText(std::string_view text) { return lettersOf(text).text; }

double textWidth(std::string_view text, const TextStyle& style) { return edgesOf(lettersOf(text), style).back(); }

std::string shortened(std::string_view text, const TextStyle& style, double width) {
  const Letters letters = lettersOf(text);
  const std::vector<double> edges = edgesOf(letters, style);
  if (edges.back() <= width && letters.starts.size() <= maxLetters) return letters.text;
  const double dots = textWidth(ellipsis, style);
  std::size_t kept = edges.size() - 1;
  while (kept > 0 && !(edges[kept] + dots <= width)) --kept;
  return kept == 0 ? "" : letters.text.substr(0, letters.starts[kept]) + ellipsis;
}

std::vector<std::string> wrapped(std::string_view text, const TextStyle& style, double width) {
  std::vector<std::string> lines{""};
  for (std::size_t end; !text.empty(); text.remove_prefix(std::min(text.size(), end + 1))) {
    end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end)), longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (lines.back().empty() || textWidth(longer, style) <= width) lines.back() = longer;
    else lines.push_back(word);
  }
  for (std::string& line : lines) line = shortened(line, style, width);
  return lines;
}

void showText(cairo_t* target, double x, double y, const std::string& shown, const TextStyle& style) {
  const double back =
      style.anchor == Anchor::left ? 0 : textWidth(shown, style) * (style.anchor == Anchor::centre ? 0.5 : 1);
  cairo_save(target);
  cairo_translate(target, x, y);
  if (style.upward) cairo_rotate(target, -std::numbers::pi / 2);
  cairo_move_to(target, -back, 0);
  cairo_set_font_face(target, face(style.bold));
  cairo_set_font_options(target, unhinted());
  cairo_set_font_size(target, style.size);
  if (style.halo > 0) {
    cairo_text_path(target, shown.c_str());
    setColour(target, paper);
    cairo_set_line_width(target, 2 * style.halo);
    cairo_stroke(target);
    cairo_move_to(target, -back, 0);
  }
  setColour(target, style.colour);
  if (cairo_surface_get_type(cairo_get_target(target)) == CAIRO_SURFACE_TYPE_IMAGE) {
    // Letters are drawn as shapes, because cairo would move glyphs to whole pixels.
    cairo_text_path(target, shown.c_str());
    cairo_fill(target);
  } else cairo_show_text(target, shown.c_str());
  cairo_restore(target);
}

}  // namespace morula
