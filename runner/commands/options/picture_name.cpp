#include "options/picture_name.h"

#include "base/error.h"
#include "pictures/pictures.h"

namespace morula::cli {

void checkPictureName(const std::string& verb, const std::string& file, bool drawing) {
  const auto format = pictureFormat(file);
  if (format && (drawing || *format == PictureFormat::png)) return;
  throw InputError(
      "'" + file + "' ends in " + std::filesystem::path(file).extension().string() + ", which " + verb +
      " cannot write; needs a name that ends in " +
      (drawing ? ".png, .svg or .pdf" : ".png, or of several pictures .mp4, .webm or .gif (shapes: morula export)"));
}

Reader<std::string> pictureName(const std::string& verb, bool drawing) {
  return [=](const std::string& file) { return checkPictureName(verb, file, drawing), file; };
}

std::string readPageName(const std::string& name) {
  if (const auto ending = std::filesystem::path(name).extension(); ending != ".html" && ending != ".htm")
    throw InputError("'" + name + "' does not end in .html, and a page is all that is written");
  return name;
}

}  // namespace morula::cli
