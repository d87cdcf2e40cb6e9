#pragma once
// The colours of charts, trees and maps, in one place.
#include <cstddef>
#include <string_view>

#include "image/colour.h"

namespace morula {

inline constexpr Colour ink{0x1b, 0x1f, 0x24};       // titles, marks
inline constexpr Colour quietInk{0x5c, 0x63, 0x6b};  // axes, captions, legends
inline constexpr Colour gridInk{0xe6, 0xe6, 0xe2};

/// Returns the colour of series number i, from 0. No two of the first `manySeries` are alike. The first `fewSeries` are
/// told apart also by people who do not tell red from green, or blue from yellow [Okabe & Ito 2008, without
/// their yellow, which is too faint on paper]; draw those beyond them in another way as well, such as dashed.
Colour seriesColour(std::size_t i);
inline constexpr std::size_t fewSeries = 7, manySeries = 24;

/// Returns the colour of a clone, by the lineage path of its founder: letters A and B, of which the first `maxFounders`
/// count. Daughter A goes on in her mother's colour, so that no two cells that live at one time share one. The first
/// eight (of three divisions) are told apart by eyes of all kinds, and by lightness, for print in grey.
Colour cloneColour(std::string_view founder);
inline constexpr std::size_t maxFounders = 4;

/// Returns the colour of a quantity: `share` 0 (its least value) to 1 (its greatest); beyond, the colour of the nearer
/// end. Lightness rises with the share, so that order is seen in grey and by any eyes: viridis [van der Walt & Smith
/// 2015], in which equal steps look equal.
Colour scaleColour(double share);

}  // namespace morula
