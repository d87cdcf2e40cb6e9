#include "drawing/png_file.h"

#include <png.h>

#include <csetjmp>
#include <new>

#include "base/error.h"

namespace morula {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t headerEnd = 8 + 25;  // the signature and the chunk IHDR, which is always the first
constexpr std::uint64_t maxPixels = 100'000'000;

/// The chunk "Software: Morula" with its length before and its checksum behind [PNG specification, annex D].
constexpr std::string_view ownMark{
    "\0\0\0\x0f"
    "tEXtSoftware\0Morula\x19"
    "I\x11|",
    27};

[[noreturn]] void giveUp(png_structp png, png_const_charp /*why*/) { png_longjmp(png, 1); }

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, giveUp, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  std::vector<png_byte> row;
  std::string bytes;

  ~Writer() { png_destroy_write_struct(&png, &info); }
};

/// Appends to the writer's bytes, which have room reserved.
void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

/// Returns false if libpng has no memory, the only failure here. No object with a destructor may stand in this
/// function, because libpng leaves it by a long jump.
bool write(Writer& to, const Image& image, double perInch) {
  if (!to.info || setjmp(png_jmpbuf(to.png))) return false;
  const bool opaque = image.opacity.empty();
  png_set_write_fn(to.png, &to.bytes, append, [](png_structp) {});  // libpng's default would flush a file
  png_set_IHDR(to.png, to.info, image.width, image.height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const auto perMetre = static_cast<png_uint_32>(perInch / 0.0254 + 0.5);
  if (perMetre > 0) png_set_pHYs(to.png, to.info, perMetre, perMetre, PNG_RESOLUTION_METER);
  // For pictures of cells, a third of the time of libpng's defaults; files are larger by a seventh.
  png_set_compression_level(to.png, 4);
  png_set_filter(to.png, PNG_FILTER_TYPE_DEFAULT, PNG_FILTER_UP);
  png_write_info(to.png, to.info);
  for (int y = 0; y < image.height; ++y) {
    png_byte* out = to.row.data();
    for (int x = 0; x < image.width; ++x) {
      const Colour c = image.at(x, y);
      *out++ = c.r, *out++ = c.g, *out++ = c.b;
      if (!opaque) *out++ = image.opacity[std::size_t(y) * image.width + x];
    }
    png_write_row(to.png, to.row.data());
  }
  png_write_end(to.png, to.info);
  return true;
}

/// Returns true if each chunk ends before the file does. libpng allocates as many bytes as a chunk claims.
bool chunksFit(std::string_view left) {
  constexpr std::size_t frame = 12;  // length and type before, a checksum behind
  for (left.remove_prefix(signature.size()); left.size() >= frame;) {
    std::uint64_t length = 0;
    for (int i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(left[i]);
    if (length > left.size() - frame) return false;
    if (left.substr(4, 4) == "IEND") return true;  // libpng reads nothing after this chunk
    left.remove_prefix(frame + length);
  }
  return false;
}

}  // namespace

std::string pngFile(const Image& image, double perInch) {
  if (image.pixels.empty()) throw InputError("an empty image cannot be written");
  Writer to;
  to.row.resize(4 * std::size_t(image.width));
  const std::size_t pixels = 4 * image.pixels.size() + image.height;
  to.bytes.reserve(pixels + pixels / 100 + 4096);  // an upper bound also of incompressible pixels
  if (!write(to, image, perInch)) throw std::bad_alloc();
  to.bytes.insert(headerEnd, ownMark);
  to.bytes.shrink_to_fit();
  return std::move(to.bytes);
}

bool isOwnPng(std::string_view head) {
  return head.starts_with(signature) && head.size() > headerEnd && head.substr(headerEnd).starts_with(ownMark);
}

Image readPng(const std::string& bytes, const std::string& name) {
  if (bytes.size() < headerEnd || !bytes.starts_with(signature))
    throw InputError(name + ": not a PNG picture; give a .png");
  const InputError damaged(name + ": a damaged PNG picture, or of a kind that is not read");
  struct Reader : png_image {
    ~Reader() { png_image_free(this); }
  } png{};
  png.version = PNG_IMAGE_VERSION;
  if (!chunksFit(bytes) || !png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) throw damaged;
  if (png.width > maxSide || png.height > maxSide || std::uint64_t{png.width} * png.height > maxPixels)
    throw InputError(name + ": a picture of " + std::to_string(png.width) + " x " + std::to_string(png.height) +
                     " pixels is too large; needs at most " + std::to_string(maxPixels) + " pixels, and " +
                     std::to_string(maxSide) + " along a side");
  png.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(png));
  Image image(static_cast<int>(png.width), static_cast<int>(png.height), paper);
  if (!png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr)) throw damaged;
  const png_byte* in = pixels.data();
  for (Colour& c : image.pixels) {
    const auto over = [opacity = in[3]](png_byte channel, std::uint8_t below) {
      return static_cast<std::uint8_t>((channel * opacity + below * (255 - opacity) + 127) / 255);
    };
    c = {over(in[0], paper.r), over(in[1], paper.g), over(in[2], paper.b)};
    in += 4;
  }
  return image;
}

}  // namespace morula
