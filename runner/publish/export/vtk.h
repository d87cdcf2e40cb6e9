#pragma once
// Surfaces over time for ParaView and other programs with VTK: a PolyData file (.vtp) for each time, and a collection
// (.pvd) that says at what time each is.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// One sample with surfaces. Points in double precision, appended as raw bytes. Each triangle has the fields of the
/// cell that it belongs to: `cell` and `state` (numbers, formats.cpp), `colour`, and every measure of cell_sample under
/// its name; NaN where there is none. The file's own fields: TimeValue, run_id, states, and the paths of the cells by
/// `cell`.
std::string vtpFile(const ExportedRun& run, const Sample& sample);

/// `names` of the files beside it, one for each sample of the run.
std::string pvdFile(const ExportedRun& run, const std::vector<std::string>& names);

}  // namespace morula
