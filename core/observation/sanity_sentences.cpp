// The sentences about a world that is not sane. They name measured values and the keys that change these, never the
// cause.
#include "base/error.h"
#include "base/number_text.h"
#include "contacts/contacts.h"
#include "observation/crumpling.h"
#include "observation/sanity.h"
#include "state/world.h"

namespace morula {
namespace {

std::string nameOf(const std::optional<CellPath>& cell) { return cell ? cellName(cell->text()) : "all cells"; }

/// Returns the advice on what holds cells apart in this scene, or says that nothing does.
std::string contactAdvice(const MechanicsScene& m) {
  if (!m.contact) return "the scene has no physics.contact, so cells pass through one another";
  if (m.contact->law == ContactLaw::thesis)
    return "physics.contact.law thesis holds cells apart only where motion is damped: try pair, or more physics.drag";
  return "what holds them apart is physics.contact, with stiffness " + exactText(m.contact->stiffness) +
         " and radius " + exactText(m.contact->radius) + ": try more of either";
}

/// Returns the keys that decide how much a surface crumples, the keys that the scene has first.
std::string surfaceAdvice(const MechanicsScene& m) {
  std::string keys;
  if (m.contact && m.contact->adhesion) keys += "a lower physics.contact.adhesion, ";
  if (m.physics.shell) keys += "a larger physics.shell or a smaller cell (physics.cell.radius), ";
  if (kindOf(m.physics.cell.model).hasMembrane) keys += "another physics.pressure.constant or physics.membrane, ";
  return "try " + keys + "more physics.drag or a finer physics.mesh";
}

/// Returns how much of a cell's membrane is compressed, which is what folds it.
std::string compressionOf(const World& world, const CellPath& cell) {
  const Observation now(world);
  const double share = ObservedCell(now, cellNumber(world.cells, cell)).compressedShare();
  return numberText(share) + " of its edges are compressed, below " + numberText(compressedEdge) +
         " of their rest length";
}

std::string adhesionAdvice(const MechanicsScene& m) {
  const AdhesionParameters& adhesion = *m.contact->adhesion;
  if (!adhesion.pairs.empty()) return "lower the strengths of physics.contact.adhesion";
  return "lower physics.contact.adhesion, which is " + exactText(adhesion.strength);
}

}  // namespace

std::string describe(const SanityMeasure& m, const World& world) {
  const std::string who = nameOf(m.cell), value = numberText(m.value), most = numberText(m.most);
  const MechanicsScene& scene = *world.model.mechanics;
  switch (m.kind) {
    case SanityKind::finite: return who + " has a position, speed or volume that is not finite";
    case SanityKind::volume:
      return who + " is " + (m.value < m.least ? "crushed" : "blown up") + " to " + value +
             " of its volume at rest; fine is " + numberText(m.least) + " to " + most;
    case SanityKind::inverted:
      return "the outer side of " + who + " looks towards the mean of its vertices over " + value +
             " of its surface; fine is at most " + most + "; " + surfaceAdvice(scene);
    case SanityKind::folded:
      return "the surface of " + who + " is folded over by more than 90° at " + value +
             " of its edges; fine is at most " + most + "; " + compressionOf(world, *m.cell) + "; " +
             surfaceAdvice(scene);
    case SanityKind::selfOverlap:
      return who + " passes through itself: it covers " + value +
             " of its volume more than once or inside out; fine is at most " + most +
             "; a cell has no contact with itself: " + surfaceAdvice(scene);
    case SanityKind::overlap:
      return who + " shares " + value + " of its volume with " + nameOf(m.other) + "; fine is at most " + most + "; " +
             contactAdvice(scene);
    case SanityKind::gap:
      return who + " is " + value + " radii of empty space away from the others; fine is at most " + most +
             ", for no picture shows both";
    case SanityKind::adhesion:
      return who + " sticks with " + value +
             " times the energy that its whole surface holds where it touches others; fine "
             "is at most " +
             most + "; " + adhesionAdvice(scene);
    case SanityKind::outermost:
      return who + " stands out of the shell: its surface reaches " + numberText(m.value, 6) + " of its radius" +
             (!kindOf(scene.physics.cell.model).hasMesh
                  ? "; balls do so where an ellipsoid bends, other models of physics.cell do not"
                  : "");
    case SanityKind::fill:
      return "the volumes of all cells sum up to " + value + " of the shell's; fine is at most " + most +
             (world.bodies->count > 1 ? "; " + contactAdvice(scene) : "; " + surfaceAdvice(scene));
    case SanityKind::energy: break;
  }
  MORULA_CHECK(m.kind == SanityKind::energy, "every quantity has a sentence of its own");
  return "the energy of motion, membranes, contents and contacts has grown by " + value +
         " of what it was, and nothing here adds any; fine is at most " + most +
         "; try a shorter physics.time_step, or another physics.integrator";
}

std::string describeInsanity(const World& world) {
  std::string text;
  for (const SanityMeasure& m : measureSanity(world))
    if (!m.holds()) text += (text.empty() ? "" : "; ") + describe(m, world);
  return text;
}

}  // namespace morula
