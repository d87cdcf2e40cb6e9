#include "drawing/drawing.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "drawing/cairo.h"
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

Spot between(Spot a, Spot b, double share) { return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}; }

void trace(cairo_t* target, const std::vector<Spot>& points, double rounding) {
  constexpr double quarterCircle = 0.5523;  // control points stand at this share of the way to the corner
  const auto before = [&](Spot corner, Spot other) {
    const double length = std::hypot(other.x - corner.x, other.y - corner.y);
    return between(corner, other, length > 0 ? std::min(0.5, rounding / length) : 0);
  };
  cairo_move_to(target, points.front().x, points.front().y);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Spot corner = points[i], from = before(corner, points[i - 1]), to = before(corner, points[i + 1]);
    const Spot one = between(from, corner, quarterCircle), other = between(to, corner, quarterCircle);
    cairo_line_to(target, from.x, from.y);
    if (rounding > 0) cairo_curve_to(target, one.x, one.y, other.x, other.y, to.x, to.y);
  }
  cairo_line_to(target, points.back().x, points.back().y);
}

constexpr std::string_view svgEnd = "?>\n";  // end of the first line

}  // namespace

Drawing::Drawing(int width, int height, Ground ground) : width_(width), height_(height), ground_(ground) {
  checkSides(width, height);
}

void Drawing::line(const std::vector<Spot>& points, const Stroke& stroke) {
  if (points.empty() || !(stroke.width > 0)) return;
  marks_.push_back([=](cairo_t* target) {
    constexpr double dashes[] = {9, 6};  // [pixel] drawn and blank
    setColour(target, stroke.colour);
    cairo_set_line_width(target, stroke.width);
    cairo_set_dash(target, dashes, stroke.dashed ? 2 : 0, 0);
    trace(target, points, stroke.rounding);
    cairo_stroke(target);
  });
}

void Drawing::disc(Spot centre, double radius, Colour colour) {
  marks_.push_back([=](cairo_t* target) {
    setColour(target, colour);
    cairo_arc(target, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_fill(target);
  });
}

void Drawing::area(const std::vector<Spot>& points, Colour colour) {
  if (points.empty()) return;
  marks_.push_back([=](cairo_t* target) {
    setColour(target, colour);
    trace(target, points, 0);
    cairo_close_path(target);
    cairo_fill(target);
  });
}

void Drawing::box(Spot topLeft, double width, double height, Colour colour) {
  marks_.push_back([=](cairo_t* target) {
    setColour(target, colour);
    cairo_rectangle(target, topLeft.x, topLeft.y, width, height);
    cairo_fill(target);
  });
}

void Drawing::text(Spot baseline, std::string_view text, const TextStyle& style) {
  marks_.push_back(
      [=, text = std::string(text)](cairo_t* target) { showText(target, baseline.x, baseline.y, text, style); });
}

void Drawing::image(int x, int y, const Image& image) {
  marks_.push_back([=](cairo_t* target) {
    cairo_set_source_surface(target, surfaceOf(image).get(), x, y);
    cairo_paint(target);
  });
}

void Drawing::replay(cairo_t* target) const {
  if (ground_ == Ground::paper) {
    setColour(target, paper);
    cairo_paint(target);
  }
  cairo_set_line_cap(target, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(target, CAIRO_LINE_JOIN_ROUND);
  for (const auto& mark : marks_) {
    mark(target);
    cairo_new_path(target);  // without this a disc would begin where the words end
  }
  requireSuccess(cairo_status(target));
}

Image Drawing::pixels() const {
  const Surface surface(
      cairo_image_surface_create(ground_ == Ground::paper ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, width_, height_));
  replay(Context(cairo_create(surface.get())).get());
  return imageOf(surface.get());
}

std::string Drawing::file(PictureFormat format) const {
  if (format == PictureFormat::png) return pngFile(pixels());
  std::string bytes;
  const bool svg = format == PictureFormat::svg;
  const Surface surface((svg ? cairo_svg_surface_create_for_stream : cairo_pdf_surface_create_for_stream)(
      append, &bytes, width_, height_));
  if (svg) cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  else {
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_5);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Morula");
  }
  replay(Context(cairo_create(surface.get())).get());
  cairo_surface_finish(surface.get());
  requireSuccess(cairo_surface_status(surface.get()));
  if (!svg) return bytes;
  // cairo numbers all surfaces of the process; without this number equal drawings give equal bytes.
  if (const auto id = bytes.find(" id=\"surface"); id != bytes.npos) bytes.erase(id, bytes.find('"', id + 5) + 1 - id);
  return bytes.insert(bytes.find(svgEnd) + svgEnd.size(), "<!-- Morula -->\n");
}

double crisp(double place) { return std::floor(place) + 0.5; }

}  // namespace morula
