#include "image/image.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "catch.h"

namespace morula {
namespace {

namespace fs = std::filesystem;

/// A folder that is gone after the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("morula-test-image-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
};

Image speckled(int width, int height) {
  Image image(width, height, {});
  std::uint32_t x = 1;
  for (Colour& c : image.pixels) {
    x = x * 1664525u + 1013904223u;
    c = {std::uint8_t(x >> 24), std::uint8_t(x >> 16), std::uint8_t(x >> 8)};
  }
  return image;
}

std::string bytesOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

}  // namespace

TEST_CASE("images come back from PNG as they went", "[image]") {
  const Folder folder;
  for (const auto& [w, h] : {std::pair{1, 1}, {7, 3}, {256, 100}}) {
    const Image image = speckled(w, h);
    writePng(image, folder / "a.png");
    REQUIRE(readPng(folder / "a.png") == image);
    writePng(image, folder / "b.png");
    REQUIRE(bytesOf(folder / "a.png") == bytesOf(folder / "b.png"));
  }
}

TEST_CASE("files that cannot be written are named, and nothing half-written stays", "[image]") {
  const Folder folder;
  const Image image = speckled(4, 4);
  const std::string nowhere = folder / "no/such/folder.png";
  REQUIRE_THROWS_AS(writePng(image, nowhere), FileError);
  REQUIRE_THROWS_WITH(writePng(image, nowhere), ContainsSubstring(nowhere));
  fs::create_directories(folder.path / "taken.png" / "inside");  // a folder stands where the file should go
  REQUIRE_THROWS_AS(writePng(image, folder / "taken.png"), FileError);
  REQUIRE(std::distance(fs::directory_iterator(folder.path), {}) == 1);
  REQUIRE_THROWS_AS(writePng(Image(), folder / "empty.png"), InputError);
  if (fs::exists("/dev/full")) REQUIRE_THROWS_AS(writePng(speckled(300, 300), "/dev/full/x.png"), FileError);
}

TEST_CASE("files that are no PNG are refused", "[image]") {
  const Folder folder;
  REQUIRE_THROWS_AS(readPng(folder / "absent.png"), FileError);
  std::ofstream(folder / "text.png") << "not a picture";
  REQUIRE_THROWS_WITH(readPng(folder / "text.png"), ContainsSubstring("text.png"));
  writePng(speckled(64, 64), folder / "whole.png");
  const std::string whole = bytesOf(folder / "whole.png");
  std::ofstream(folder / "half.png", std::ios::binary) << whole.substr(0, whole.size() / 2);
  REQUIRE_THROWS_AS(readPng(folder / "half.png"), FileError);
}

TEST_CASE("an image's sides are checked", "[image]") {
  for (const auto& [w, h] : {std::pair{0, 5}, {5, 0}, {-1, 5}, {16385, 1}})
    REQUIRE_THROWS_AS(Image(w, h, paper), InputError);
}

TEST_CASE("pasting cuts off what does not fit", "[image]") {
  const Image stamp(4, 4, {9, 9, 9});
  for (int x = -6; x <= 12; ++x)
    for (int y = -6; y <= 12; ++y) {
      Image image(10, 10, {});
      paste(image, stamp, x, y);
      for (int py = 0; py < 10; ++py)
        for (int px = 0; px < 10; ++px) {
          const bool inside = px >= x && px < x + 4 && py >= y && py < y + 4;
          REQUIRE(image.at(px, py).r == (inside ? 9 : 0));
        }
    }
}

TEST_CASE("a contact sheet shows every image whole", "[image]") {
  std::vector<Image> images;
  for (int i = 0; i < 7; ++i) images.emplace_back(10 + i, 8, Colour{std::uint8_t(10 * i + 10), 0, 0});
  const Image sheet = contactSheet(images, 3, 2);
  REQUIRE(sheet.width == 3 * (16 + 2) + 2);
  REQUIRE(sheet.height == 3 * (8 + 2) + 2);
  for (int i = 0; i < 7; ++i) {
    const Colour colour{std::uint8_t(10 * i + 10), 0, 0};
    REQUIRE(std::count(sheet.pixels.begin(), sheet.pixels.end(), colour) == (10 + i) * 8);
  }
  REQUIRE(contactSheet({images[0]}).width == 10 + 16);
  REQUIRE_THROWS_AS(contactSheet({}), InputError);
}

}  // namespace morula
