#include "views/compare_pictures.h"

#include <fmt/format.h>

#include "drawing/png_file.h"
#include "files/read_file.h"

namespace morula {

ComparedPictures comparePictures(const std::string& one, const std::string& other) {
  ComparedPictures compared;
  compared.one = readPng(readFile(one), one);
  compared.other = readPng(readFile(other), other);
  const PictureDifference& d = compared.difference = differenceOf(compared.one, compared.other);
  if (d.unequalPixels == 0) compared.words = "the pictures have the same pixels\n";
  else
    compared.words = fmt::format(
        "{}: at most {:.3g} ΔE00, at pixel ({}, {}); needs at most {}\n"
        "  mean {:.3g}; {:.3g} % of the pixels differ noticeably, {:.3g} % at all\n",
        d.isNoticeable() ? "the pictures look different" : "the pictures look the same", d.most, d.x, d.y,
        noticeableDifference, d.mean, 100 * d.share,
        100 * static_cast<double>(d.unequalPixels) / static_cast<double>(d.map.size()));
  return compared;
}

Json toJson(const PictureDifference& d) {
  return {{"most", d.most},
          {"x", d.x},
          {"y", d.y},
          {"mean", d.mean},
          {"share", d.share},
          {"unequal_pixels", d.unequalPixels},
          {"threshold", noticeableDifference},
          {"passed", !d.isNoticeable()}};
}

Drawing drawCompared(const ComparedPictures& compared) {
  const PictureDifference& d = compared.difference;
  return drawPictureDifference(compared.one, compared.other, d,
                               {fmt::format("The first, the second, and how different they look: at most {:.3g} ΔE00 "
                                            "[CIEDE2000], at pixel ({}, {}).",
                                            d.most, d.x, d.y)});
}

}  // namespace morula
