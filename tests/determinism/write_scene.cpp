// Writes a scenario's scene for run_scene.
//
//   write_scene SCENARIO >FILE
#include <iostream>

#include "library/scene_format.h"
#include "scenario/scenario.h"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "write_scene SCENARIO >FILE\n";
    return 2;
  }
  std::cout << morula::writeScene(morula::loadScenario(argv[1]).scene);
  return std::cout.flush() ? 0 : 6;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 3;
}
