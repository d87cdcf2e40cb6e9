// The PNG half of image.h. libpng's simplified interface: no longjmp, errors come back as text.
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "render/image.h"

namespace morula {
namespace {

static_assert(sizeof(Colour) == 3, "an image's pixels are handed to libpng as they are");

png_image rgbImage() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

void writePng(const Image& image, const std::string& file) {
  if (image.pixels.empty()) throw InputError("an empty image cannot be written to '" + file + "'");
  png_image png = rgbImage();
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGB;
  // Written beside its place and then moved there, so that nobody ever reads half a picture.
  const std::string partial = file + ".part";
  std::FILE* stream = std::fopen(partial.c_str(), "wb");
  if (!stream) throw FileError("'" + file + "' cannot be written: " + std::strerror(errno));
  std::string reason;
  if (!png_image_write_to_stdio(&png, stream, 0, image.pixels.data(), 0, nullptr)) reason = png.message;
  if (std::fclose(stream) != 0 && reason.empty()) reason = std::strerror(errno);
  std::error_code error;
  if (reason.empty()) {
    std::filesystem::rename(partial, file, error);
    if (error) reason = error.message();
  }
  if (!reason.empty()) {
    std::filesystem::remove(partial, error);
    throw FileError("'" + file + "' cannot be written: " + reason);
  }
}

Image readPng(const std::string& file) {
  // Opened here because libpng's own message would not name the file.
  std::FILE* stream = std::fopen(file.c_str(), "rb");
  if (!stream) throw FileError("'" + file + "' cannot be read: " + std::strerror(errno));
  png_image png = rgbImage();
  Image image;
  bool good = png_image_begin_read_from_stdio(&png, stream);
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
  std::fclose(stream);
  if (!good) throw FileError("'" + file + "' is not a PNG that can be read: " + png.message);
  return image;
}

}  // namespace morula
