// Runs a scene, reports each division, and prints the hash that `morula run` prints.
//
//   morula validate SCENARIO.yaml --scene a.scene && example a.scene
#include <morula/morula.h>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "example SCENE\n";
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  if (!file) throw std::runtime_error(std::string(argv[1]) + ": cannot be read");
  morula::Simulator organism(std::string(std::istreambuf_iterator<char>(file), {}));
  for (std::size_t cells = 0; !organism.finished(); organism.step()) {
    if (organism.cells() == cells) continue;
    cells = organism.cells();
    std::cout << "time " << organism.now() << ": " << cells << " cells, volume "
              << organism.measure("volume").value_or(0) << '\n';
  }
  for (std::size_t i = 0; i < organism.cells(); ++i)
    std::cout << organism.path(i) << ": " << organism.substances(i) << ", " << organism.vertices(i).size() / 3
              << " vertices\n";
  std::cout << organism.steps() << " steps, state hash " << organism.hash() << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
