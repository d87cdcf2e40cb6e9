#pragma once
// How different two pictures of the same look, where their pixels need not be equal: drawn by other renderers.
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct PictureDifference {
  double most = 0;                // ΔE00 where they look most different
  int x = 0, y = 0;               // [pixel] where that is; the first such place in reading order
  double mean = 0;                // ΔE00 over all pixels
  double share = 0;               // [1] of the pixels, above noticeableDifference
  std::vector<double> map = {};   // ΔE00 of each pixel, row by row
  std::size_t unequalPixels = 0;  // that are not the same to the bit

  bool isNoticeable() const;
};

/// ΔE00 above which two pictures are called different: the difference that people just notice in a patch of colour
/// [Mahy, Van Eycken, Oosterlinck 1994: 2.3, in ΔE of 1976]. The same organism as drawn by softpipe in place of
/// llvmpipe comes to 1.0, moved sideways by one pixel to 19.
inline constexpr double noticeableDifference = 2.3;

/// CIEDE2000 [Sharma, Wu, Dalal 2005] between the two, pixel by pixel, after either has been smoothed in linear light
/// by a Gaussian of 1.5 pixels, for edges that are off by a share of a pixel are seen as the same, as in S-CIELAB
/// [Zhang & Wandell 1997]. Opacity is not looked at. Throws InputError if their sizes differ.
PictureDifference differenceOf(const Image& one, const Image& other);

/// Both and the map of their difference in a row, with a scale.
Drawing drawPictureDifference(const Image& one, const Image& other, const PictureDifference& difference,
                              const std::vector<std::string>& notes);

}  // namespace morula
