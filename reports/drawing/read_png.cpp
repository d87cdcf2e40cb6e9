#include "drawing/read_png.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "drawing/cairo.h"

namespace morula {
namespace {

constexpr std::size_t headEnd = 24;  // the signature, and of the first chunk length, type, width and height
constexpr std::size_t signature = 8, chunkFrame = 12;  // of each chunk length and type before it, a checksum behind it
constexpr std::uint64_t mostPixels = 100'000'000;

struct Reader {
  const std::string& bytes;
  std::size_t at = 0;
};

cairo_status_t take(void* closure, unsigned char* to, unsigned int count) {
  Reader& reader = *static_cast<Reader*>(closure);
  if (count > reader.bytes.size() - reader.at) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(to, reader.bytes.data() + reader.at, count);
  reader.at += count;
  return CAIRO_STATUS_SUCCESS;
}

std::uint64_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(bytes[at + i]);
  return n;
}

/// Each chunk ends before the file does: libpng takes memory for as many bytes as a chunk says it has.
bool chunksFit(const std::string& bytes) {
  for (std::size_t at = signature; at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    if (left < chunkFrame || bigEndian(bytes, at) > left - chunkFrame) return false;
    if (bytes.compare(at + 4, 4, "IEND") == 0) return true;  // what follows is not read
    at += chunkFrame + bigEndian(bytes, at);
  }
  return false;
}

}  // namespace

Image readPng(const std::string& bytes, const std::string& name) {
  if (bytes.size() < headEnd || !bytes.starts_with("\x89PNG\r\n\x1a\n"))
    throw InputError(name + ": not a PNG picture; give a .png");
  const std::uint64_t width = bigEndian(bytes, 16), height = bigEndian(bytes, 20);
  if (width * height > mostPixels)
    throw InputError(name + ": a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels is too large; needs at most " + std::to_string(mostPixels) + " pixels");
  const InputError damaged(name + ": a damaged PNG picture, or of a kind that is not read");
  if (!chunksFit(bytes)) throw damaged;
  Reader reader{bytes};
  const Surface surface(cairo_image_surface_create_from_png_stream(take, &reader));
  // What libpng refuses comes as want of memory in older versions of cairo: of a size that is fine, it is the file.
  const cairo_format_t format = cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS
                                    ? cairo_image_surface_get_format(surface.get())
                                    : CAIRO_FORMAT_INVALID;
  if (format != CAIRO_FORMAT_ARGB32 && format != CAIRO_FORMAT_RGB24) throw damaged;
  cairo_surface_flush(surface.get());
  Image image(static_cast<int>(width), static_cast<int>(height), paper);
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t pixel = 0;  // colours already multiplied by their opacity
      std::memcpy(&pixel, data + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), 4);
      const std::uint32_t opacity = format == CAIRO_FORMAT_ARGB32 ? pixel >> 24 : 255;
      const auto channel = [&](int shift, std::uint8_t below) {
        return static_cast<std::uint8_t>(
            std::min<std::uint32_t>(255, (pixel >> shift & 255) + (below * (255 - opacity) + 127) / 255));
      };
      image.at(x, y) = {channel(16, paper.r), channel(8, paper.g), channel(0, paper.b)};
    }
  return image;
}

}  // namespace morula
