#pragma once
// Surfaces of one time as a PLY file, for programs that show and repair meshes.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Binary, little-endian. A vertex: x, y, z (float), red, green, blue (uchar) of its cell's state, cell (int:
/// formats.cpp); a face: three vertices, counter-clockwise seen from outside. Cells stand one after the other, by path.
std::string plyFile(const ExportedRun& run, const Sample& sample);

}  // namespace morula
