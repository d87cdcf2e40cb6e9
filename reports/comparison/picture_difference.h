#pragma once
// The difference of two pictures as people see it: pictures of different renderers need not have equal pixels.
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct PictureDifference {
  double most = 0;                // the largest ΔE00
  int x = 0, y = 0;               // [pixel] place of the largest ΔE00; the first one in reading order
  double mean = 0;                // ΔE00 over all pixels
  double share = 0;               // [1] share of the pixels above noticeableDifference
  std::vector<double> map = {};   // ΔE00 of each pixel, row by row
  std::size_t unequalPixels = 0;  // pixels that differ in any bit

  bool isNoticeable() const;
};

/// The ΔE00 above which two pictures are called different: the just noticeable difference of patches of colour [Mahy,
/// Van Eycken, Oosterlinck 1994: 2.3, in ΔE of 1976]. An organism drawn by softpipe and by llvmpipe differs by 1.0; one
/// moved sideways by a pixel by 19.
inline constexpr double noticeableDifference = 2.3;

/// Returns CIEDE2000 [Sharma, Wu, Dalal 2005] between two pictures, pixel by pixel. Both are first smoothed in linear
/// light by a Gaussian of 1.5 pixels, because people do not see edges that are off by a fraction of a pixel, as in
/// S-CIELAB [Zhang & Wandell 1997]. Opacity is ignored. Throws InputError if the sizes differ.
PictureDifference differenceOf(const Image& one, const Image& other);

/// Draws both pictures and the map of their difference in a row, with a colour bar.
Drawing drawPictureDifference(const Image& one, const Image& other, const PictureDifference& difference,
                              const std::vector<std::string>& notes);

}  // namespace morula
