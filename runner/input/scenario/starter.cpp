#include "scenario/schema.h"

namespace morula {

std::string starterScenario(const std::string& name) {
  return R"(# A scenario: an organism, how it grows, and how it is shown.
# All keys: morula schema --markdown; in editors: morula schema > scenario.schema.json
morula: 1                      # version of this format
name: )" +
         name +
         R"(
summary: One cell divides twice into four, two of each kind
seed: 1                        # chooses the random numbers; equal seeds give equal results

# Genes. g1(a1|a0): cells with a0 make a1 in their next cycle. divide and die act on the cell; at a division one
# daughter gets A and the other B. What is not made in a cycle is gone after it.
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(divide|a1)
  g4(left|a1,A)
  g5(right|a1,B)
  g6(left|left)
  g7(right|right)

cycle: {length: 1}             # [time] between cell cycles
stop: {cycles: 5}              # or time, or cells

physics:                       # without this block: the lineage only, without bodies
  time_step: auto              # or a number [time]
  mesh: {icosphere: 2}         # 162 vertices; or {file: shape.obj}
  cell: {radius: 1, mass: 1}
  pressure: {constant: 200, outside: 48}  # at rest constant / volume = outside
  drag: 5                      # the medium slows cells, so that they come to rest
  shell: {ellipsoid: [1.3, 1.1, 0.9], fill: 0.9}  # a shape, of which the egg fills 0.9; or {sphere: 1}; or none
  contact: {}                  # without it cells pass through one another

division: {plane: longest}     # or random, or {axis: [1, 0, 0]}
# connections: {on-division: both, strength: 0.1}  # sisters hold on to one another
variation: {cycle: 0.05, share: 0.02}  # what a seed changes, as standard deviations
# units: {length: µm, per-length: 20, time: min, per-time: 5}  # in which people see lengths and times

colours: {left: '#e41a1c', right: '#377eb8'}
record: {every: 0.25}          # [time] between samples in the database
)";
}

}  // namespace morula
