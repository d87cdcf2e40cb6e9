#pragma once
// Experiments on an organism while it grows: the cells, the deed and the time (Scene::experiments).
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/choice.h"
#include "base/members.h"
#include "biology/cell_selection.h"
#include "contacts/parameters.h"
#include "physics/parameters.h"

namespace morula {

enum class Deed { kill, geneOff, geneOn, set, cycles, delay, connect, release };
template <>
inline constexpr auto choices<Deed> = std::to_array<Choice<Deed>>({
    {Deed::kill, "kill", "these cells die"},
    {Deed::geneOff, "gene-off", "the gene acts in no cell from then on"},
    {Deed::geneOn, "gene-on", "the gene acts again"},
    {Deed::set, "set", "the parameter has another value from then on"},
    {Deed::cycles, "cycles", "cycle lengths of these cells are multiplied by a factor from then on"},
    {Deed::delay, "delay", "the next cycle of these cells is delayed by a time"},
    {Deed::connect, "connect", "two cells are connected"},
    {Deed::release, "release", "a connection of two cells ends"},
});

/// An experiment, which takes place at the end of the first step that reaches its time, after the cell cycles that were
/// due until then. Exactly one of `at`, `afterBirth` and `atCells` is given.
struct Experiment {
  Deed deed = Deed::kill;
  std::vector<CellSelection> of{};         // cells; one each for the two ends of a connection; none: all cells
  std::string name{};                      // of a gene, or of a parameter (changeableParameters)
  double value = 0;                        // of the parameter; the factor of cycles; [time] of a delay
  double share = 1;                        // [1] of these cells, chosen by the seed
  std::optional<double> at{};              // [time]
  std::optional<double> afterBirth{};      // [time] of each of the cells
  std::optional<std::uint64_t> atCells{};  // when so many cells live for the first time
};
MORULA_MEMBERS(Experiment, deed, of, name, value, share, at, afterBirth, atCells)

/// A parameter that an experiment may set while a scene runs.
struct ChangeableParameter {
  const char* path;  // as a scenario writes it
  bool mayBeZero;    // never below
  /// Returns the parameter; null if the scene has no such part. `contact`: null without contact.
  double* (*of)(PhysicsParameters& physics, ContactParameters* contact);
};
/// Return the number of a damping that counts; null where the other one does.
inline double* constantOf(Damping& damping) { return damping.ratio > 0 ? nullptr : &damping.constant; }
inline double* ratioOf(Damping& damping) { return damping.ratio > 0 ? &damping.ratio : nullptr; }

inline constexpr auto changeableParameters = std::to_array<ChangeableParameter>({
    {"physics.drag", true, [](auto& physics, auto*) { return &physics.drag; }},
    {"physics.membrane.stiffness", false, [](auto& physics, auto*) { return &physics.membrane.stiffness; }},
    {"physics.membrane.damping", true, [](auto& physics, auto*) { return constantOf(physics.membrane.damping); }},
    {"physics.membrane.damping.ratio", false, [](auto& physics, auto*) { return ratioOf(physics.membrane.damping); }},
    {"physics.pressure.outside", true, [](auto& physics, auto*) { return &physics.pressure.outside; }},
    {"physics.growth.rate", false,
     [](auto& physics, auto*) { return physics.growth ? &physics.growth->rate : nullptr; }},
    {"physics.contact.stiffness", false, [](auto&, auto* contact) { return contact ? &contact->stiffness : nullptr; }},
    {"physics.contact.damping", true,
     [](auto&, auto* contact) { return contact ? constantOf(contact->damping) : nullptr; }},
    {"physics.contact.damping.ratio", false,
     [](auto&, auto* contact) { return contact ? ratioOf(contact->damping) : nullptr; }},
    {"physics.contact.adhesion.strength", true,
     [](auto&, auto* contact) { return contact && contact->adhesion ? &contact->adhesion->strength : nullptr; }},
});

/// The row of a parameter; null if it cannot change while a scene runs.
inline const ChangeableParameter* changeableParameter(std::string_view path) {
  for (const ChangeableParameter& row : changeableParameters)
    if (path == row.path) return &row;
  return nullptr;
}

}  // namespace morula
