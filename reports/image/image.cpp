#include "image/image.h"

#include "base/error.h"

namespace morula {

void checkSides(int width, int height) {
  if (width < 1 || height < 1 || width > maxSide || height > maxSide)
    throw InputError("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels cannot be made; each side must be 1 to 16384");
}

Image::Image(int width, int height, Colour fill) : width(width), height(height) {
  checkSides(width, height);
  pixels.assign(std::size_t(width) * height, fill);
}

}  // namespace morula
