#pragma once
// The list of cell–cell connections, and the functions that make and end them [Nilsson 2008, §4.4.3].
#include <array>
#include <vector>

#include "base/cell_path.h"
#include "connections/parameters.h"
#include "physics/bodies.h"

namespace morula {

/// Why a connection ended.
enum class ReleaseCause { none, divided, died, distance, gene, tension, age, experiment };
template <>
inline constexpr auto choices<ReleaseCause> = std::to_array<Choice<ReleaseCause>>({
    {ReleaseCause::none, "", "the connection holds"},
    {ReleaseCause::divided, "divided", "one of the cells divided"},
    {ReleaseCause::died, "died", "one of the cells died"},
    {ReleaseCause::distance, "distance", "the cells are too far apart"},
    {ReleaseCause::gene, "gene", "a gene releases it"},
    {ReleaseCause::tension, "tension", "its spring is stretched too much"},
    {ReleaseCause::age, "age", "it has held for its time"},
    {ReleaseCause::experiment, "experiment", "an experiment released it"},
});

struct ConnectionRecord {
  CellPath a, b;                   // a < b
  double made = 0, released = -1;  // [time]; released < 0: it still holds
  ReleaseCause cause = ReleaseCause::none;
};

/// Scratch memory of addConnectionForces, kept so that a steady step allocates nothing.
struct ConnectionScratch {
  std::vector<std::array<int, 2>> ends;  // [active connection] the numbers of its cells
  std::vector<int> first, next,
      ofCell;                  // a cell's active connections: ofCell[first[cell]] to first[cell + 1]
  std::vector<Vector> centre;  // [cell] for cells with a connection
};

struct Connections {
  ConnectionParameters parameters;
  std::vector<ConnectionRecord> history;  // all connections in the order in which they were made
  std::vector<std::size_t> active;        // places in history, by (a, b)

  ConnectionScratch scratch;
  bool isCurrent = true;  // the last forces are those of `active`
};

bool areConnected(const Connections& connections, const CellPath& a, const CellPath& b);
/// Connects two cells unless they are connected, or one of them has ConnectionParameters::most connections.
void connect(Connections& connections, const CellPath& a, const CellPath& b, double time);
/// Ends the connection of two cells, if they have one.
void release(Connections& connections, const CellPath& a, const CellPath& b, double time, ReleaseCause cause);
/// Ends all connections of a cell that dies.
void releaseAll(Connections& connections, const CellPath& cell, double time, ReleaseCause cause);
/// Returns the other ends of a cell's connections, by path.
std::vector<CellPath> partners(const Connections& connections, const CellPath& cell);

/// Returns the radius [length] of the sphere that holds a cell's volume.
double roundRadius(const Bodies& bodies, int slot);
/// Returns the tension [force] of a spring between two cells; < 0: the spring pushes them apart.
double springTension(const ConnectionSpring& spring, const Bodies& bodies, int slotA, int slotB, double distance);

/// Returns the energy [force·length] of the active connections: k_c times the distance, or of springs ½ k (d − rest)².
double measureConnectionEnergy(const Connections& connections, const std::vector<CellPath>& paths,
                               const Bodies& bodies);

/// Adds adhesion [Nilsson 2008, eq. 4.9] to the bodies' forces: on each of the two cells the constant force k_c towards
/// the other's centre, spread evenly over its vertices; equal and opposite on a pair. `paths` [cell], sorted. Without a
/// strength k_c is the smaller of what the two cells have for each of their connections. With a spring k_c is the
/// spring's tension, which pushes where it is negative.
void addConnectionForces(Connections& connections, const std::vector<CellPath>& paths, Bodies& bodies, int threads = 1);

}  // namespace morula
