#pragma once
// Surfaces of one time as a PLY file, for programs that show and repair meshes.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Returns a binary, little-endian file. A vertex: x, y, z (float), red, green, blue (uchar) of its cell's state, cell
/// (int: formats.cpp). A face: three vertices, counter-clockwise seen from outside. Cells follow each other by path.
std::string plyFile(const ExportedRun& run, const Sample& sample);

}  // namespace morula
