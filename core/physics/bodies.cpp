#include "physics/bodies.h"

#include "base/error.h"

namespace morula {

namespace {

constexpr double immovable = 0x1p900;  // [mass] of lanes without a cell

void write(AlignedVector<double>& array, std::size_t at, const Vector& a) {
  array[at] = a.x;
  array[at + blockLanes] = a.y;
  array[at + 2 * blockLanes] = a.z;
}

}  // namespace

Bodies makeBodies(const PhysicsParameters& parameters, const Mesh& egg, int threads) {
  Bodies b;
  b.parameters = parameters;
  b.mesh = makeTemplate(egg);
  const double* a = parameters.shell ? parameters.shell->semiAxes : nullptr;
  b.kernelParameters = {parameters.membrane.stiffness,
                        parameters.membrane.damping,
                        parameters.pressure.outside,
                        parameters.drag,
                        {a ? a[0] : 1, a ? a[1] : 1, a ? a[2] : 1}};
  b.scratch.resize(threads);
  for (auto& s : b.scratch) {
    s.predicted.assign(b.blockSize(), 0);
    s.gradient.assign(b.blockSize(), 0);
    s.coefficient.assign(std::size_t(b.mesh.edgeCount() + 1) * blockLanes, 0);  // the slack edge stays 0
  }
  return b;
}

BlockView Bodies::block(int index, int thread) {
  const std::size_t v = index * blockSize(), l = std::size_t(index) * blockLanes;
  Scratch& s = scratch[thread];
  return {liveLanes(index), &position[v],       &velocity[v],         &acceleration[v],
          &vertexMass[l],   &restScale[l],      &pressureConstant[l], &volume[l],
          &pressure[l],     s.predicted.data(), s.gradient.data(),    s.coefficient.data()};
}

Body makeEgg(const Bodies& b) {
  return {b.mesh.mesh.vertices, std::vector<Vector>(b.vertexCount()), b.parameters.cell.mass, 1,
          b.parameters.pressure.constant};
}

Body takeBody(const Bodies& b, int slot) {
  Body cell{{}, {}, b.mass(slot), b.restScale[slot], b.pressureConstant[slot]};
  for (int v = 0; v < b.vertexCount(); ++v) {
    cell.position.push_back(b.read(b.position, slot, v));
    cell.velocity.push_back(b.read(b.velocity, slot, v));
  }
  return cell;
}

Point measureCentre(const Bodies& b, int slot) {
  Vector sum;
  for (int v = 0; v < b.vertexCount(); ++v) sum += b.vertex(slot, v);
  return sum / static_cast<double>(b.vertexCount());
}

void setBodies(Bodies& b, const std::vector<Body>& cells) {
  b.count = static_cast<int>(cells.size());
  const std::size_t lanes = std::size_t(b.blockCount()) * blockLanes, size = b.blockCount() * b.blockSize();
  for (auto* a : {&b.position, &b.velocity, &b.acceleration}) a->assign(size, 0);
  for (auto* a : {&b.vertexMass, &b.restScale, &b.pressureConstant, &b.volume, &b.pressure})
    a->assign(lanes, 0);
  for (int slot = 0; slot < static_cast<int>(lanes); ++slot) {
    const bool living = slot < b.count;
    const Body filler = living ? Body{} : makeEgg(b);
    const Body& cell = living ? cells[slot] : filler;
    CHECK(static_cast<int>(cell.position.size()) == b.vertexCount(), "a cell keeps its mesh's vertices");
    b.vertexMass[slot] = living ? cell.mass / b.vertexCount() : immovable;  // [Nilsson 2008, eq. 4.1]
    b.restScale[slot] = cell.restScale;
    b.pressureConstant[slot] = cell.pressureConstant;
    for (int v = 0; v < b.vertexCount(); ++v) {
      write(b.position, b.at(slot, v), cell.position[v]);
      write(b.velocity, b.at(slot, v), cell.velocity[v]);
    }
  }
}

}  // namespace morula
