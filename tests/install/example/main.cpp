// Runs a scenario, reports each division, and prints the hash that `morula run` prints.
//
//   example SCENARIO.yaml [physics.drag=5…]
#include <morula/morula.h>
#include <morula/scenario.h>

#include <iostream>

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::cerr << "example SCENARIO.yaml [KEY=VALUE…]\n";
    return 2;
  }
  const auto read = morula::readScenario(argv[1], {argv + 2, argv + argc});
  for (const std::string& warning : read.warnings) std::cerr << warning << '\n';
  morula::Simulator organism(read.scene);
  for (std::size_t cells = 0; !organism.finished(); organism.step()) {
    if (organism.cells() == cells) continue;
    cells = organism.cells();
    std::cout << "time " << organism.now() << ": " << cells << " cells, volume "
              << organism.measure("volume").value_or(0) << '\n';
  }
  const morula::DataTable table = organism.table("cell_sample");
  for (const morula::DataColumn& column : table.columns)
    std::cout << column.name << (column.unit.empty() ? "" : " [" + column.unit + "]") << ' ';
  std::cout << '\n';
  const auto pressures = organism.column("pressure");
  for (std::size_t i = 0; i < organism.cells(); ++i)
    std::cout << organism.path(i) << ": " << organism.substances(i) << ", " << organism.vertices(i).size() / 3
              << " vertices, pressure " << pressures[i] << '\n';
  std::cout << organism.steps() << " steps, state hash " << organism.hash() << '\n';
} catch (const morula::InputError& error) {
  std::cerr << error.what() << '\n';
  return 3;
} catch (const morula::NumericalError& error) {
  std::cerr << error.what() << '\n';
  return 4;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
