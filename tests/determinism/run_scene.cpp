// Runs a scene and prints the hashes that its golden holds: the lines `bits` and `step_hash`, the latter without the
// short hashes of cells. It serves machines that have the simulator, but not the program.
//
//   run_scene [--isa NAME] SCENE GOLDEN     SCENE: written by write_scene
#include <cstring>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/floating_point.h"
#include "library/scene_format.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

/// Opens a file. Throws FileError if it cannot be read.
std::ifstream open(const char* file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(std::string(file) + ": cannot be read");
  return in;
}

/// The hash chain of a golden: a link at step 0, every, 2·every, … and at the end, of which some are written down.
struct Chain {
  std::uint64_t every = 0;
  std::set<std::uint64_t> written;
};

/// Reads the chain of a golden. Throws InputError if hash_every is missing.
Chain readChain(std::istream& golden) {
  Chain chain;
  for (std::string line; std::getline(golden, line);) {
    std::istringstream words(line);
    std::string kind, name;
    if (words >> kind >> name && kind == "step_hash") chain.written.insert(std::stoull(name));
    else if (kind == "count" && name == "hash_every") words >> chain.every;
  }
  if (chain.every == 0) throw InputError("the golden does not say how often it has a hash: count hash_every");
  return chain;
}

void run(const Scene& scene, const Chain& chain, const Execution& execution) {
  World world = makeWorld(scene, execution);
  std::string links;
  std::optional<Hash> last;
  const auto look = [&] {
    const std::uint64_t step = world.clock.step;
    if (step % chain.every != 0 && !finished(world)) return;
    last = nextLink(last, world).hash;
    if (chain.written.contains(step)) links += "step_hash " + std::to_string(step) + ' ' + last->text() + '\n';
  };
  look();
  while (!finished(world)) {
    step(world);
    look();
  }
  std::cout << "bits solver " << stateHash(world).text() << '\n' << links;
}

}  // namespace

int main(int argc, char** argv) try {
  setFloatingPoint();
  Execution execution;
  if (argc == 5 && std::strcmp(argv[1], "--isa") == 0) execution.isa = parseIsa(argv[2]);
  else if (argc != 3) {
    std::cerr << "run_scene [--isa NAME] SCENE GOLDEN\n";
    return 2;
  }
  std::ifstream scene = open(argv[argc - 2]), golden = open(argv[argc - 1]);
  std::ostringstream text;
  text << scene.rdbuf();
  run(readScene(text.str(), argv[argc - 2]), readChain(golden), execution);
} catch (const std::exception& error) {
  std::cerr << "run_scene: " << error.what() << '\n';
  return 3;
}
