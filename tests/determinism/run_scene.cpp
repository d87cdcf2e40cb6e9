// Runs a scene and prints the hashes of its golden, as they come out here: its lines `bits` and `step_hash`,
// these without the short hashes of cells. For machines where there is the simulator, but not the program.
//
//   run_scene [--isa NAME] SCENE GOLDEN     SCENE: written by write_scene
#include <cstring>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "scene_text.h"
#include "simulation/hash.h"
#include "simulation/world.h"

using namespace morula;

namespace {

/// Throws FileError.
std::ifstream open(const char* file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(std::string(file) + ": cannot be read");
  return in;
}

/// The steps at which the golden's chain has a link.
std::set<std::uint64_t> stepsOf(std::istream& golden) {
  std::set<std::uint64_t> steps;
  for (std::string line; std::getline(golden, line);) {
    std::istringstream words(line);
    std::string kind;
    std::uint64_t step;
    if (words >> kind >> step && kind == "step_hash") steps.insert(step);
  }
  return steps;
}

void run(const Scene& scene, const std::set<std::uint64_t>& steps, const Execution& execution) {
  World world = makeWorld(scene, execution);
  std::string chain;
  std::optional<Hash> last;
  const auto look = [&] {
    if (!steps.contains(world.clock.step)) return;
    last = nextLink(last, world).hash;
    chain += "step_hash " + std::to_string(world.clock.step) + ' ' + last->text() + '\n';
  };
  look();
  while (!finished(world)) {
    step(world);
    look();
  }
  std::cout << "bits solver " << stateHash(world).text() << '\n' << chain;
}

}  // namespace

int main(int argc, char** argv) try {
  Execution execution;
  if (argc == 5 && std::strcmp(argv[1], "--isa") == 0) execution.isa = parseIsa(argv[2]);
  else if (argc != 3) {
    std::cerr << "run_scene [--isa NAME] SCENE GOLDEN\n";
    return 2;
  }
  std::ifstream scene = open(argv[argc - 2]), golden = open(argv[argc - 1]);
  run(scene_text::read(scene), stepsOf(golden), execution);
} catch (const std::exception& error) {
  std::cerr << "run_scene: " << error.what() << '\n';
  return 3;
}
