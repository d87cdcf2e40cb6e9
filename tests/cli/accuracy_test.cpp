// morula accuracy as its users and other programs read it.
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
  std::vector<std::string> arguments(const std::vector<std::string>& more, const std::string& scenario) const {
    std::vector<std::string> all{"accuracy", folder / scenario, "--out", folder.path(), "--rounds", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Launched accuracy(const std::vector<std::string>& more, const std::string& scenario = "swinging.yaml") const {
    return launch(arguments(more, scenario));
  }
  /// Outside of continuous integration, where goldens may be written.
  Launched accuracyOfPeople(const std::vector<std::string>& more) const {
    return launch(arguments(more, "swinging.yaml"), {{"CI", ""}});
  }
};

}  // namespace

TEST_CASE("accuracy --json: rows, orders and speeds as the contract says, and a picture") {
  const Bench bench;
  const auto run = bench.accuracy({"--json", "--target", "1e-3", "--quiet", "--level", "0"});
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.err.empty());
  const auto json = Json::parse(run.out);
  CHECK(json["morula"] == 1);
  CHECK(json["reference"]["agrees"] == true);
  CHECK(readWhole(json["picture"]).substr(1, 3) == "PNG");
  std::size_t failed = 0, spheres = 0;
  REQUIRE(json["rows"].size() == 9 * 5 + 2 * 6);  // cheaper models also with the longest step that they bear
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

  // The settings that it names are settings that run takes.
  std::vector<std::string> again{
      "run", bench.folder / "swinging.yaml", "--no-pictures", "--quiet", "--db", bench.folder / "db"};
  for (const auto& change : json["target"]["settings"]["set"]) {
    again.push_back("--set");
    again.push_back(change);
  }
  CHECK(launch(again).code == 0);
}

TEST_CASE("accuracy for people: series, orders, speeds and the line to use") {
  const Bench bench;
  const auto run = bench.accuracy({"--target", "1e-2", "--only", "--integrator", "rk4"});
  REQUIRE(run.code == 0);
  CHECK_THAT(run.out, ContainsSubstring("velocity-verlet (the scenario's own)"));
  CHECK_THAT(run.out, ContainsSubstring("they agree"));
  CHECK_THAT(run.out, ContainsSubstring("order"));
  CHECK_THAT(run.out, ContainsSubstring("--set physics.integrator="));
  CHECK_THAT(run.out, !ContainsSubstring("explicit-euler"));
  CHECK(bench.accuracy({"--target", "1e-30", "--only", "--integrator", "rk4"}).code == 1);
}

TEST_CASE("accuracy refuses what makes no sense, and says what would") {
  const Bench bench;
  const auto refused = [&](const std::vector<std::string>& more, int code, const std::string& text) {
    refuses(bench.accuracy(more), code, text);
  };
  refused({"--until", "0"}, 2, "--until: 0 is out of range; needs a number > 0");
  refused({"--until", "7"}, 2, "--until: 7 is after the scene's end; needs at most 1");
  refused({"--until", "1e-9"}, 3, "nothing to compare");
  refused({"--target", "small"}, 2, "--target: 'small'");
  refused({"--integrator", "leapfrog"}, 2, "'leapfrog' is not known; needs velocity-verlet");
  refused({"--quick", "--target", "1e-2"}, 2, "--quick is a first look");
  refused({"--level", "9"}, 2, "--level: 9 is out of range");
  refused({"--set", "physics.integrator=explicit-euler", "--set", "physics.drag=0"}, 3, "physics.drag > 0");
  CHECK(launch({"accuracy", bench.folder / "none.yaml"}).code == 6);
  const auto genes = launch({"accuracy", "scenarios/thesis/elegans-1024.yaml"});
  CHECK(genes.code == 3);
  CHECK_THAT(genes.err, ContainsSubstring("lineage-only"));
}

TEST_CASE("accuracy --bullet sets Bullet's soft bodies beside ours") {
  const Bench bench;
  const auto run =
      bench.accuracy({"--json", "--bullet", "--quiet", "--only", "--integrator", "velocity-verlet", "--halvings", "2"});
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  const auto json = Json::parse(run.out);
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

TEST_CASE("accuracy --into-golden states the error of the scenario as it is, and of no other") {
  const Bench bench;
  const auto accept = [&] {
    return launch({"review", bench.folder / "swinging.yaml", "--accept", "--why", "first", "--by", "me", "--quiet"},
                  {{"CI", ""}});
  };
  const std::vector<std::string> quick{"--into-golden",   "--quiet",    "--only", "--integrator",
                                       "velocity-verlet", "--halvings", "2"};
  CHECK(bench.accuracyOfPeople(quick).code == 3);  // there is no golden
  REQUIRE(accept().code == 0);
  auto changed = quick;
  changed.insert(changed.end(), {"--set", "physics.drag=3"});
  CHECK(bench.accuracyOfPeople(changed).code == 2);
  CHECK(readWhole(bench.folder / "swinging.golden").find("\nerror ") == std::string::npos);
  const auto run = bench.accuracyOfPeople(quick);
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("as it is   error ") != std::string::npos);
  for (const char* line : {"\nerror position ", "\nerror pressure "})
    CHECK_THAT(readWhole(bench.folder / "swinging.golden"), ContainsSubstring(line));
  CHECK_THAT(readWhole(bench.folder / "swinging.golden"), !ContainsSubstring("\nerror neighbours "));
  CHECK_THAT(launch({"accuracy", "--stated", bench.folder / "swinging.golden"}).out, ContainsSubstring("swinging |"));
  CHECK(launch({"check", bench.folder / "swinging.yaml"}).code == 0);
  REQUIRE(accept().code == 0);  // the same scenario: its error stays
  CHECK(readWhole(bench.folder / "swinging.golden").find("\nerror ") != std::string::npos);
  writeWhole(bench.folder / "swinging.yaml", swinging + "  precision: single\n");
  CHECK(bench.accuracyOfPeople(quick).code == 3);  // accept its result first
  REQUIRE(accept().code == 0);
  CHECK(readWhole(bench.folder / "swinging.golden").find("\nerror ") == std::string::npos);
}
