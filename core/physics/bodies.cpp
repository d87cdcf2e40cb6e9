#include "physics/bodies.h"

#include <algorithm>

#include "base/error.h"
#include "base/maths.h"
#include "mesh/nesting.h"
#include "physics/integrator.h"
#include "physics/sag.h"
#include "physics/stages.h"

namespace morula {
namespace {

/// Mass [mass] of a vertex in a lane without a cell.
double immovable(Precision precision) { return precision == Precision::binary64 ? 0x1p900 : 0x1p100; }

/// Gives every cell its slot, and every block its lines.
void arrange(Bodies& b, const std::vector<Body>& cells) {
  b.count = static_cast<int>(cells.size());
  b.slots.assign(cells.size(), -1);
  b.blocks.clear();
  b.livingVertices = 0;
  int lines = 0, coarsest = 0;
  for (const Body& cell : cells) coarsest = std::max(coarsest, cell.meshLevel);
  for (int meshLevel = 0; meshLevel <= coarsest; ++meshLevel) {
    const int vertices = b.meshAt(meshLevel).vertexCount();
    int lane = blockLanes;  // the first cell begins a block
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].meshLevel != meshLevel) continue;
      if (lane == blockLanes) {
        b.blocks.push_back({meshLevel, lines, 0});
        lines += vertices;
        lane = 0;
      }
      b.slots[i] = (b.blockCount() - 1) * blockLanes + lane++;
      b.blocks.back().liveLanes = lane;
      b.livingVertices += vertices;
    }
  }
  for (auto* a : {&b.position, &b.velocity, &b.acceleration}) a->assign(std::size_t(lines) * vertexStride, 0);
  if (kindOf(b.parameters.integrator).evaluations > 1) b.substeps.assign(std::size_t(lines) * vertexStride * 4, 0);
}

void place(Bodies& b, int slot, const Body& cell, double vertexMass) {
  MORULA_CHECK(static_cast<int>(cell.position.size()) == b.vertexCount(slot), "a cell has its mesh's vertices");
  b.vertexMass[slot] = vertexMass;
  b.restScale[slot] = cell.restScale;
  b.pressureConstant[slot] = cell.pressureConstant;
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    b.write(b.position, slot, v, cell.position[v]);
    b.write(b.velocity, slot, v, cell.velocity[v]);
  }
}

/// Returns a resting cell of the egg's size with one of the scene's meshes.
Body makeEgg(const Bodies& b, int meshLevel) {
  const Mesh& mesh = b.meshAt(meshLevel).mesh;
  return {.position = mesh.vertices,
          .velocity = std::vector<Vector>(mesh.vertices.size()),
          .mass = b.parameters.cell.mass,
          .pressureConstant = b.model().hasMembrane ? b.parameters.pressure.constant : 0,
          .meshLevel = meshLevel};
}

}  // namespace

KernelParameters kernelParametersOf(const PhysicsParameters& parameters) {
  const double* a = parameters.shell ? parameters.shell->semiAxes.data() : nullptr;
  const auto* planes = parameters.shell && parameters.shell->mesh ? &parameters.shell->mesh->planes : nullptr;
  return {.stiffness = parameters.membrane.stiffness,
          .damping = parameters.membrane.damping.fixed(),
          .dampingPerRoot = parameters.membrane.damping.perRoot(parameters.membrane.stiffness),
          .bending = parameters.membrane.bending,
          .outsidePressure = parameters.pressure.outside,
          .drag = parameters.drag,
          .semiAxes = {a ? a[0] : 1, a ? a[1] : 1, a ? a[2] : 1},
          .substeps = static_cast<int>(parameters.substeps.value_or(1)),
          .shapeStiffness = parameters.shapeMatching.stiffness,
          .shapeLinear = parameters.shapeMatching.linear,
          .shapeDamping = parameters.shapeMatching.damping,
          .radius = parameters.cell.radius,
          .planes = planes ? planes->data() : nullptr,
          .planeCount = planes ? static_cast<int>(planes->size()) : 0};
}

Bodies makeBodies(const PhysicsParameters& parameters, const Mesh& egg, int threads, const std::vector<Mesh>& coarser) {
  Bodies b;
  b.parameters = parameters;
  b.mesh = b.areSpheres() ? makeCentre(2 * parameters.cell.radius) : makeTemplate(egg, parameters.membrane.springs);
  if (b.areSpheres()) b.surface = egg;
  for (const Mesh& mesh : coarser) {
    const Mesh& finer = b.meshAt(static_cast<int>(b.coarser.size())).mesh;
    CoarserMesh next{
        makeTemplate(scaleToVolume(mesh, measureVolume(finer.vertices, finer.faces)), parameters.membrane.springs), {}};
    next.nested = findNested(next.mesh.mesh.vertices, finer.vertices);
    b.coarser.push_back(std::move(next));
  }
  b.kernelParameters = kernelParametersOf(b.parameters);
  const bool bends = b.model().hasMembrane && parameters.membrane.bending > 0;
  if (bends) {
    b.mesh.bending = makeBending(b.mesh);
    for (CoarserMesh& mesh : b.coarser) mesh.mesh.bending = makeBending(mesh.mesh);
  }
  if (b.model().hasRestShape) {
    b.mesh.rest = makeRestShape(b.mesh.mesh);
    for (CoarserMesh& mesh : b.coarser) mesh.mesh.rest = makeRestShape(mesh.mesh.mesh);
  }
  for (auto* a : {&b.position, &b.velocity, &b.acceleration, &b.substeps}) *a = Reals(parameters.precision);
  const Reals none(parameters.precision);
  b.scratch.assign(threads, {none, none, none, none});
  for (auto& s : b.scratch) {
    s.predicted.assign(std::size_t(b.mesh.vertexCount()) * vertexStride, 0);
    s.gradient.assign(std::size_t(b.mesh.vertexCount()) * vertexStride, 0);
    if (bends) s.curvature.assign(std::size_t(b.mesh.vertexCount()) * vertexStride, 0);
    s.coefficient.assign(std::size_t(b.mesh.edgeCount() + 1) * blockLanes, 0);  // the slack edge stays 0
  }
  return b;
}

int Bodies::vertexCount() const {
  MORULA_CHECK(coarser.empty(), "cells may have different meshes");
  return mesh.vertexCount();
}

BlockView Bodies::block(int index, int thread) {
  const BlockPlace& place = blocks[index];
  const std::size_t v = std::size_t(place.firstLine) * vertexStride, l = std::size_t(index) * blockLanes;
  Scratch& s = scratch[thread];
  // All meshes share the egg's slack edge, which stands behind its last edge and stays 0.
  const std::size_t coefficients = std::size_t(mesh.edgeCount() - meshAt(place.meshLevel).edgeCount()) * blockLanes;
  return {.meshLevel = place.meshLevel,
          .liveLanes = place.liveLanes,
          .position = position.from(v),
          .velocity = velocity.from(v),
          .acceleration = acceleration.from(v),
          .vertexMass = &vertexMass[l],
          .restScale = &restScale[l],
          .pressureConstant = &pressureConstant[l],
          .sag = &sag[l],
          .volume = &volume[l],
          .pressure = &pressure[l],
          .predicted = s.predicted.from(0),
          .gradient = s.gradient.from(0),
          .coefficient = s.coefficient.from(coefficients),
          .curvature = s.curvature.size() > 0 ? s.curvature.from(0) : RealPointer{nullptr},
          .substeps = substeps.size() > 0 ? substeps.from(4 * v) : RealPointer{nullptr}};
}

Body makeEgg(const Bodies& b) { return makeEgg(b, 0); }

Body takeBody(const Bodies& b, int slot) {
  Body cell;
  cell.mass = b.mass(slot);
  cell.restScale = b.restScale[slot];
  cell.pressureConstant = b.pressureConstant[slot];
  cell.meshLevel = b.blocks[slot / blockLanes].meshLevel;
  const int vertices = b.vertexCount(slot);
  cell.position.reserve(vertices);
  cell.velocity.reserve(vertices);
  for (int v = 0; v < vertices; ++v) {
    cell.position.push_back(b.read(b.position, slot, v));
    cell.velocity.push_back(b.read(b.velocity, slot, v));
  }
  return cell;
}

Mesh takeSurface(const Bodies& b, int slot) {
  if (b.areSpheres()) {
    Mesh ball = b.surface;
    for (Point& x : ball.vertices) x = b.vertex(slot, 0) + b.restScale[slot] * x;
    return ball;
  }
  Mesh mesh{std::vector<Point>(b.vertexCount(slot)), b.meshOf(slot).mesh.faces};
  for (int v = 0; v < b.vertexCount(slot); ++v) mesh.vertices[v] = b.vertex(slot, v);
  return mesh;
}

Point measureCentre(const Bodies& b, int slot) {
  const int vertices = b.vertexCount(slot);
  Vector sum;
  for (int v = 0; v < vertices; ++v) sum += b.vertex(slot, v);
  return sum / static_cast<double>(vertices);
}

void setVertexMass(Bodies& b, int slot, double mass) {
  const double ratio = b.vertexMass[slot] / mass;
  for (int v = 0; v < b.vertexCount(slot); ++v)
    b.write(b.acceleration, slot, v, ratio * b.read(b.acceleration, slot, v));
  b.vertexMass[slot] = mass;
}

void setBodies(Bodies& b, const std::vector<Body>& cells) {
  arrange(b, cells);
  const std::size_t lanes = std::size_t(b.blockCount()) * blockLanes;
  for (auto* a : {&b.vertexMass, &b.restScale, &b.pressureConstant, &b.sag, &b.volume, &b.pressure})
    a->assign(lanes, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int slot = b.slots[i];
    place(b, slot, cells[i], cells[i].mass / b.vertexCount(slot));  // [Nilsson 2008, eq. 4.1]
  }
  for (int block = 0; block < b.blockCount(); ++block)
    for (int lane = b.liveLanes(block); lane < blockLanes; ++lane)
      place(b, block * blockLanes + lane, makeEgg(b, b.blocks[block].meshLevel), immovable(b.parameters.precision));
  setSags(b);
}

}  // namespace morula
