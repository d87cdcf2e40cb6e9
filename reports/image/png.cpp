// The PNG half of image.h. libpng's simplified interface: no longjmp, errors come back as text.
#include <png.h>

#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "image/image.h"

namespace morula {
namespace {

static_assert(sizeof(Colour) == 3, "an image's pixels are handed to libpng as they are");

png_image rgbImage() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

namespace {

constexpr std::size_t headerEnd = 8 + 25;  // the signature and the chunk IHDR, always the first

/// The check sum of a chunk [PNG specification, annex D].
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = 0xFFFFFFFF;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xEDB88320 ^ sum >> 1 : sum >> 1;
  }
  return ~sum;
}

std::string bigEndian(std::uint32_t n) {
  return {static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
          static_cast<char>(n)};
}

/// "Software: Morula", as the specification names it: libpng's simplified interface writes no texts.
const std::string& ownMark() {
  static const std::string mark = [] {
    const std::string text = std::string("Software") + '\0' + "Morula", chunk = "tEXt" + text;
    return bigEndian(static_cast<std::uint32_t>(text.size())) + chunk + bigEndian(crc(chunk));
  }();
  return mark;
}

}  // namespace

void writePng(const Image& image, const std::string& file) {
  if (image.pixels.empty()) throw InputError("an empty image cannot be written to '" + file + "'");
  png_image png = rgbImage();
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw FileError("'" + file + "' cannot be written: " + png.message);
  bytes.resize(size);
  bytes.insert(headerEnd, ownMark());
  writeFile(file, bytes, Content::picture);
}

bool isOwnPng(const std::string& file) {
  const std::string head = readHead(file, headerEnd + ownMark().size());
  return contentOf(head) == Content::picture && head.ends_with(ownMark());
}

Image readPng(const std::string& file) {
  const std::string bytes = readFile(file, std::uint64_t{1} << 30);
  png_image png = rgbImage();
  Image image;
  bool good = png_image_begin_read_from_memory(&png, bytes.data(), bytes.size());
  if (good && (png.width > 16384 || png.height > 16384)) {
    good = false;
    png_image_free(&png);
    std::strcpy(png.message, "larger than 16384 pixels");
  }
  if (good) {
    png.format = PNG_FORMAT_RGB;
    image = Image(int(png.width), int(png.height), {});
    const png_color white{255, 255, 255};
    good = png_image_finish_read(&png, &white, image.pixels.data(), 0, nullptr);
  }
  if (!good) throw FileError("'" + file + "' is not a PNG that can be read: " + png.message);
  return image;
}

}  // namespace morula
