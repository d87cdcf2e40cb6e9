#include "parts/binding_limit.h"

#include <algorithm>

#include "contacts/contacts.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

/// Small enough that the part bounds nothing, and no limit divides by 0.
constexpr double nearlyNone = 1e-12;

/// Returns the stability limit [time] with another value in a place.
template <class T>
double limitWith(const World& world, T& place, const T& value) {
  const T kept = place;
  place = value;
  const double limit = timeStepLimit(world);
  place = kept;
  return limit;
}

}  // namespace

BindingLimit findBindingLimit(World& world) {
  Bodies& b = *world.bodies;
  const double now = timeStepLimit(world);
  BindingLimit binding{"its springs", 1};
  const auto consider = [&](const char* part, double without) {
    if (without / now > binding.factor) binding = {part, without / now};
  };
  MembraneParameters& membrane = b.parameters.membrane;
  AlignedVector<double> empty(b.pressureConstant.size());
  std::ranges::transform(b.pressureConstant, empty.begin(), [](double k) { return nearlyNone * k; });
  consider("the damping of membranes", limitWith(world, membrane.damping, Damping(0)));
  consider("bending", limitWith(world, membrane.bending, 0.0));
  consider("pressure", limitWith(world, b.pressureConstant, empty));
  consider("drag", limitWith(world, b.parameters.drag, 0.0));
  if (world.contacts) {
    consider("the damping of contacts", limitWith(world, world.contacts->damping, 0.0));
    consider("the stiffness of contacts", limitWith(world, world.contacts->parameters.stiffness, nearlyNone));
  }
  const MembraneParameters soft{.stiffness = nearlyNone * membrane.stiffness,
                                .damping = membrane.damping,
                                .areaFactor = membrane.areaFactor,
                                .springs = membrane.springs,
                                .bending = membrane.bending};
  consider("the stiffness of membranes", limitWith(world, membrane, soft));
  return binding;
}

}  // namespace morula
