// Frames packed for a page.
#include <zlib.h>

#include <algorithm>
#include <map>
#include <new>
#include <vector>

#include "files/bytes.h"
#include "report_data/frames.h"

namespace morula {
namespace {

/// Numbers, written as all lowest bytes, then all next ones: bytes that are alike lie together.
template <class Unsigned>
struct Planes {
  std::vector<Unsigned> numbers;

  void addTo(std::string& bytes) const {
    for (std::size_t plane = 0; plane < sizeof(Unsigned); ++plane)
      for (const Unsigned n : numbers) put8(bytes, static_cast<std::uint8_t>(n >> (8 * plane)));
  }
};

/// Adds a table of 4-byte numbers column by column. Returns the place behind it.
std::size_t addTable(Planes<std::uint32_t>& words, const std::string& bytes, std::size_t at, std::size_t rows,
                     std::size_t columns) {
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t r = 0; r < rows; ++r)
      words.numbers.push_back(numberAt<std::uint32_t>(bytes, at + 4 * (r * columns + c)));
  return at + 4 * rows * columns;
}

/// A cell's vertices in a frame.
struct Shape {
  std::uint32_t step = 0;            // bits of a float
  std::vector<std::uint16_t> place;  // [3 vertex + axis] [step] in the cell's box
};

/// Adds a cell's places. `before`: its shape in the frame before, or an empty one.
void addPlaces(Planes<std::uint16_t>& places, const Shape& now, const Shape& before) {
  const bool isKnown = before.step == now.step && before.place.size() == now.place.size();
  for (std::size_t k = 0; k < now.place.size(); ++k) {
    const int by = now.place[k] - (isKnown ? before.place[k] : k >= 3 ? now.place[k - 3] : 0);
    places.numbers.push_back(static_cast<std::uint16_t>(by < 0 ? -2 * by - 1 : 2 * by));
  }
}

}  // namespace

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  // The bound on the size excludes every failure but one for want of memory.
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

std::string packedFrames(const Frames& frames) {
  Planes<std::uint32_t> words;
  Planes<std::uint16_t> places;
  std::string forces;
  std::map<std::uint32_t, Shape> before;  // by the cell's number
  const std::size_t columns = 7 + frames.measures.size(), kinds = kindsWithNetForce(frames.forces).size();
  std::vector<std::size_t> vertices;  // of each mesh
  for (const FrameMesh& mesh : frames.meshes) vertices.push_back(placesOf(mesh));
  for (const Frame& frame : frames.frames) {
    std::size_t at = addTable(words, frame.bytes, 0, frame.cells, columns);
    at = addTable(words, frame.bytes, at, frame.contacts, 3);
    at = addTable(words, frame.bytes, at, frame.connections, 2);
    at = addTable(words, frame.bytes, at, frame.cells, 3 * kinds);
    std::map<std::uint32_t, Shape> now;
    for (std::size_t i = 0; i < frame.cells; ++i) {
      const auto word = [&](std::size_t k) { return numberAt<std::uint32_t>(frame.bytes, 4 * (i * columns + k)); };
      Shape shape{.step = word(6), .place = {}};
      for (std::size_t k = 0; k < 3 * vertices[word(1)]; ++k, at += 2)
        shape.place.push_back(numberAt<std::uint16_t>(frame.bytes, at));
      addPlaces(places, shape, before[word(0)]);
      now[word(0)] = std::move(shape);
    }
    before = std::move(now);
    if (frame.vertexForces) forces += frame.bytes.substr(frame.vertexForces);
  }
  std::string bytes;
  words.addTo(bytes);
  places.addTo(bytes);
  return deflated(bytes + forces);
}

}  // namespace morula
