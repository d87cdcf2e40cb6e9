// parallelFor without oneTBB (MORULA_THREADS=OFF): always one thread, with the same bits.
#include "base/parallel.h"

namespace morula {

void parallelFor(int count, int, void (*body)(void*, int), void* context) {
  for (int i = 0; i < count; ++i) body(context, i);
}

int threadNumber() { return 0; }

}  // namespace morula
