// The simulator as a WebAssembly module for pages: functions that any JavaScript can call, without generated glue. The
// caller writes a text into the module's memory at the address of `place`, and reads answers at the address of `text`.
#include "wasm/module.h"

#include <vector>

#include "base/floating_point.h"
#include "library/scene_format.h"
#include "observation/measures.h"
#include "state/state_hash.h"

namespace morula::module {
namespace {

std::vector<float> places;

}  // namespace

/// Returns the place at which a page puts a text of `bytes` bytes for `open`.
MORULA_EXPORT(place) char* place(std::size_t bytes) {
  given.assign(bytes, '\0');
  return given.data();
}
/// The last answer: a hash, or the error of an `open` or `run` that failed.
MORULA_EXPORT(text) const char* text() { return said.data(); }
MORULA_EXPORT(textSize) std::size_t textSize() { return said.size(); }

/// Makes the world of the scene whose text was written at `place`.
MORULA_EXPORT(open) int open() {
  return outcomeOf([] {
    setFloatingPoint();
    begin(readScene(given, "scene"));
  });
}
/// Takes up to `most` steps, not past the end.
MORULA_EXPORT(run) int run(std::uint32_t most) {
  return outcomeOf([&] {
    const std::uint64_t end = world->clock.step + most;
    while (world->clock.step < end && !finished(*world)) takeSteps(*world, end - world->clock.step);
  });
}
MORULA_EXPORT(isFinished) bool isFinished() { return finished(*world); }
MORULA_EXPORT(stepNumber) double stepNumber() { return static_cast<double>(world->clock.step); }
MORULA_EXPORT(timeNow) double timeNow() { return world->clock.time; }
MORULA_EXPORT(cellCount) std::size_t cellCount() { return world->cells.path.size(); }

/// Answers with the state's hash.
MORULA_EXPORT(hash) int hash() {
  return outcomeOf([] { said = stateHash(*world).text(); });
}
/// Answers with the next link of the chain of hashes, as databases and goldens keep them.
MORULA_EXPORT(nextHash) int nextHash() {
  return outcomeOf([] {
    link = nextLink(link, *world).hash;
    said = link->text();
  });
}

/// The living cells by path: their numbers in the lineage, and x, y, z of all vertices, cell after cell.
MORULA_EXPORT(lineageNumbers) const std::uint32_t* lineageNumbers() { return world->cells.entry.data(); }
MORULA_EXPORT(vertices) const float* vertices() {
  places.clear();
  if (world->bodies)
    for (const CellPath& path : world->cells.path)
      for (const Point& p : cellVertices(*world, path))
        for (const double x : {p.x, p.y, p.z}) places.push_back(static_cast<float>(x));
  return places.data();
}
MORULA_EXPORT(vertexNumbers) std::size_t vertexNumbers() { return places.size(); }

}  // namespace morula::module
