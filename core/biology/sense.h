#pragma once
// The kinds of senses, by which a cell perceives itself and others: one row of a table for each. To add a kind: its
// value in SenseKind (parameters.h), and its row in a file such as neighbour_senses.cpp.
//
// A kind measures one number of a cell, and a condition (Threshold) says of which numbers the cell takes note.
#include <functional>
#include <limits>
#include <span>

#include "biology/cell_context.h"
#include "biology/parameters.h"

namespace morula {

/// Returns true for a cell that SenseParameters::of asks for.
using CountsCell = std::function<bool(const CellContext&)>;

/// A part of a scene without which a kind of sense has nothing to measure.
enum class SenseNeeds { nothing, bodies, membrane, mesh, contact, shell, connections };

/// The key of SenseParameters::of in a scenario, and whether a scenario must give it.
struct SenseOf {
  const char* key = nullptr;  // null: this kind has none
  bool required = false;
};

/// The key of SenseParameters::number in a scenario, and its unit.
struct SenseNumber {
  const char* key = nullptr;
  const char* unit = "";
  bool required = false;
};

struct SenseKindRow {
  SenseKind kind;
  const char* name;     // as scenarios spell it
  const char* meaning;  // what is measured, or for kinds without a threshold what is perceived
  const char* unit = "";
  SenseNeeds needs = SenseNeeds::nothing;
  SenseOf of = {};
  SenseNumber number = {};
  bool takesAxis = false;
  bool takesLives = false;                                  // `lives`, instead of `of`
  double least = -std::numeric_limits<double>::infinity();  // range of what can be measured: `least` to `most`
  double most = std::numeric_limits<double>::infinity();
  /// Returns the measured number; infinite where nothing could be near.
  double (*measure)(const CellContext& cell, const SenseParameters& sense, const CountsCell& counts);
  /// Returns the condition on the number, for kinds whose scenario does not spell it; null: SenseParameters::is.
  Threshold (*threshold)(const SenseParameters& sense) = nullptr;
};

/// Returns the rows of all kinds, in the order in which people should meet them.
std::span<const SenseKindRow* const> senseKinds();
const SenseKindRow& kindOf(SenseKind kind);

/// Returns true if the threshold lets a number be noted. `before`: the last number was noted [Threshold::until].
bool holds(const Threshold& threshold, double value, bool before);

/// Returns true if a cell perceives this now. `before`: the cell did at its last cycle. A cell without a body perceives
/// nothing of bodies, so that a lineage alone can be computed of a scene with bodies.
bool isSensed(const SenseParameters& sense, const CellContext& cell, const CountsCell& counts, bool before);

// Rows, by file. Private to this module.
std::span<const SenseKindRow> bodySenses();
std::span<const SenseKindRow> neighbourSenses();
std::span<const SenseKindRow> distantSenses();

}  // namespace morula
