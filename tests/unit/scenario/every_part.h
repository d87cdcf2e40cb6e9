#pragma once
#include <string>

namespace morula::test {

/// A scenario in which every part exists and little is left to defaults.
inline const std::string everyPart = R"(morula: 1
name: every-part
summary: All keys at once
seed: 7
dna: |
  START: a0, connect
  g1(a1|a0)
  g2(divide|a0)
colours: {a0: '#102030', a*: '#ABCDEF'}
cycle:
  length: 2
  per-substance: {a0: 1.5}
  at-birth: {a0: 1.25}
stop: {cycles: 3, time: 9.5, cells: 4, when: [{cells: 40}], every: 0.5}
physics:
  time_step: 0.001953125
  integrator: thesis-verlet
  drag: 0.25
  mesh: {icosphere: 3, coarsen: 0.5}
  cell: {model: shell, radius: 0.5, mass: 2}
  membrane: {stiffness: 41, damping: 0.5, production: 1.2, springs: dual}
  pressure: {constant: 5, outside: 1.25}
  growth: {rate: 0.2, until: 1.5}
  shell: {ellipsoid: [3, 2, 1], fill: 0.020833333333333332, holds: surface}
  contact: {law: thesis, stiffness: 30, damping: 0.1, viscosity: 0.3, slip-speed: 0.02, radius: 1.1}
division:
  plane: {axis: [0, 1, -1]}
  size: {adder: 0.25}
  rules: [{of: [a1, divide], axis: [1, 0, 2], share: 0.4, tilt: 10}, {of: a1, plane: random}]
variation: {cycle: 0.1, share: 0.05, start: 0.125, tilt: 5}
connections: {make: by-gene, on-division: both, strength: 0.4, release-distance: 1.5, release-age: 4, most: 3}
senses: {}
experiments: [{kill: path A, at: 1}]
record: {every: 0.25, pictures: 0.5, meshes: 0.75, at-cells: [2, 3], measures: [contact_f1, position_rmsd]}
names: {egg: P0, daughters: [l, r], cells: {A: AB}}
units: {length: um, per-length: 27, time: min, per-time: 4}
check: {volume: [0.5, 2], extent: 9, energy: 100, momentum: 0.5, end-volume: [0.9, 1.1], end-roundness: 0.75,
  end-overlap: 0.125, fails: [springs, physics.time_step], sane: false, because: it stops,
  reference: {contacts: [[AB, /B], [/AA, /AB]], positions: {AB: [1, 0, 0], /B: [-1, 0, 0], /AB: [0, 2, 0]}}}
cells:
  - {at: [0.4, 0, 0.25], velocity: [0, 2, 0], scale: 0.5, stretch: [1, 2, 1], mass: 3, substances: [a0, A]}
  - {at: [-0.4, 0, 0]}
)";

}  // namespace morula::test
