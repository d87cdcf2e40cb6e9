// morula accuracy, as users and other programs see it.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string swinging =
    "morula: 1\nname: swinging\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\n"
    "physics:\n  mesh: {icosphere: 1}\n  membrane: {stiffness: 10, damping: 0.02}\n"
    "  pressure: {constant: 8, outside: 0}\n  drag: 4\n";

struct Bench {
  TemporaryFolder folder;
  Bench() { writeWhole(folder / "swinging.yaml", swinging); }
  Words words(const Words& more) const {
    return joined({"accuracy", folder / "swinging.yaml", "--out", folder.path(), "--rounds", "1"}, more);
  }
};

}  // namespace

TEST_CASE("accuracy --json: rows, orders and speeds as the contract says, and a picture") {
  const Bench bench;
  const auto run = succeeds(bench.words({"--json", "--target", "1e-3", "--quiet", "--level", "0"}));
  CHECK(run.err.empty());
  const auto json = Json::parse(run.out);
  CHECK(json["morula"] == 1);
  CHECK(json["reference"]["agrees"] == true);
  CHECK(readWhole(json["picture"]).substr(1, 3) == "PNG");
  std::size_t failed = 0, spheres = 0;
  REQUIRE(json["rows"].size() == 9 * 5 + 2 * 6);  // cheaper models also run with their longest step
  for (const auto& row : json["rows"]) {
    CAPTURE(row.dump());
    CHECK(row["engine"] == "morula");
    CHECK(row["settings"]["integrator"].is_string());
    CHECK(row["failed"].is_boolean());
    failed += row["failed"] == true;
    spheres += row["settings"]["cell_model"] == "sphere";
    CHECK(row["error"].is_number() == (row["failed"] == false));
    CHECK(row["failure"].is_string() == (row["failed"] == true));
    CHECK(row["cpu_seconds"] >= 0);
    CHECK(row["force_evaluations"].is_number_unsigned());
  }
  CHECK(failed > 0);
  CHECK(spheres == 6);
  CHECK(json["orders"].size() == 11);
  CHECK_FALSE(json["speed_at_error"].empty());
  for (const auto& s : json["speed_at_error"]) CHECK(s["cpu_seconds"] > 0);

  // `run` accepts the settings that accuracy names.
  Words again{"run", bench.folder / "swinging.yaml", "--no-pictures", "--quiet", "--db", bench.folder / "db"};
  for (const auto& change : json["target"]["settings"]["set"]) again.insert(again.end(), {"--set", change});
  CHECK(launch(again).code == 0);
}

TEST_CASE("accuracy for people: series, orders, speeds and the line to use") {
  const Bench bench;
  const auto run = succeeds(bench.words({"--target", "1e-2", "--only", "--integrator", "rk4"}));
  CHECK_THAT(run.out, ContainsSubstring("velocity-verlet (the scenario's own)"));
  CHECK_THAT(run.out, ContainsSubstring("they agree"));
  CHECK_THAT(run.out, ContainsSubstring("order"));
  CHECK_THAT(run.out, ContainsSubstring("--set physics.integrator="));
  CHECK_THAT(run.out, !ContainsSubstring("explicit-euler"));
  CHECK(launch(bench.words({"--target", "1e-30", "--only", "--integrator", "rk4"})).code == 1);
}

TEST_CASE("accuracy refuses what has no error") {  // wrong options: bad_commands
  const Bench bench;
  refuses(bench.words({"--until", "1e-9"}), 3, "are too short to compare");
  refuses(bench.words({"--set", "physics.integrator=explicit-euler", "--set", "physics.drag=0"}), 3,
          "physics.drag > 0");
}

TEST_CASE("accuracy --bullet sets Bullet's soft bodies beside ours") {
  const Bench bench;
  const auto json =
      jsonOf(bench.words({"--bullet", "--quiet", "--only", "--integrator", "velocity-verlet", "--halvings", "2"}));
  std::size_t bullets = 0;
  for (const auto& row : json["rows"]) bullets += row["engine"].get<std::string>().starts_with("bullet-");
  if (bullets == 0) {
    WARN("this build has no Bullet");
    return;
  }
  for (const auto& row : json["rows"])
    if (row["engine"] == "bullet-b1" && row["failed"] == false) CHECK(row["error"] < 0.5);
  for (const auto& s : json["beside_bullet"]) {
    CHECK(s["cpu_seconds"] > 0);
    CHECK(s["bullet_cpu_seconds"] > 0);
  }
}
