#include "contacts/contacts.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "physics/stages.h"

namespace morula {
namespace {

/// Returns the max force of viscosity per slip speed [force·time/length]. Slow cells feel this bound alone, whatever
/// their viscosity: it is a damper, and not Coulomb's friction. It follows from the cells and not from the time step, or
/// each step would have another law. m is the lightest vertex' mass. A vertex rubs against up to ten others, as in contactLimit;
/// dampers c along lines in all directions of a surface sum up to 5c along each. 0.3 √(K m) damp its swing against these ten, ω² = 10 K/m, by a
/// quarter of critical damping. They do not reverse its slip within a time step, 5c Δt < m, up to steps of 0.53 √(m/K),
/// as the automatic steps of velocity Verlet are. A longer step lowers the bound.
double strongestGrip(const Contacts& c, double timeStep) {
  const double m = c.lightestVertex;
  return std::min(0.3 * std::sqrt(c.parameters.stiffness * m), 0.16 * m / timeStep);
}

/// Takes the points that lists are built from: the places of the rows.
void takePoints(Contacts& c, const Bodies& bodies, int threads) {
  if (c.parameters.law == ContactLaw::thesis || bodies.areSpheres()) {
    c.list.reference = bodies.position;
    return;
  }
  parallelFor(bodies.blockCount(), threads, [&](int block) {
    const BlockPlace& place = bodies.blocks[block];
    for (int line = place.firstLine; line < place.firstLine + bodies.verticesPerLane(block); ++line)
      for (int lane = 0; lane < place.liveLanes; ++lane) {
        const SnapshotRow row = readRow(c.rows[std::size_t(line) * blockLanes + lane], bodies.parameters.precision);
        const std::size_t at = std::size_t(line) * vertexStride + lane;
        c.list.reference[at] = row.x;
        c.list.reference[at + blockLanes] = row.y;
        c.list.reference[at + 2 * blockLanes] = row.z;
      }
  });
}

bool sticksAtAll(const AdhesionParameters& a) {
  return a.strength > 0 || std::ranges::any_of(a.pairs, [](const AdhesionPair& pair) { return pair.strength > 0; });
}

}  // namespace

Contacts makeContacts(const ContactParameters& parameters, Isa isa, const SearchSettings& search, Precision precision,
                      CellModel model) {
  Contacts c;
  c.parameters = parameters;
  if (parameters.adhesion && !sticksAtAll(*parameters.adhesion))
    c.parameters.adhesion.reset();  // costs nothing, changes no bit
  c.skinShare = search.skinShare;
  c.list = makeNeighbourList(search.method, isa);
  c.kernels = &contactKernels(isa, precision);
  const bool slips = parameters.viscosity > 0, sticks = c.parameters.adhesion.has_value();
  if (sticks) c.list.bytesPerNeighbour += 2 * sizeof(double);
  const auto take = !kindOf(model).hasMesh                 ? &ContactKernels::takeSphereSnapshot
                    : parameters.law == ContactLaw::thesis ? &ContactKernels::takeSnapshot
                    : sticks                               ? &ContactKernels::takeSurface
                                                           : &ContactKernels::takeSurfaceAndCount;
  for (int cells = 1; cells <= blockLanes; ++cells)
    c.takeSnapshot[cells - 1] = contactKernels(narrowestIsa(cells, isa, precision), precision).*take;
  if (!kindOf(model).hasMesh) {
    if (sticks) c.list.reach = sphereAdhesionReach;
    c.addForces = sticks && slips ? c.kernels->addStickySphereForcesWithViscosity
                  : sticks        ? c.kernels->addStickySphereForces
                  : slips         ? c.kernels->addSphereForcesWithViscosity
                                  : c.kernels->addSphereForces;
    return c;
  }
  if (parameters.law == ContactLaw::pair && sticks) c.list.reach = attractionReach;
  if (parameters.law == ContactLaw::pair && !sticks) c.list.bytesPerNeighbour += sizeof(VertexNumber);
  c.addForces = parameters.law == ContactLaw::thesis ? c.kernels->addThesisForces
                : sticks && slips                    ? c.kernels->addStickyPairForcesWithViscosity
                : sticks                             ? c.kernels->addStickyPairForces
                : slips                              ? c.kernels->addPairForcesWithViscosity
                                                     : c.kernels->addPairForces;
  return c;
}

void setInfluenceRadii(Contacts& c, const Bodies& bodies) {
  std::vector<double> radii;
  for (int slot : bodies.slots)
    radii.push_back(c.parameters.radius * bodies.meshOf(slot).meanRestLength * bodies.restScale[slot]);
  setInfluenceRadii(c, bodies, radii);
}

void setInfluenceRadii(Contacts& c, const Bodies& bodies, std::span<const double> radii) {
  c.radius.assign(bodies.restScale.size(), 0);
  c.inverseRadiusSquared.assign(bodies.restScale.size(), 0);
  double smallest = INFINITY;
  for (int cell = 0; cell < bodies.count; ++cell) {
    const int slot = bodies.slots[cell];
    c.radius[slot] = radii[cell];
    const double inverse = 1 / (radii[cell] * radii[cell]);
    // Rounded as in rows, so that each user sees the same number. Rows of spheres also hold their radius.
    c.inverseRadiusSquared[slot] = bodies.areSpheres() ? inverse : static_cast<float>(inverse);
    smallest = std::min(smallest, radii[cell]);
  }
  c.lightestVertex = INFINITY;
  for (int slot : bodies.slots) c.lightestVertex = std::min(c.lightestVertex, bodies.vertexMass[slot]);
  c.damping = bodies.count > 0 ? c.parameters.damping.of(c.parameters.stiffness, c.lightestVertex) : 0;
  c.list.skin = bodies.count > 0 ? c.skinShare * smallest : 0;
  c.listIsValid = false;
  c.adhesion.isCurrent = false;
}

void resetContacts(Contacts& c, const Bodies& bodies) {
  setInfluenceRadii(c, bodies);
  resetAdhesion(c, bodies);
  if (bodies.count == 0) c.list.perBlock.clear();  // no step will come that makes the list anew
  const std::size_t vertices = std::size_t(bodies.lineCount()) * blockLanes;
  c.rows.assign(vertices + 1, {});
  const Precision precision = bodies.parameters.precision;
  const double far = precision == Precision::binary64 ? 1e100 : 1e18;  // far² is finite, κ far² need not be
  c.rows[vertices] = asMemory({far, far, far, 1, 0, 0, 0, 0, 0, 1}, precision);
  c.farthest.assign(bodies.blockCount(), 0);
  c.deepest.assign(bodies.blockCount(), 0);
  c.list.reference = bodies.position;
  if (c.parameters.law == ContactLaw::thesis || bodies.areSpheres()) return;
  int maxVertices = 0;
  for (int block = 0; block < bodies.blockCount(); ++block)
    maxVertices = std::max(maxVertices, bodies.verticesPerLane(block));
  c.scratch.resize(bodies.scratch.size(), {Reals(precision), Reals(precision)});
  for (auto& [force, turn] : c.scratch)
    for (Reals* a : {&force, &turn}) a->assign(std::size_t(maxVertices) * vertexStride, 0);
  if (!choosesPairs(c)) return;
  c.acting = {};
  c.acting.change.assign(vertices, 0);
  c.acting.speeds.assign(vertices, 0);
  c.acting.marked.assign(vertices, 0);
  c.acting.blocks.resize(bodies.blockCount());
  for (int block = 0; block < bodies.blockCount(); ++block)
    c.acting.blocks[block].ended.resize(std::size_t(bodies.verticesPerLane(block)) * blockLanes);
}

void takeSnapshot(Contacts& c, const Bodies& bodies, const BlockView& block, int index, double sinceLast) {
  const std::size_t lines = bodies.blocks[index].firstLine;
  ChangeCount count{};
  if (choosesPairs(c)) count = countChanges(c, bodies, index, sinceLast);
  c.farthest[index] = c.takeSnapshot[block.liveLanes - 1](
      bodies.meshAt(block.meshLevel).view(), block, &c.inverseRadiusSquared[std::size_t(index) * blockLanes],
      c.list.reference.from(lines * vertexStride), &c.rows[lines * blockLanes], count);
  if (choosesPairs(c)) c.acting.blocks[index].endedCount = count.endedCount;
}

void refreshList(Contacts& c, const Bodies& bodies, int threads) {
  const double limit = 0.25 * c.list.skin * c.list.skin;
  // The comparison is `<`, not `<=`: a NaN must lead to a rebuild, never to a stale list.
  const bool still = std::all_of(c.farthest.begin(), c.farthest.end(), [&](double f) { return f < limit; });
  const bool choose = choosesPairs(c), search = !c.listIsValid || !still;
  if (search) {
    takePoints(c, bodies, threads);
    (choose ? findNeighbourLists : buildNeighbourList)(c.list, bodies, c.radius, threads);
    c.listIsValid = true;
    c.adhesion.isCurrent = false;
    ++c.rebuilds;
  }
  if (choose) (search ? choosePairs : renewPairs)(c, bodies, threads);
  ++c.acting.age;
  if (c.parameters.adhesion && !c.adhesion.isCurrent) findPairStrengths(c, bodies, threads);
  findCrowding(c, bodies, threads);
  c.pairEvaluations += c.list.pairs;  // for the forces, which come next
}

double hardeningAt(double b) {
  return 1 + b * (6 * hardening1 + 15 * hardening2 * b);  // E'' of ½ D² (1 + β₁ B + β₂ B²), u = 1
}

double measureHardening(const Contacts& c) {
  double b = 0;
  for (double deepest : c.deepest) b = std::max(b, deepest);
  return hardeningAt(b);
}

void measureSteepness(const Contacts& c, const Bodies& bodies, int threads, std::vector<double>& stiffness) {
  stiffness.assign(bodies.restScale.size(), 0);
  if (c.scratch.empty() || !c.listIsValid) return;
  parallelFor(bodies.blockCount(), threads, [&](int block) {
    const BlockLists& lists = c.list.perBlock[block];
    BlockSlices slices{};
    slices.slices = lists.slices.data(), slices.count = std::ssize(lists.slices);
    double* own = &stiffness[std::size_t(block) * blockLanes];
    c.kernels->findSteepest(slices, lists.indices.data(), c.rows.data(), bodies.lineCount() * blockLanes, own);
    for (int lane = 0; lane < blockLanes; ++lane) own[lane] *= 16;
  });
}

void addContactForces(Contacts& c, Bodies& bodies, int block, double timeStep) {
  const BlockLists &lists = c.list.perBlock[block], &next = c.list.perBlock[(block + 1) % c.list.perBlock.size()];
  const BlockPlace& place = bodies.blocks[block];
  const std::int64_t count = std::ssize(lists.slices), lines = bodies.verticesPerLane(block);
  const bool onSurface = !c.scratch.empty(), sticks = c.parameters.adhesion.has_value();
  const RealPointer none{nullptr};
  const BlockSlices slices{.slices = lists.slices.data(),
                           .count = count,
                           .vertexMass = &bodies.vertexMass[std::size_t(block) * blockLanes],
                           .sag = &bodies.sag[std::size_t(block) * blockLanes],
                           .nextLine = place.firstLine + lines,
                           .linesPerSlice = count > 0 ? (lines + count - 1) / count : 0,
                           .nextSlices = next.slices.data(),
                           .nextIndices = next.indices.data(),
                           .mesh = bodies.meshAt(place.meshLevel).view(),
                           .liveLanes = place.liveLanes,
                           .firstVertex = place.firstLine * blockLanes,
                           .position = bodies.position.from(std::size_t(place.firstLine) * vertexStride),
                           .velocity = bodies.velocity.from(std::size_t(place.firstLine) * vertexStride),
                           .surfaceForce = onSurface ? c.scratch[threadNumber()].force.from(0) : none,
                           .surfaceTurn = onSurface ? c.scratch[threadNumber()].turn.from(0) : none,
                           .deepest = &c.deepest[block]};
  const ContactConstants constants{.stiffness = c.parameters.stiffness,
                                   .damping = c.damping,
                                   .viscosity = c.parameters.viscosity,
                                   .slipSpeed = c.parameters.slipSpeed,
                                   .strongestGrip = strongestGrip(c, timeStep),
                                   .timeStep = timeStep,
                                   .vertices = bodies.lineCount() * blockLanes,
                                   .adhesion = sticks ? c.adhesion.ofPairs[block].data() : nullptr,
                                   .adhesionPerWork = sticks ? c.adhesion.perWork[block].data() : nullptr,
                                   .saturation = sticks ? c.adhesion.saturation.data() : nullptr};
  c.addForces(slices, lists.indices.data(), c.rows.data(), constants, bodies.acceleration.from(0));
}

}  // namespace morula
