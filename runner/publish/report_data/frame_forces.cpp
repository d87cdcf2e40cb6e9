#include "report_data/frame_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "contacts/contacts.h"
#include "files/bytes.h"
#include "physics/integrator.h"
#include "simulation/checkpoint.h"

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

/// [force] The largest component.
double largest(const std::vector<Vector>& forces) {
  double most = 0;
  for (const Vector& f : forces) most = std::max({most, std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  return most;
}

}  // namespace

ForceMeter::ForceMeter(World twin) : twin_(std::move(twin)), kinds_(kindsOf(twin_)) {}

std::vector<ForcesByKind> ForceMeter::at(const World& world) {
  if (kinds_.empty()) return {};
  try {
    restoreState(twin_, saveState(world));
    return forcesByKind(twin_);
  } catch (const NumericalError&) { return {}; }  // as the run's own next step will tell
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
      for (const double x : {net.x, net.y, net.z}) putFloat(bytes, x);
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

}  // namespace morula
