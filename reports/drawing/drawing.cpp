#include "drawing/drawing.h"

#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "drawing/cairo.h"
#include "drawing/canvas.h"
#include "drawing/png_file.h"

namespace morula {
namespace {

/// Convert between a channel and cairo's premultiplied channel.
std::uint32_t covered(std::uint8_t channel, std::uint32_t opacity) { return (channel * opacity + 127) / 255; }
std::uint8_t uncovered(std::uint32_t channel, std::uint32_t opacity) {
  return opacity == 0 ? 0 : std::uint8_t(std::min(255u, (channel * 255 + opacity / 2) / opacity));
}

/// Returns a cairo surface of the image. cairo's pixels are numbers 0xrrggbb, or with opacity 0xaarrggbb.
Surface surfaceOf(const Image& image) {
  const bool opaque = image.opacity.empty();
  Surface surface(
      cairo_image_surface_create(opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image.width, image.height));
  requireSuccess(cairo_surface_status(surface.get()));
  unsigned char* row = cairo_image_surface_get_data(surface.get());
  for (int y = 0; y < image.height; ++y, row += cairo_image_surface_get_stride(surface.get())) {
    auto* to = reinterpret_cast<std::uint32_t*>(row);
    if (opaque) {
      std::transform(&image.at(0, y), &image.at(0, y) + image.width, to,
                     [](Colour c) { return std::uint32_t(c.r << 16 | c.g << 8 | c.b); });
      continue;
    }
    for (int x = 0; x < image.width; ++x) {
      const Colour c = image.at(x, y);
      const std::uint32_t a = image.opacity[std::size_t(y) * image.width + x];
      to[x] = a << 24 | covered(c.r, a) << 16 | covered(c.g, a) << 8 | covered(c.b, a);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

Image imageOf(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {});
  const unsigned char* row = cairo_image_surface_get_data(surface);
  const bool opaque = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_RGB24;
  for (int y = 0; y < image.height; ++y, row += cairo_image_surface_get_stride(surface)) {
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
    if (!opaque) {
      for (int x = 0; x < image.width; ++x) {
        const std::uint32_t p = pixels[x], a = p >> 24;
        image.opacity.push_back(std::uint8_t(a));
        image.at(x, y) = {uncovered(p >> 16 & 255, a), uncovered(p >> 8 & 255, a), uncovered(p & 255, a)};
      }
      continue;
    }
    std::transform(pixels, pixels + image.width, &image.at(0, y), colourFrom);
  }
  return image;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// A cairo surface, of which a unit is as long as a pixel of the drawing.
class CairoCanvas : public Canvas {
 public:
  CairoCanvas(cairo_surface_t* surface, double pixel) : context_(cairo_create(surface)) {
    cairo_scale(target(), pixel, pixel);
    cairo_set_line_cap(target(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(target(), CAIRO_LINE_JOIN_ROUND);
  }

  void line(const std::vector<Spot>& points, const Stroke& stroke) override {
    setColour(target(), stroke.colour);
    cairo_set_line_width(target(), stroke.width);
    cairo_set_dash(target(), dashes, stroke.dashed ? 2 : 0, 0);
    trace(*this, points, stroke.rounding);
    cairo_stroke(target());
  }
  void disc(Spot centre, double radius, Colour colour) override {
    cairo_new_path(target());  // without this a disc would begin where the words end
    cairo_arc(target(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    fill(colour);
  }
  void area(const std::vector<Spot>& points, Colour colour) override {
    trace(*this, points, 0);
    cairo_close_path(target());
    fill(colour);
  }
  void box(Spot topLeft, double width, double height, Colour colour) override {
    cairo_rectangle(target(), topLeft.x, topLeft.y, width, height);
    fill(colour);
  }
  void text(Spot baseline, const std::string& text, const TextStyle& style) override {
    showText(target(), baseline.x, baseline.y, text, style);
    cairo_new_path(target());
  }
  void image(Spot topLeft, const Image& image, double pixel) override {
    cairo_save(target());
    cairo_translate(target(), topLeft.x, topLeft.y);
    cairo_scale(target(), pixel, pixel);
    cairo_set_source_surface(target(), surfaceOf(image).get(), 0, 0);
    cairo_paint(target());
    cairo_restore(target());
  }

  void moveTo(Spot a) { cairo_move_to(target(), a.x, a.y); }
  void lineTo(Spot a) { cairo_line_to(target(), a.x, a.y); }
  void curveTo(Spot a, Spot b, Spot c) { cairo_curve_to(target(), a.x, a.y, b.x, b.y, c.x, c.y); }

  /// Throws if drawing has failed.
  void requireSuccess() { morula::requireSuccess(cairo_status(target())); }

 private:
  void fill(Colour colour) {
    setColour(target(), colour);
    cairo_fill(target());
  }
  cairo_t* target() { return context_.get(); }

  Context context_;
};

}  // namespace

Drawing::Drawing(int width, int height, Ground ground, const Print& print)
    : width_(width), height_(height), ground_(ground), print_(print) {
  checkSides(width, height);
}

void Drawing::line(const std::vector<Spot>& points, const Stroke& stroke) {
  if (points.empty() || !(stroke.width > 0)) return;
  marks_.push_back([=](Canvas& canvas) { canvas.line(points, stroke); });
}

void Drawing::disc(Spot centre, double radius, Colour colour) {
  marks_.push_back([=](Canvas& canvas) { canvas.disc(centre, radius, colour); });
}

void Drawing::area(const std::vector<Spot>& points, Colour colour) {
  if (points.empty()) return;
  marks_.push_back([=](Canvas& canvas) { canvas.area(points, colour); });
}

void Drawing::box(Spot topLeft, double width, double height, Colour colour) {
  marks_.push_back([=](Canvas& canvas) { canvas.box(topLeft, width, height, colour); });
}

void Drawing::text(Spot baseline, std::string_view text, const TextStyle& style) {
  marks_.push_back([=, text = validText(text)](Canvas& canvas) { canvas.text(baseline, text, style); });
}

void Drawing::image(double x, double y, const Image& image, double pixel) {
  marks_.push_back([=](Canvas& canvas) { canvas.image({x, y}, image, pixel); });
}

void Drawing::replay(Canvas& canvas) const {
  if (ground_ == Ground::paper) canvas.box({0, 0}, width_, height_, paper);
  for (const auto& mark : marks_) mark(canvas);
}

Image Drawing::pixels() const {
  // In print a dot need not be a pixel of the layout. Where it is but for rounding, nothing is scaled.
  const double dots = std::abs(print_.dots() - 1) < 0.01 ? 1 : print_.dots();
  const int width = int(std::lround(dots * width_)), height = int(std::lround(dots * height_));
  checkSides(width, height);
  const Surface surface(
      cairo_image_surface_create(ground_ == Ground::paper ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, width, height));
  CairoCanvas canvas(surface.get(), dots);
  replay(canvas);
  canvas.requireSuccess();
  return imageOf(surface.get());
}

std::string Drawing::file(PictureFormat format) const {
  if (format == PictureFormat::png) return pngFile(pixels(), print_.onPaper() ? printDots : 0);
  if (format == PictureFormat::svg) {
    SvgFile svg(width_, height_, print_);
    replay(svg);
    return svg.finish();
  }
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append, &bytes, print_.pixel * width_, print_.pixel * height_));
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_5);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Morula");
  {
    CairoCanvas canvas(surface.get(), print_.pixel);
    replay(canvas);
    canvas.requireSuccess();
  }
  cairo_surface_finish(surface.get());
  requireSuccess(cairo_surface_status(surface.get()));
  return bytes;
}

double crisp(double place) { return std::floor(place) + 0.5; }

}  // namespace morula
