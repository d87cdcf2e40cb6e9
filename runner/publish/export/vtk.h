#pragma once
// Surfaces over time for ParaView and other programs with VTK: a PolyData file (.vtp) for each time, and a collection
// (.pvd) of the files and their times.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Returns one sample with surfaces. Points have double precision and are appended as raw bytes. Each triangle has its
/// cell's fields: `cell` and `state` (numbers, formats.cpp), `colour`, and every measure of cell_sample under its name,
/// NaN if absent. The file's own fields: TimeValue, run_id, states, and the paths of the cells by `cell`.
std::string vtpFile(const ExportedRun& run, const Sample& sample);

/// Returns the collection. `names`: the files beside it, one for each sample of the run.
std::string pvdFile(const ExportedRun& run, const std::vector<std::string>& names);

}  // namespace morula
