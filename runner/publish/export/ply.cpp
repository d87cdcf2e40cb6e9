#include "export/ply.h"

#include <fmt/format.h>

#include "base/number_text.h"
#include "files/bytes.h"

namespace morula {

std::string plyFile(const ExportedRun& run, const Sample& sample) {
  std::string vertices, faces;
  std::int32_t vertexCount = 0;
  std::size_t faceCount = 0;
  for (const CellSurface& s : sample.surfaces) {
    const CellMeasures* measures = ExportedRun::measuresOf(sample, s.path);
    const Colour colour = measures ? run.colourOf(s.path, measures->state) : neutralGrey;
    for (const Point& x : vertexPositions(s)) {
      putFloat(vertices, x.x), putFloat(vertices, x.y), putFloat(vertices, x.z);
      put8(vertices, colour.r), put8(vertices, colour.g), put8(vertices, colour.b);
      put32(vertices, std::int32_t{run.cellNumber(s.path)});
    }
    for (const Face& face : run.meshOf(s).faces) {
      put8(faces, 3);
      for (const std::int32_t corner : face) put32(faces, vertexCount + corner);
    }
    vertexCount += static_cast<std::int32_t>(s.numbers.size());
    faceCount += run.meshOf(s).faces.size();
  }
  return fmt::format(
             "ply\nformat binary_little_endian 1.0\ncomment Morula run {}, time {}\nelement vertex {}\n"
             "property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
             "property uchar blue\nproperty int cell\nelement face {}\nproperty list uchar int vertex_indices\n"
             "end_header\n",
             run.run.id, exactText(sample.world.time), vertexCount, faceCount) +
         vertices + faces;
}

}  // namespace morula
