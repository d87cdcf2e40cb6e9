
#include "state/scene_parts.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "state/scene.h"

namespace morula {

// A struct's hash is over the names and values of those members that differ from their defaults. So a member that joins
// a struct later leaves the hashes of all scenes that do not use it.

namespace {

template <class T>
bool same(const T& a, const T& b);

template <class T>
bool sameMembers(const T& a, const T& b) {
  const auto these = members(a), those = members(b);
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (same(std::get<i>(these), std::get<i>(those)) && ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(members(a))>>());
}

template <class T>
bool same(const T& a, const T& b) {
  if constexpr (HasMembers<const T>) return sameMembers(a, b);
  else if constexpr (requires { *a, a.operator bool(); }) return bool(a) == bool(b) && (!a || same(*a, *b));
  else if constexpr (requires { a.begin()->first; }) return a == b;
  else if constexpr (!std::is_same_v<T, std::string> && requires { a.begin(); })
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return same(x, y); });
  else return a == b;
}

void add(Hasher& h, const std::string& a) { h.add(a); }
void add(Hasher& h, const double& a) { h.add(a); }
void add(Hasher& h, const CellPath& a) { h.add(a.text()); }
template <class T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) void add(Hasher& h, const T& a) {
  h.add(static_cast<std::int64_t>(a));
}
template <class T>
void add(Hasher& h, const std::optional<T>& a);
template <class T>
void add(Hasher& h, const std::shared_ptr<const T>& a);
template <class T>
void add(Hasher& h, const std::vector<T>& a);
template <class T, std::size_t count>
void add(Hasher& h, const std::array<T, count>& a);
void add(Hasher& h, const std::map<std::string, double>& a);

template <HasMembers T>
void add(Hasher& h, const T& a) {
  static const T usual{};
  const auto values = members(a), usuals = members(usual);
  std::string_view names = memberNames(&a);
  const auto addMember = [&](const auto& value, const auto& usualValue) {
    const auto end = names.find(',');
    if (!same(value, usualValue)) add(h.field(names.substr(0, end)), value);
    names.remove_prefix(end == names.npos ? names.size() : end + 2);
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) { (addMember(std::get<i>(values), std::get<i>(usuals)), ...); }
  (std::make_index_sequence<std::tuple_size_v<decltype(members(a))>>());
  h.field("end");
}

template <class T>
void add(Hasher& h, const std::optional<T>& a) {
  h.add(a.has_value());
  if (a) add(h, *a);
}
template <class T>
void add(Hasher& h, const std::shared_ptr<const T>& a) {
  h.add(a != nullptr);
  if (a) add(h, *a);
}
template <class T>
void add(Hasher& h, const std::vector<T>& a) {
  h.add(std::uint64_t{a.size()});
  for (const T& one : a) add(h, one);
}
template <class T, std::size_t count>
void add(Hasher& h, const std::array<T, count>& a) {
  for (const T& one : a) add(h, one);
}
void add(Hasher& h, const std::map<std::string, double>& a) {
  h.add(std::uint64_t{a.size()});
  for (const auto& [name, value] : a) h.add(name).add(value);
}

template <class Part>
std::string hashOf(const Part& part) {
  Hasher h;
  add(h, part);
  return h.digest().text();
}

/// The DNA without what only tells of its text.
Dna decisive(Dna dna) {
  for (Gene& gene : dna.genes) gene.name.clear();
  dna.source.clear(), dna.warnings.clear();
  return dna;
}

/// The parameters without those that the cell model and the integrator do not read.
PhysicsParameters decisive(PhysicsParameters physics) {
  if (!kindOf(physics.cell.model).hasRestShape) physics.shapeMatching = {};
  if (physics.integrator != Integrator::quasiStatic) physics.quasiStatic = {};
  return physics;
}

}  // namespace

std::vector<ScenePart> hashSceneParts(const Scene& scene) {
  const auto& [title, seed, dna, cycle, stop, mechanics, cells, variation, senses, experiments] = scene;
  std::vector<ScenePart> parts;
  const auto add = [&](const char* name, const auto& part) { parts.push_back({name, hashOf(part)}); };
  add("dna", decisive(dna));
  add("cycle", cycle);
  add("seed", seed);
  if (mechanics) {
    add("physics", decisive(mechanics->physics));
    add("physics.mesh", std::vector<std::vector<Mesh>>{{mechanics->mesh}, mechanics->coarser});
    if (mechanics->contact) add("physics.contact", *mechanics->contact);
    add("division", mechanics->division);
    if (mechanics->connections) add("connections", *mechanics->connections);
  }
  VariationParameters onTheWay = variation;
  onTheWay.start = 0;  // as the start cells: how a state came about does not decide how it goes on
  if (onTheWay != VariationParameters{}) add("variation", onTheWay);
  if (!senses.empty()) add("senses", senses);
  if (!experiments.empty()) add("experiments", experiments);
  return parts;
}

}  // namespace morula
