// The pass of OrganismRenderer over translucent cells.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "organism/organism_passes.h"
#include "organism/veil_lists.h"

namespace morula {
namespace {

constexpr int samplesAtOnce = 4 << 20;                  // max samples counted at once
constexpr std::uint64_t fragmentsAtOnce = 4 << 20,      // max fragments stored and sorted at once; one row at least
    maxFragments = (128 << 20) / sizeof(VeilFragment);  // llvmpipe addresses no more

/// A translucent cell's triangles, the rows of the sample grid that they cover, and its greatest z in eye space.
struct Veil {
  CellCorners corners;
  int first, last;
  float nearest;
};

std::vector<Veil> veilsOf(const Surface& surface, double eyeDistance, double aperture, int gridHeight) {
  std::vector<Veil> veils;
  for (const CellCorners& corners : surface.cells) {
    if (corners.first < surface.solid) continue;
    double low = INFINITY, high = -INFINITY;
    float nearest = -INFINITY;
    for (std::size_t i = corners.first; i < corners.first + corners.count; ++i) {
      const float* p = surface.vertices[surface.corners[i]].position;
      const double depth = eyeDistance - p[2];
      const double y = depth > 0 ? p[1] / (aperture * depth) : p[1] < 0 ? -INFINITY : INFINITY;
      low = std::min(low, y), high = std::max(high, y), nearest = std::max(nearest, p[2]);
    }
    const auto row = [&](double y) { return int(std::floor(std::clamp(0.5 + 0.5 * y, 0.0, 1.0) * gridHeight)); };
    veils.push_back({corners, row(low) - 1, row(high) + 1, nearest});
  }
  std::stable_sort(veils.begin(), veils.end(), [](const Veil& a, const Veil& b) { return a.nearest > b.nearest; });
  return veils;
}

/// A buffer that shaders write and the program reads.
class SharedBuffer {
 public:
  SharedBuffer(GLuint binding) : binding_(binding) { glGenBuffers(1, &buffer_); }
  ~SharedBuffer() { glDeleteBuffers(1, &buffer_); }
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  void fill(std::size_t bytes, const void* data) {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes), data, GL_DYNAMIC_READ);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding_, buffer_);
  }
  /// Returns the buffer's contents for reading and writing, until release().
  void* contents(std::size_t bytes) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
    void* memory = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes), GL_MAP_READ_BIT | GL_MAP_WRITE_BIT);
    MORULA_CHECK(memory, "OpenGL gives no access to a buffer");
    return memory;
  }
  void release() {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
  }

 private:
  GLuint buffer_ = 0, binding_;
};

}  // namespace

void OrganismRenderer::drawVeils(const Frame& frame, std::vector<float>& seen) {
  if (frame.surface.corners.size() == frame.surface.solid) return;
  const int width = frame.gridWidth(), height = frame.gridHeight(), threads = threadsToDraw();
  seen.reserve(std::size_t(4) * width * height);
  const std::vector<Veil> veils = veilsOf(frame.surface, frame.framing.distance, frame.aperture.y, height);
  SharedBuffer cursors(0), fragments(1);
  // Solid cells stay, and hide translucent ones behind them.
  targets_->solid.framebuffer.bind();
  glViewport(0, 0, width, height);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  const Program &count = cellProgram(frame, CellPass::count), &list = cellProgram(frame, CellPass::list);
  const auto draw = [&](const Program& program, int first, int last) {
    std::vector<std::pair<std::size_t, std::size_t>> parts;
    for (const Veil& veil : veils)
      if (veil.last >= first && veil.first < last) parts.emplace_back(veil.corners.first, veil.corners.count);
    program.use();
    program.set("firstRow", first);
    glScissor(0, first, width, last - first);
    frame.cells->drawTriangles(parts);
  };
  // The grid is drawn in strips of rows to bound memory; outlines need some rows around each strip.
  const int margin = frame.outlineReach();
  const auto around = [&](int first, int last) {
    return std::pair(std::max(first - margin, 0), std::min(last + margin, height));
  };
  const int rowsAtOnce = std::max(1, samplesAtOnce / width);
  for (int block = 0; block < height; block += rowsAtOnce) {
    const int blockEnd = std::min(block + rowsAtOnce, height);
    const auto [low, high] = around(block, blockEnd);
    const std::size_t samples = std::size_t(width) * (high - low);
    std::vector<std::uint32_t> numbers(samples, 0);
    cursors.fill(4 * samples, numbers.data());
    draw(count, low, high);
    const auto* counted = static_cast<const std::uint32_t*>(cursors.contents(4 * samples));
    std::copy(counted, counted + samples, numbers.begin());
    cursors.release();
    std::vector<std::uint64_t> before{0};  // fragments in all rows before each row
    for (int y = low; y < high; ++y) {
      std::uint64_t inRow = 0;
      for (int x = 0; x < width; ++x) inRow += numbers[std::size_t(y - low) * width + x];
      before.push_back(before.back() + inRow);
    }
    for (int first = block, last; first < blockEnd; first = last) {
      const auto fragmentsOf = [&, low = low, high = high](int end) {  // clang 14 cannot capture structured bindings
        const auto [from, to] = around(first, end);
        return before[std::min(to, high) - low] - before[from - low];
      };
      for (last = first + 1; last < blockEnd && fragmentsOf(last + 1) <= fragmentsAtOnce;) ++last;
      const std::uint64_t many = fragmentsOf(last);
      if (many > maxFragments)
        throw InputError(
            "too many translucent cells lie behind each other; draw a smaller picture, or fewer samples per pixel");
      const auto [from, to] = around(first, last);
      const std::size_t lists = std::size_t(width) * (to - from);
      std::vector<std::uint32_t> starts(lists);
      std::uint32_t next = 0;
      for (std::size_t i = 0; i < lists; ++i) starts[i] = next, next += numbers[std::size_t(from - low) * width + i];
      cursors.fill(4 * lists, starts.data());
      fragments.fill(sizeof(VeilFragment) * std::max<std::size_t>(many, 1), nullptr);
      if (many > 0) draw(list, from, to);
      VeilRows rows{
          width, to - from,
          static_cast<VeilFragment*>(fragments.contents(sizeof(VeilFragment) * std::max<std::size_t>(many, 1))),
          static_cast<const std::uint32_t*>(cursors.contents(4 * lists))};
      sortVeils(rows, threads);
      const std::vector<float> part = composeVeils(rows, first - from, last - from, margin, threads);
      seen.insert(seen.end(), part.begin(), part.end());
      fragments.release(), cursors.release();
    }
  }
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace morula
