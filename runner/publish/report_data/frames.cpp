#include "report_data/frames.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "contacts/contacts.h"
#include "files/bytes.h"
#include "physics/integrator.h"
#include "simulation/restore.h"

namespace morula {
namespace {

std::vector<ForceKind> kindsOf(const World& world) {
  if (!world.bodies || kindOf(world.bodies->parameters.integrator).solvesForces) return {};
  const Bodies& bodies = *world.bodies;
  std::vector<ForceKind> kinds;
  const auto add = [&](bool has, ForceKind kind) {
    if (has) kinds.push_back(kind);
  };
  add(bodies.model().hasMembrane, ForceKind::spring);
  add(bodies.model().hasMembrane, ForceKind::pressure);
  add(world.contacts.has_value(), ForceKind::contact);
  add(world.connections || (world.contacts && world.contacts->parameters.adhesion), ForceKind::adhesion);
  add(bodies.model().hasMembrane && bodies.parameters.shell, ForceKind::shell);
  add(true, ForceKind::other);
  return kinds;
}

/// Returns the largest component [force].
double largest(const std::vector<Vector>& forces) {
  double most = 0;
  for (const Vector& f : forces) most = std::max({most, std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  return most;
}

/// The places over the box of a cell's vertices: multiples of a power of two.
struct Grid {
  std::array<double, 3> low;  // [step]
  double step;

  explicit Grid(const std::vector<Point>& vertices) {
    std::array<double, 3> least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Point& p : vertices)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = coordinate(p, axis);
        least[axis] = std::min(least[axis], x), most[axis] = std::max(most[axis], x);
      }
    const double side = std::max({most[0] - least[0], most[1] - least[1], most[2] - least[2]});
    step = side > 0 ? std::ldexp(1, std::ilogb(side) - 10) : 1;  // 1024 to 2048 steps
    for (std::size_t axis = 0; axis < 3; ++axis) low[axis] = std::floor(least[axis] / step);
  }

  Point corner() const { return {low[0] * step, low[1] * step, low[2] * step}; }

  static double coordinate(const Point& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

  std::uint16_t place(std::size_t axis, const Point& p) const {
    return static_cast<std::uint16_t>(std::clamp(std::nearbyint(coordinate(p, axis) / step) - low[axis], 0.0, 65535.0));
  }
};

/// Adds the nearest float with 16 binary digits.
void putShort(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  put32(bytes, std::isfinite(value) ? (bits + 0x80) & ~std::uint32_t{0xff} : bits);
}

std::uint32_t numberAmong(const World& world, const CellPath& path) {
  return static_cast<std::uint32_t>(cellNumber(world.cells, path));
}

}  // namespace

ForceMeter::ForceMeter(World twin) : twin_(std::move(twin)), kinds_(kindsOf(twin_)) {}

std::vector<ForcesByKind> ForceMeter::at(const World& world) {
  if (kinds_.empty()) return {};
  try {
    restoreState(twin_, saveState(world));
    return forcesByKind(twin_);
  } catch (const NumericalError&) { return {}; }  // the run's own next step will report the failure
}

Vector netForce(const ForcesByKind& cell, ForceKind kind) {
  Vector net;
  for (const Vector& f : cell[std::size_t(kind)]) net += f;
  return net;
}

std::vector<ForceKind> kindsWithNetForce(const std::vector<ForceKind>& kinds) {
  std::vector<ForceKind> some;
  for (const ForceKind kind : kinds)
    if (kind != ForceKind::spring && kind != ForceKind::pressure) some.push_back(kind);
  return some;
}

void putNetForces(std::string& bytes, const std::vector<ForcesByKind>& forces, std::size_t cells,
                  const std::vector<ForceKind>& kinds) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < cells; ++i)
    for (const ForceKind kind : kinds) {
      const Vector net = i < forces.size() ? netForce(forces[i], kind) : Vector{none, none, none};
      for (const double x : {net.x, net.y, net.z}) putShort(bytes, x);
    }
}

void putVertexForces(std::string& bytes, const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds) {
  std::string numbers;
  for (const ForcesByKind& cell : forces) {
    double most = 0;
    for (const ForceKind kind : kinds) most = std::max(most, largest(cell[std::size_t(kind)]));
    for (const ForceKind kind : kinds) {
      const auto& onVertex = cell[std::size_t(kind)];
      const double ofKind = largest(onVertex);
      const float step = ofKind > 1e-9 * most ? static_cast<float>(ofKind / 127) : 0;
      putFloat(bytes, step);
      if (!(step > 0)) continue;
      for (const Vector& f : onVertex)
        for (const double x : {f.x, f.y, f.z}) {
          const double number = std::clamp(std::nearbyint(x / step), -127.0, 127.0);
          numbers += static_cast<char>(static_cast<std::int8_t>(number));
        }
    }
  }
  bytes += numbers;
  fillBytes(bytes);
}

FrameTaker::FrameTaker(double end, std::size_t most, std::optional<ForceMeter> forces)
    : end_(end), most_(most), meter_(std::move(forces)) {
  if (meter_) frames_.forces = meter_->kinds();
  for (const CellMeasure& m : sampledMeasures<CellContext>()) frames_.measures.push_back(m.name);
}

std::uint32_t FrameTaker::meshNumber(FrameMesh mesh) {
  auto& meshes = frames_.meshes;
  const auto found = std::find(meshes.begin(), meshes.end(), mesh);
  if (found != meshes.end()) return static_cast<std::uint32_t>(found - meshes.begin());
  meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(meshes.size() - 1);
}

std::uint32_t FrameTaker::stateNumber(StateId state) {
  const auto [entry, isNew] = stateNumbers_.emplace(state, frames_.states.size());
  if (isNew) frames_.states.push_back(state);
  return entry->second;
}

double FrameTaker::dueTime(std::size_t k) const {
  return most_ < 2 || k + 1 >= most_ ? end_ : end_ * static_cast<double>(k) / static_cast<double>(most_ - 1);
}

std::uint64_t FrameTaker::stepsUntilDue(const World& world) const {
  return world.bodies && next_ < most_ ? stepsUntil(world.clock, dueTime(next_)) : neverDue;
}

void FrameTaker::see(const World& world) {
  if (!world.bodies || next_ >= most_ || world.clock.time < dueTime(next_)) return;
  while (next_ < most_ && world.clock.time >= dueTime(next_)) ++next_;
  take(world);
}

void FrameTaker::take(const World& world) {
  const Observation now(world);
  const auto measured = measureCells(now);
  const std::size_t count = world.cells.path.size();
  Frame frame{.time = world.clock.time,
              .step = world.clock.step,
              .cells = static_cast<std::uint32_t>(count),
              .vertexForces = 0,
              .bytes = {}};
  std::string places;
  const bool areSpheres = world.bodies->areSpheres();
  const int levels = areSpheres ? 0 : levelsCoarser(static_cast<std::size_t>(world.bodies->livingVertices));
  bool isCoarser = false;  // not if all meshes are the coarsest ones, or no icospheres
  const std::uint32_t ball = areSpheres ? meshNumber(ballFor(count)) : 0;
  const auto putHead = [&](std::size_t i, std::uint32_t mesh, const Point& low, double step) {
    put32(frame.bytes, world.cells.entry[i]);
    put32(frame.bytes, mesh);
    put32(frame.bytes, stateNumber(world.cells.state[i]));
    for (const double x : {low.x, low.y, low.z, step}) putFloat(frame.bytes, x);
    for (const auto& value : measured[i].values)
      putShort(frame.bytes, value.value_or(std::numeric_limits<double>::quiet_NaN()));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Bodies& bodies = *world.bodies;
    const int slot = bodies.slots[i];
    if (areSpheres) {
      putHead(i, ball, bodies.vertex(slot, 0), bodies.restScale[slot] * norm(bodies.surface.vertices[0]));
      continue;
    }
    Mesh shape = coarserShape(takeSurface(bodies, slot), levels);
    isCoarser = isCoarser || std::ssize(shape.vertices) < bodies.vertexCount(slot);
    const Grid grid(shape.vertices);
    putHead(i, meshNumber({std::move(shape.faces), {}}), grid.corner(), grid.step);
    for (const Point& p : shape.vertices)
      for (std::size_t axis = 0; axis < 3; ++axis) put16(places, grid.place(axis, p));
  }
  for (const ContactArea& contact : now.contacts()) {
    put32(frame.bytes, static_cast<std::uint32_t>(contact.a));
    put32(frame.bytes, static_cast<std::uint32_t>(contact.b));
    putShort(frame.bytes, contact.area);
    ++frame.contacts;
  }
  if (world.connections)
    for (const std::size_t place : world.connections->active) {
      const ConnectionRecord& held = world.connections->history[place];
      put32(frame.bytes, numberAmong(world, held.a));
      put32(frame.bytes, numberAmong(world, held.b));
      ++frame.connections;
    }
  if (meter_) lastForces_ = meter_->at(world);
  putNetForces(frame.bytes, lastForces_, count, kindsWithNetForce(frames_.forces));
  frame.bytes += places;
  fillBytes(frame.bytes);
  // A sphere has one force, and forces on a finer mesh have no place on a coarser one.
  if (areSpheres || isCoarser) lastForces_.clear();
  frames_.coarser += isCoarser;
  frames_.frames.push_back(std::move(frame));
  frames_.worlds.push_back(measureWorld(now));
}

Frames& FrameTaker::frames() {
  if (!lastForces_.empty()) {
    Frame& last = frames_.frames.back();
    last.vertexForces = last.bytes.size();
    putVertexForces(last.bytes, lastForces_, frames_.forces);
    lastForces_.clear();
  }
  return frames_;
}

void dropVertexForces(Frames& frames) {
  for (Frame& frame : frames.frames)
    if (frame.vertexForces) frame.bytes.resize(std::exchange(frame.vertexForces, 0));
}

void thinFrames(Frames& frames, std::size_t maxBytes) {
  const auto& all = frames.frames;
  Frames kept = frames;
  for (std::size_t count = all.size(), bytes = 0; count > 0; count = std::min(count - 1, count * maxBytes / bytes)) {
    // Frames that stay are spread evenly; a single one is the last.
    kept.frames.clear();
    for (std::size_t k = 0; k < count; ++k)
      kept.frames.push_back(all[count < 2 ? all.size() - 1 : (k * (all.size() - 1) + (count - 1) / 2) / (count - 1)]);
    bytes = packedFrames(kept).size();
    if (bytes <= maxBytes) return void(frames.frames = std::move(kept.frames));
  }
  frames.frames.clear();
}

}  // namespace morula
