#pragma once
// Rows: 64 bytes in one cache line, read and written by index for neighbours that lie anywhere. Turning
// `width` rows into columns of lanes is a transposition in registers, not a gather.
#if defined(MORULA_SINGLE)
#include "base/lane_rows_single.h"
#else
#include "base/lane_rows_double.h"
#endif
