// Runs a scene and prints the hashes of its golden, as they come out here: its lines `bits` and `step_hash`.
// For machines where there is the simulator, but not the program.
//
//   run_scene [--isa NAME] SCENE GOLDEN     SCENE: written by write_scene
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "scene_text.h"
#include "simulation/measures.h"
#include "simulation/world.h"

using namespace morula;

namespace {

/// Throws FileError.
std::ifstream open(const char* file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(std::string(file) + ": cannot be read");
  return in;
}

/// The steps at which the golden has a hash.
std::map<std::uint64_t, std::string> stepsOf(std::istream& golden) {
  std::map<std::uint64_t, std::string> steps;
  for (std::string line; std::getline(golden, line);) {
    std::istringstream words(line);
    std::string kind;
    std::uint64_t step;
    if (words >> kind >> step && kind == "step_hash") steps[step];
  }
  return steps;
}

void run(const Scene& scene, std::map<std::uint64_t, std::string> hashes, const Execution& execution) {
  World world = makeWorld(scene, execution);
  const auto look = [&] {
    const auto wanted = hashes.find(world.clock.step);
    if (wanted != hashes.end()) wanted->second = stateHash(world).text();
  };
  look();
  while (!finished(world)) {
    step(world);
    look();
  }
  std::cout << "bits solver " << stateHash(world).text() << '\n';
  for (const auto& [step, hash] : hashes)
    std::cout << "step_hash " << std::to_string(step) << ' ' << hash << '\n';
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
