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
      f(r.x), f(r.y), f(r.z), f(r.vx), f(r.vy), f(r.vz), r.nx, r.ny, r.nz, r.inverseRadiusSquared, {}};
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
  return {r.x, r.y, r.z, r.vx, r.vy, r.vz, r.nx, r.ny, r.nz, r.inverseRadiusSquared};
}

SurfaceRow readSurfaceRow(const RowMemory& memory, Precision precision) {
  if (precision == Precision::binary64) {
    SurfaceRow row;
    std::memcpy(&row, &memory, sizeof row);
    return row;
  }
  const SnapshotRow r = readRow(memory, precision);  // the normal stands in the velocity's place
  return {r.x,  r.y,  r.z, r.vx, r.vy, r.vz, r.nx, r.ny, r.nz, r.inverseRadiusSquared};
}

}  // namespace morula
