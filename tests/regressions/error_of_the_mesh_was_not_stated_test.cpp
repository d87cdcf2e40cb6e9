// Stated errors were those of the time step alone: the reference ran on the scenario's mesh, whose error was fifty
// times as large. Now `accuracy` states both errors; a run on a mesh two levels finer confirms that of the mesh.
#include <cmath>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

// The scenario is scenarios/bullet/pressed-pair, one mesh level coarser and for a shorter time.
const std::string pair = R"(morula: 1
name: pair
dna: |
  START: a0
  g1(a0|a0)
cycle: {length: 1000}
stop: {time: 2}
cells:
  - {at: [-0.85, 0, 0], stretch: [0.8, 0.8, 0.8]}
  - {at: [0.85, 0, 0], stretch: [0.8, 0.8, 0.8]}
physics:
  time_step: 0.00390625
  drag: 8
  mesh: {icosphere: 1}
  cell: {radius: 1, mass: 1}
  membrane: {stiffness: 10, damping: 0.02}
  pressure: {constant: 800, outside: 166}
  shell: {ellipsoid: [1.95, 1.3, 1.3]}
  contact: {}
)";

struct Cell {
  double x = 0, volume = 0, pressure = 0, contactArea = 0;
};

/// Returns the first cell at the end of a run.
Cell cellAtEnd(const TemporaryFolder& folder, const std::string& level, const std::string& timeStep) {
  const std::string file = folder / ("level" + level + ".db");
  succeeds({"run", folder / "pair.yaml", "--no-pictures", "--no-check", "--quiet", "--db", file, "--out", folder.path(),
            "--set", "physics.mesh.icosphere=" + level, "--set", "physics.time_step=" + timeStep});
  morula::Database db = opened(file);
  morula::Statement row(db, "SELECT x, volume, pressure FROM cell_sample ORDER BY time DESC, path LIMIT 1");
  REQUIRE(row.next());
  morula::Statement contact(db, "SELECT area FROM contact ORDER BY time DESC LIMIT 1");
  REQUIRE(contact.next());
  return {row.real(0), row.real(1), row.real(2), contact.real(0)};
}

Json accuracyOf(const TemporaryFolder& folder, const std::string& scenario) {
  return jsonOf({"accuracy", folder / scenario, "--quiet", "--only", "--integrator", "velocity-verlet", "--halvings",
                 "1", "--rounds", "1", "--out", folder.path()});
}

}  // namespace

TEST_CASE("accuracy: the stated error of the mesh is what a mesh two levels finer shows") {
  const TemporaryFolder folder;
  writeWhole(folder / "pair.yaml", pair);
  const Json json = accuracyOf(folder, "pair.yaml"), mesh = json["mesh"];
  CAPTURE(mesh.dump(1));
  REQUIRE(mesh["levels"].size() == 3);
  CHECK(mesh["levels"][2]["icosphere"] == 3);
  CHECK(mesh["order_is_observed"] == true);
  const Json stated = mesh["levels"][0]["at_end"];

  const Cell coarse = cellAtEnd(folder, "1", "0.00390625"), fine = cellAtEnd(folder, "3", "0.0009765625");
  // Positions are centroids of enclosed volumes, whose error is a tenth of that of the vertices' centroid.
  CHECK(stated["position"] < 0.2 * std::abs(coarse.x - fine.x));
  CHECK(stated["contact_area"] == Approx(std::abs(coarse.contactArea / fine.contactArea - 1)).epsilon(0.2));
  CHECK(stated["volume"] == Approx(std::abs(coarse.volume / fine.volume - 1)).epsilon(0.2));
  CHECK(stated["pressure"] == Approx(std::abs(coarse.pressure / fine.pressure - 1)).epsilon(0.2));

  // The total error has both parts.
  const Json own = json["as_it_is"];
  CHECK(own["parts"]["mesh"] == mesh["error"]);
  CHECK(own["error"].get<double>() >= own["parts"]["time"].get<double>() + mesh["error"].get<double>());
  CHECK(own["parts"]["mesh"].get<double>() > stated["position"].get<double>() * 0.99);
}

TEST_CASE("accuracy: spheres have no error of a mesh, and of a mesh from a file it is not known") {
  const TemporaryFolder folder;
  const auto report = [&](const std::string& physics) {
    writeWhole(folder / "one.yaml",
               "morula: 1\nname: one\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.25}\n"
               "cells:\n  - {at: [0, 0, 0]}\n  - {at: [1.5, 0, 0]}\nphysics:\n  drag: 4\n  contact: {}\n" +
                   physics);
    return accuracyOf(folder, "one.yaml");
  };
  const Json spheres = report("  cell: {model: sphere}\n");
  CHECK(spheres["mesh"]["error"] == 0);
  CHECK(spheres["as_it_is"]["parts"]["mesh"] == 0);
  writeWhole(folder / "cube.obj",
             "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
             "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\n"
             "f 2 4 8\nf 2 8 6\n");
  const Json file = report("  mesh: {file: cube.obj}\n  pressure: {constant: 8, outside: 0}\n");
  CHECK(file["mesh"]["error"].is_null());
  CHECK_THAT(file["mesh"]["unknown"].get<std::string>(), ContainsSubstring("comes from a file"));
  CHECK(file["as_it_is"]["parts"]["mesh"].is_null());
}
