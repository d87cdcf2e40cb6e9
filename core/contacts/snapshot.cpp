#include "contacts/snapshot.h"

#include <cstring>

namespace morula {

RowMemory asMemory(const SnapshotRow& r, Precision precision) {
  RowMemory memory;
  if (precision == Precision::binary64) {
    std::memcpy(&memory, &r, sizeof r);
    return memory;
  }
  const auto f = [](double a) { return static_cast<float>(a); };
  const SingleSnapshotRow row{
      f(r.x), f(r.y), f(r.z), f(r.nx), f(r.ny), f(r.nz), r.vx, r.vy, r.vz, r.inverseRadiusSquared, {}};
  std::memcpy(&memory, &row, sizeof row);
  return memory;
}

SnapshotRow readRow(const RowMemory& memory, Precision precision) {
  if (precision == Precision::binary64) {
    SnapshotRow row;
    std::memcpy(&row, &memory, sizeof row);
    return row;
  }
  SingleSnapshotRow r;
  std::memcpy(&r, &memory, sizeof r);
  return {r.x, r.y, r.z, r.nx, r.ny, r.nz, r.vx, r.vy, r.vz, r.inverseRadiusSquared};
}

}  // namespace morula
