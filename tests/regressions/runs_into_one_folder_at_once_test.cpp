// When four runs drew into one folder at once, two failed on their pictures: one removed the sequence that another was
// writing. Now all end well and draw one after the other.
#include <filesystem>
#include <thread>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("four runs into one folder at once all end well") {
  const TemporaryFolder folder;
  const std::string file = folder / "small.yaml";
  writeWhole(file,
             "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.5}\nphysics: {mesh: "
             "{icosphere: 0}, contact: {}, drag: 2}\nrecord: {pictures: 0.5}\n");
  std::vector<Launched> runs(4);
  std::vector<std::thread> threads;
  for (Launched& run : runs)
    threads.emplace_back([&] { run = launch({"run", file, "--out", folder / "out", "--quiet"}); });
  for (std::thread& thread : threads) thread.join();
  for (const Launched& run : runs) {
    INFO(run.out << run.err);
    CHECK(run.code == 0);
  }
  std::size_t frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/small-0/sequence"))
    frames += entry.path().extension() == ".png";
  CHECK(frames == 4);
  CHECK(launch({"replay", folder / "out/small-0/run.db", "--quiet"}).code == 0);
}
