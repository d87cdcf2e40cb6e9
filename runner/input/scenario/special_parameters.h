#pragma once
// Parameters that are one of a kind: DNA, the time step, the shell's spellings, the size at division.
#include "values/parameter.h"

namespace morula::scenario {

Parameter dna();
Parameter timeStep();
Parameter shellSphere();
Parameter shellEllipsoid();
Parameter shellMesh();
Parameter shellFill();
/// division.size.
Parameter divisionSize();

}  // namespace morula::scenario
