#pragma once
// From where an organism is seen: by name or by angles, and once around it.
#include <string_view>
#include <vector>

#include "organism/organism.h"

namespace morula {

/// The eye's direction by its azimuth and elevation [degrees]: (0, 0) looks along +y with z up, from the front; the
/// azimuth turns the eye towards +x, to the right side, the elevation lifts it towards +z.
Camera cameraAt(double azimuth, double elevation);

/// The angles of a named view: front, back, left, right, top, bottom, iso. Throws InputError with the names for any
/// other, and "AZ,EL" is read as two numbers [degrees], the elevation -90 to 90.
Camera parseView(std::string_view text);

/// The names, separated by commas.
const char* viewNames();

/// `count` > 0 cameras around the picture, turned about the z axis by equal angles, the first as its own: with one
/// framing in which it is whole from all of them.
std::vector<Camera> turntable(const OrganismPicture& picture, int count);

}  // namespace morula
