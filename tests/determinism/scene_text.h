#pragma once
// A scene as plain words, for programs that know no YAML: numbers are written as the bits that they are.
// Writing and reading share one list of fields, and a field that is missing in it does not compile.
#include <bit>
#include <istream>
#include <map>
#include <memory>
#include <ostream>
#include <tuple>
#include <type_traits>

#include "base/error.h"
#include "mesh/convex_shell.h"
#include "simulation/scene.h"

namespace morula::scene_text {

inline auto fields(Vector& a) {
  auto& [x, y, z] = a;
  return std::tie(x, y, z);
}
inline auto fields(Face& a) {
  auto& [i, j, k] = a;
  return std::tie(i, j, k);
}
inline auto fields(Mesh& a) {
  auto& [vertices, faces] = a;
  return std::tie(vertices, faces);
}
inline auto fields(Gene& a) {
  auto& [name, product, inputs, repressors] = a;
  return std::tie(name, product, inputs, repressors);
}
inline auto fields(Dna& a) {
  auto& [substances, start, genes, source, warnings] = a;
  return std::tie(substances, start, genes, source, warnings);
}
inline auto fields(DivisionSize& a) {
  auto& [rule, size] = a;
  return std::tie(rule, size);
}
inline auto fields(CycleParameters& a) {
  auto& [length, perSubstance, atBirth, divisionSize] = a;
  return std::tie(length, perSubstance, atBirth, divisionSize);
}
inline auto fields(Threshold& a) {
  auto& [below, above, atMost, atLeast, until] = a;
  return std::tie(below, above, atMost, atLeast, until);
}
inline auto fields(SenseParameters& a) {
  auto& [substance, kind, is, of, number, axis, lives] = a;
  return std::tie(substance, kind, is, of, number, axis, lives);
}
inline auto fields(StopParameters& a) {
  auto& [cycles, time, cells] = a;
  return std::tie(cycles, time, cells);
}
inline auto fields(CellParameters& a) {
  auto& [radius, mass, model] = a;
  return std::tie(radius, mass, model);
}
inline auto fields(ShapeMatchingParameters& a) {
  auto& [stiffness, linear, damping] = a;
  return std::tie(stiffness, linear, damping);
}
inline auto fields(MembraneParameters& a) {
  auto& [stiffness, damping, production, springs] = a;
  return std::tie(stiffness, damping, production, springs);
}
inline auto fields(PressureParameters& a) {
  auto& [constant, outside] = a;
  return std::tie(constant, outside);
}
inline auto fields(GrowthParameters& a) {
  auto& [rate, until] = a;
  return std::tie(rate, until);
}
inline auto fields(MotilityParameters& a) {
  auto& [speed, persistence] = a;
  return std::tie(speed, persistence);
}
inline auto fields(ShellPlane& a) {
  auto& [normal, offset] = a;
  return std::tie(normal, offset);
}
inline auto fields(ConvexShell& a) {
  auto& [mesh, planes] = a;
  return std::tie(mesh, planes);
}
inline auto fields(ShellParameters& a) {
  auto& [semiAxes, mesh, holds] = a;
  return std::tie(semiAxes[0], semiAxes[1], semiAxes[2], mesh, holds);
}
inline auto fields(PhysicsParameters& a) {
  auto& [coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane, pressure,
         shapeMatching, drag, growth, shell, motility] = a;
  return std::tie(coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane, pressure,
                  shapeMatching, drag, growth, shell, motility);
}
inline auto fields(AdhesionPair& a) {
  auto& [first, second, strength] = a;
  return std::tie(first, second, strength);
}
inline auto fields(AdhesionParameters& a) {
  auto& [strength, pairs] = a;
  return std::tie(strength, pairs);
}
inline auto fields(ContactParameters& a) {
  auto& [law, stiffness, damping, friction, slipSpeed, radius, adhesion] = a;
  return std::tie(law, stiffness, damping, friction, slipSpeed, radius, adhesion);
}
inline auto fields(PlaneChoice& a) {
  auto& [plane, axis, substance, turnsAway] = a;
  return std::tie(plane, axis, substance, turnsAway);
}
inline auto fields(Chirality& a) {
  auto& [angle, time] = a;
  return std::tie(angle, time);
}
inline auto fields(DivisionRule& a) {
  auto& [of, plane, share, tilt, chirality] = a;
  return std::tie(of, plane, share, tilt, chirality);
}
inline auto fields(DivisionParameters& a) {
  auto& [otherwise, rules, chirality] = a;
  return std::tie(otherwise, rules, chirality);
}
inline auto fields(ConnectedPair& a) {
  auto& [first, second] = a;
  return std::tie(first, second);
}
inline auto fields(ConnectionSpring& a) {
  auto& [stiffness, rest] = a;
  return std::tie(stiffness, rest);
}
inline auto fields(ConnectionParameters& a) {
  auto& [make, onDivision, strength, releaseDistance, pairs, spring, releaseTension, releaseAge, most] = a;
  return std::tie(make, onDivision, strength, releaseDistance, pairs, spring, releaseTension, releaseAge,
                  most);
}
inline auto fields(MechanicsScene& a) {
  auto& [physics, mesh, coarser, contact, division, connections] = a;
  return std::tie(physics, mesh, coarser, contact, division, connections);
}
inline auto fields(StartCell& a) {
  auto& [at, velocity, scale, stretch, mass, substances] = a;
  return std::tie(at, velocity, scale, stretch, mass, substances);
}
inline auto fields(VariationParameters& a) {
  auto& [cycle, share, start, tilt, adhesion] = a;
  return std::tie(cycle, share, start, tilt, adhesion);
}
inline auto fields(Scene& a) {
  auto& [name, seed, dna, cycle, stop, mechanics, cells, variation, senses] = a;
  return std::tie(name, seed, dna, cycle, stop, mechanics, cells, variation, senses);
}

struct Writer {
  std::ostream& out;
  void number(std::uint64_t& n) { out << std::to_string(n) << '\n'; }
  void text(std::string& s) { out << std::to_string(s.size()) << ' ' << s << '\n'; }
};

struct Reader {
  std::istream& in;
  void number(std::uint64_t& n) {
    if (!(in >> n)) throw InputError("this is no scene, or it has been cut off");
  }
  void text(std::string& s) {
    std::uint64_t size;
    number(size);
    in.get();
    s.clear();
    for (char c; s.size() < size && in.get(c);) s += c;
    if (s.size() < size) throw InputError("this is no scene, or it has been cut off");
  }
};

template <class Words, class T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) void add(Words& w, T& a) {
  auto n = static_cast<std::uint64_t>(a);
  w.number(n);
  a = static_cast<T>(n);
}
template <class Words>
void add(Words& w, double& a) {
  auto n = std::bit_cast<std::uint64_t>(a);
  w.number(n);
  a = std::bit_cast<double>(n);
}
template <class Words>
void add(Words& w, std::string& a) {
  w.text(a);
}
template <class Words, class T>
void add(Words& w, std::optional<T>& a) {
  bool given = a.has_value();
  add(w, given);
  if (given && !a) a.emplace();
  if (given) add(w, *a);
}
template <class Words, class T>
void add(Words& w, std::shared_ptr<const T>& a) {
  std::optional<T> copy = a ? std::optional(*a) : std::nullopt;
  add(w, copy);
  a = copy ? std::make_shared<const T>(std::move(*copy)) : nullptr;
}
template <class Words, class T>
void add(Words& w, std::vector<T>& a) {
  auto size = a.size();
  add(w, size);
  for (std::size_t i = 0; i < size; ++i) {
    if (i == a.size()) a.emplace_back();
    add(w, a[i]);
  }
}
template <class Words>
void add(Words& w, std::map<std::string, double>& a) {
  std::vector<std::string> names;
  for (const auto& [name, value] : a) names.push_back(name);
  add(w, names);
  for (std::string& name : names) add(w, a[name]);
}

template <class Words, class T>
requires requires(T& a) { fields(a); }
void add(Words& w, T& a) {
  std::apply([&](auto&... field) { (add(w, field), ...); }, fields(a));
}

inline void write(std::ostream& out, Scene scene) {
  Writer words{out};
  add(words, scene);
}

/// Throws InputError.
inline Scene read(std::istream& in) {
  Scene scene;
  Reader words{in};
  add(words, scene);
  return scene;
}

}  // namespace morula::scene_text
