// Runs a fixed list of scenes and prints one line for each: its name, steps, cells, and a hash over the whole
// run. Any build, on any machine, prints the same lines (core/README.md, "Same bits").
//
//   hash_program [--isa NAME] [--threads N] [--comma]
#include <clocale>
#include <cstring>
#include <iostream>
#include <locale>

#include "base/floating_point.h"
#include "scenes.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

/// A locale whose numbers have a decimal comma, also on systems without such a locale.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Returns a scene with more cells than a block, and so a thread, holds.
Scene sixteen() {
  Scene scene = scenes::packed();
  scene.stop.time = 4.25;
  return scene;
}

void run(const Scene& scene, const Execution& execution) {
  World world = makeWorld(scene, execution);
  Hash chain = stateHash(world);
  while (!finished(world)) {
    step(world);
    if (world.clock.step % 8 == 0) chain = Hasher().add(chain).add(stateHash(world)).digest();
  }
  chain = Hasher().add(chain).add(stateHash(world)).digest();
  std::cout << scene.name << ' ' << std::to_string(world.clock.step) << ' ' << std::to_string(world.cells.path.size())
            << ' ' << chain.text() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  setFloatingPoint();
  std::setlocale(LC_ALL, "");  // the environment's locale
  Execution execution;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--isa") == 0 && i + 1 < argc) execution.isa = parseIsa(argv[++i]);
    else if (std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc) execution.threads = std::atoi(argv[++i]);
    else if (std::strcmp(argv[i], "--comma") == 0) std::locale::global(std::locale(std::locale(), new Comma));
    else if (std::strcmp(argv[i], "--isas") == 0) {
      for (Isa isa : availableIsas()) std::cout << name(isa) << '\n';
      return 0;
    } else {
      std::cerr << "hash_program [--isas] [--isa NAME] [--threads N] [--comma]\n";
      return 2;
    }
  }
  using namespace scenes;
  const Scene positions = byPositions(ellipsoid(), 3), shapes = byShapes(life());
  for (const Scene& scene :
       {sixteen(), ellipsoid(), thesis(), life(), lifeOfCubes(), lineageOnly(eventful, 12), inSingle(sixteen()),
        inSingle(ellipsoid()), inSingle(thesis()), inSingle(life()), positions, shapes, inSingle(positions),
        inSingle(shapes), sticky(), turning(), sensing(), varied()})
    run(scene, execution);
}
