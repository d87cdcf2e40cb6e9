// A ball was exported as an icosphere of its volume, whose vertices stood 2.7 % out of the ball and its shell. Now the
// vertices lie on the ball.
#include <cmath>
#include <cstring>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("the vertices of an exported ball lie on it, and within its shell") {
  const TemporaryFolder folder;
  writeWhole(folder / "ball.yaml",
             "morula: 1\nname: ball\ndna: 'START: a0'\nstop: {time: 0.25}\ndivision: {plane: random}\n"
             "physics: {time_step: 0.0625, drag: 10, mesh: {icosphere: 1}, shell: {sphere: 1},\n"
             "          cell: {model: sphere, radius: 0.99}}\n");
  succeeds({"run", folder / "ball.yaml", "--no-pictures", "--db", folder / "ball.db"});
  succeeds({"export", folder / "ball.db", "--format", "ply", "--time", "0.25", "-o", folder / "a.ply"});
  const std::string file = readWhole(folder / "a.ply"), end = "end_header\n";
  const std::size_t stride = 3 * sizeof(float) + 3 + sizeof(int), begin = file.find(end) + end.size();
  REQUIRE(file.find("element vertex 42\n") < begin);
  REQUIRE(file.size() > begin + 42 * stride);
  for (int v = 0; v < 42; ++v) {
    float x[3];
    std::memcpy(x, &file[begin + v * stride], sizeof x);
    CHECK(std::hypot(x[0], x[1], x[2]) == Approx(0.99).epsilon(1e-4));  // tolerance for 16 bits and single precision
  }
}
