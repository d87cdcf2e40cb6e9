#pragma once
// The colours of charts, trees and maps.
#include <cstddef>
#include <string_view>

#include "image/colour.h"

namespace morula {

inline constexpr Colour ink{0x1b, 0x1f, 0x24};       // titles, marks
inline constexpr Colour quietInk{0x5c, 0x63, 0x6b};  // axes, captions, legends
inline constexpr Colour gridInk{0xe6, 0xe6, 0xe2};

/// Returns the colour of series number i, from 0. No two of the first `manySeries` are alike. The first `fewSeries` can
/// be told apart also with colour blindness [Okabe & Ito 2008, without their yellow, which is too faint on paper]. In
/// grey print, and with colour blindness, series with one seriesMarker have different colours; so draw the marker, too.
Colour seriesColour(std::size_t i);
inline constexpr std::size_t fewSeries = 7, manySeries = 24;

/// Returns the colour of a clone, by the lineage path of its founder: letters A and B, of which the first `maxFounders`
/// count. Daughter A keeps her mother's colour, so no two cells of one time share a colour. The first eight (of three
/// divisions) can be told apart with colour blindness, and by lightness in grey print.
Colour cloneColour(std::string_view founder);
inline constexpr std::size_t maxFounders = 4;

/// Returns the colour of a quantity: `share` 0 (least value) to 1 (greatest); shares outside are clamped. Lightness
/// rises with the share, so that order shows in grey and with colour blindness: viridis [van der Walt & Smith 2015], in
/// which equal steps look equal.
Colour scaleColour(double share);

}  // namespace morula
