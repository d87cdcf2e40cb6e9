#pragma once
// A run as arrays for NumPy.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Returns the bytes of an .npz. Samples have different numbers of rows: one array holds all rows, those of sample i
/// from start[i] to start[i + 1]. `cell` is an index in the arrays of cells, `state` in `states`; NaN means absent.
/// - run_id, scenario (one text each), seed
/// - cells (n): paths, names, born, ended (NaN: alive), fates, last_states; states: substances
/// - samples (s): times; cell_start (s + 1), and for each living cell (c): cell, state, centroids (c × 3), and volumes,
///   areas, pressures, … : every measure of cell_sample but x, y, z, in the plural
/// - contact_start (s + 1), contacts (t × 2, cells), contact_areas (t)
/// - surfaces, of cells with bodies: surface_start (s + 1), surface_cell, surface_mesh, surface_bound (u; [length], max
///   error of a coordinate, up to rounding), vertex_start (u + 1), vertices (v × 3), and faces_M (f × 3) for each mesh
///   M, with corners counted from the surface's first vertex
std::string npzFile(const ExportedRun& run);

}  // namespace morula
