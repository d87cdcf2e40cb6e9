#include "bench/peak_kernels.h"

namespace morula {

MORULA_TABLES(PeakKernels, peak, tables, )

const PeakKernels& peakKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
