#include "image/image.h"

#include <algorithm>

#include "base/error.h"

namespace morula {

Image::Image(int width, int height, Colour fill) : width(width), height(height) {
  if (width < 1 || height < 1 || width > 16384 || height > 16384)
    throw InputError("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels cannot be made; each side must be 1 to 16384");
  pixels.assign(std::size_t(width) * height, fill);
}

void paste(Image& target, const Image& source, int x, int y) {
  const int left = std::max(0, x), right = std::min(target.width, x + source.width);
  if (left >= right) return;
  for (int row = std::max(0, y); row < std::min(target.height, y + source.height); ++row)
    std::copy_n(&source.at(left - x, row - y), right - left, &target.at(left, row));
}

Image contactSheet(const std::vector<Image>& images, int columns, int gap) {
  if (images.empty()) throw InputError("a contact sheet needs at least one image");
  const int count = int(images.size());
  if (columns <= 0)
    for (columns = 1; columns * columns < count;) ++columns;
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  int tileWidth = 0, tileHeight = 0;
  for (const Image& image : images) {
    tileWidth = std::max(tileWidth, image.width);
    tileHeight = std::max(tileHeight, image.height);
  }
  Image sheet(columns * (tileWidth + gap) + gap, rows * (tileHeight + gap) + gap, paper);
  for (int i = 0; i < count; ++i)
    paste(sheet, images[i], gap + i % columns * (tileWidth + gap) + (tileWidth - images[i].width) / 2,
          gap + i / columns * (tileHeight + gap) + (tileHeight - images[i].height) / 2);
  return sheet;
}

}  // namespace morula
