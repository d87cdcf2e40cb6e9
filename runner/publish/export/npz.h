#pragma once
// A run as arrays for NumPy.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// The bytes of an .npz. Samples have different numbers of rows: the rows of all samples stand in one array, those of sample i
/// from start[i] to start[i + 1]. `cell` is a place in the arrays of cells, `state` one in `states`, absent numbers are NaN.
/// - run_id, scenario (one text each), seed
/// - cells (n): paths, names, born, ended (NaN: alive), fates, last_states; states: substances
/// - samples (s): times; cell_start (s + 1), and of each cell then (c): cell, state, centroids (c × 3), and volumes, areas,
///   pressures, … : every measure of cell_sample but x, y, z, in the plural
/// - contact_start (s + 1), contacts (t × 2, cells), contact_areas (t)
/// - surfaces, of cells with bodies: surface_start (s + 1), surface_cell, surface_mesh, surface_bound (u; [length], how far a
///   coordinate may be off at most, up to rounding), vertex_start (u + 1), vertices (v × 3), and faces_M (f × 3) for each mesh M:
///   corners counted from the surface's first vertex
std::string npzFile(const ExportedRun& run);

}  // namespace morula
