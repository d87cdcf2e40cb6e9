// init --from: a simulated embryo as a table, and the scenario that is made of it, give the same embryo again.
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;

namespace {

constexpr double framesPerTime = 4, micrometres = 17.02;  // of scenarios/worm/embryo.yaml

struct Table {
  std::string text;
  std::map<std::string, int> firstFrame;  // by name
};

/// The samples of a database that fall on whole frames.
Table tableOf(const std::string& database, bool hasVolumes) {
  Table table{std::string("track_id,t,z,y,x,parent_track_id") + (hasVolumes ? ",volume\n" : "\n"), {}};
  Database db = opened(database);
  Statement row(db,
                "SELECT s.time, c.name, s.z, s.y, s.x, m.name, s.volume FROM cell_sample s JOIN cell c USING (path) "
                "LEFT JOIN cell m ON m.path = c.parent ORDER BY s.time");
  while (row.next()) {
    const double frame = row.real(0) * framesPerTime;
    if (frame != std::round(frame)) continue;
    table.firstFrame.try_emplace(row.text(1), static_cast<int>(frame));
    table.text += row.text(1) + "," + std::to_string(static_cast<int>(frame));
    for (int i = 2; i < 5; ++i) table.text += "," + std::to_string(row.real(i) * micrometres);
    table.text += "," + (row.isNull(5) ? "" : row.text(5));
    if (hasVolumes) table.text += "," + std::to_string(row.real(6) * std::pow(micrometres, 3));
    table.text += "\n";
  }
  return table;
}

/// [µm] Runs a scenario to the end of a stage. Returns the distance from its reference in the middle of that.
double distanceAt(int cells, const std::string& folder, const std::string& scenario, const Words& more) {
  const std::string database = folder + "/" + std::to_string(cells) + ".db";
  const std::string reference = "real/" + std::to_string(cells) + ".txt";
  const auto ran = succeeds(joined({"run", scenario, "--db", database, "--no-pictures", "--set", "record.every=0.25",
                                    "--set", "check.reference.file=" + reference},
                                   more));
  CHECK_THAT(ran.out + ran.err, !ContainsSubstring("warning"));
  const std::string where = " FROM sample WHERE cells = " + std::to_string(cells);
  const double middle = realIn(database, "SELECT 0.5 * (min(time) + max(time))" + where);
  return micrometres * realIn(database, "SELECT value FROM measure WHERE name = 'position_rmsd' ORDER BY abs(time - " +
                                            std::to_string(middle) + ")");
}

/// [s] Processor time of all programs that this one has started and that have ended.
double secondsOfChildren() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

}  // namespace

TEST_CASE("an embryo that is read from its own samples has the same lives, and its cells come to the same places") {
  const TemporaryFolder folder;
  const std::string original = folder / "original.db";
  succeeds({"run", "scenarios/worm/embryo.yaml", "--db", original, "--no-pictures", "--no-check", "--quiet", "--set",
            "stop.time=17", "--set", "record.every=0.25", "--set", "physics.mesh.icosphere=1", "--set",
            "physics.shell.fill=0.85"});
  struct Case {
    bool hasVolumes, areBalls;
    std::map<int, double> bounds;  // [µm] by number of cells
  };
  for (const Case& one : {Case{true, false, {{4, 0.8}, {8, 1.2}, {15, 3}}}, Case{false, false, {{8, 3}}},
                          Case{true, true, {{4, 3}, {8, 5}, {12, 4}, {15, 5}}}}) {
    const std::string own = folder / ("made" + std::to_string(one.hasVolumes) + std::to_string(one.areBalls));
    const Table table = tableOf(original, one.hasVolumes);
    const std::string file = folder / "tracks.csv", scenario = own + "/embryo.yaml";
    writeWhole(file, table.text);
    Words command{"init", scenario, "--from", file, "--units", "µm,min", "--model", one.areBalls ? "sphere" : "mesh"};
    const auto said = succeeds(one.hasVolumes ? joined(command, {"--shell", "27,15,14"}) : command);
    CHECK((said.err.find("the shell is fitted to the cells' centres") == std::string::npos) == one.hasVolumes);
    refuses(command, 6, "is there already");
    const Words coarse =
        one.areBalls ? Words{} : Words{"--set", "physics.mesh.icosphere=1", "--set", "physics.shell.fill=0.85"};
    for (const auto& [cells, bound] : one.bounds) {
      INFO(cells << " cells");
      const Words stop{"--set", "stop.cells=" + std::to_string(cells + 1)};
      CHECK(distanceAt(cells, own, scenario, one.areBalls ? coarse : joined(coarse, stop)) < bound);
    }
    Database db = opened(own + "/" + std::to_string(one.bounds.rbegin()->first) + ".db");
    // A cell divides in the first step that reaches its time, which is less than one time step later.
    Statement row(db,
                  "SELECT name, born, (SELECT t.time_step FROM time_step t WHERE t.time < born ORDER BY t.step DESC "
                  "LIMIT 1) FROM cell");
    while (row.next()) {
      const double late = row.real(1) - table.firstFrame.at(row.text(0)) / framesPerTime;
      CHECK((late >= 0 && (late == 0 || late < row.real(2))));
    }
  }
}

TEST_CASE("a run's own table of tracks gives its lineage again, and lies where the run does") {
  const TemporaryFolder folder;
  // B's daughters stand in another order by name than by path, and one cell dies.
  writeWhole(folder / "grown.yaml",
             "morula: 1\nname: grown\ndna: |\n  START: a0\n  g1(a1|a0)\n  g2(divide|a0)\n  g3(a2|a1,A)\n"
             "  g4(divide|a1)\n  g5(die|a2,A)\nstop: {time: 3.5}\nnames: {egg: P0, cells: {A: z, B: y, BA: w, BB: v}}\n"
             "physics: {mesh: {icosphere: 1}, drag: 5, contact: {}}\n"
             "record: {every: 0.25}\nunits: {length: µm, per-length: 27, time: min, per-time: 4}\n");
  const std::string tracks = folder / "tracks.csv", made = folder / "made/made.yaml";
  const auto ran = [&](const std::string& scenario, const std::string& database, const Words& more = {}) {
    return succeeds(joined({"run", scenario, "--db", folder / database, "--no-pictures"}, more));
  };
  ran(folder / "grown.yaml", "grown.db");
  succeeds({"export", folder / "grown.db", "--format", "tracks", "-o", tracks});
  const auto told = succeeds({"init", made, "--from", tracks, "--units", "µm,min", "--per-time", "4"});
  CHECK_THAT(told.err, !ContainsSubstring("not read"));
  ran(made, "made.db");
  const auto lives = [&](const std::string& database, bool named) {
    std::string text;
    Database db = opened(folder / database);
    Statement row(
        db, "SELECT path, CAST(born AS TEXT), CAST(ended AS TEXT), fate, ifnull(name, path) FROM cell ORDER BY path");
    while (row.next())
      for (int i = 0; i < (named ? 5 : 4); ++i) text += (row.isNull(i) ? "-" : row.text(i)) + (i < 4 ? " " : "\n");
    return text;
  };
  CHECK(lives("made.db", true) == lives("grown.db", true));
  // The table has the places of the run, to rounding.
  const auto against =
      jsonOf({"run", folder / "grown.yaml", "--db", folder / "again.db", "--no-pictures", "--against", tracks});
  for (const auto& stage : against.at("against").at("stages")) CHECK(stage.at("rmsd").get<double>() < 1e-6);
}

TEST_CASE("the command at the head of a shipped embryo makes its files again from its table, byte for byte") {
  const TemporaryFolder folder;
  const auto [family, stem] = GENERATE(std::pair("worm", "embryo"), std::pair("urchin", "cleavage"));
  const std::string from = std::string("scenarios/") + family + "/", kept = readWhole(from + stem + ".yaml");
  // The command's lines begin with '#', and all but the last end with a backslash.
  std::string command;
  for (std::size_t at = kept.find("# morula init "); command.empty() || command.ends_with('\\');) {
    const std::size_t end = kept.find('\n', at);
    if (command.ends_with('\\')) command.pop_back();
    command += kept.substr(at + 1, end - at - 1);
    at = end + 1;
  }
  command.replace(command.find("morula"), 6, "\"$MORULA\"");
  writeWhole(folder / (std::string(stem) + ".csv"), readWhole(from + stem + ".csv"));
  writeWhole(folder / "again.sh", "cd '" + folder.path() + "' &&" + command + "\n");
  REQUIRE(std::system(("MORULA='" MORULA_PROGRAM "' sh '" + (folder / "again.sh") + "' 2>/dev/null").c_str()) == 0);
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    const std::string name = std::filesystem::relative(entry.path(), folder.path()).string();
    if (!entry.is_regular_file() || name == "again.sh") continue;
    INFO(name);
    CHECK(readWhole(entry.path().string()) == readWhole(from + name));
    ++files;
  }
  CHECK(files >= 7);  // table, scenario, DNA and at least four references
}

TEST_CASE("cells of a table that die, and cells without a mother, live and run as the table says") {
  const TemporaryFolder folder;
  const std::string file = folder / "cells.csv", scenario = folder / "cells.yaml";
  writeWhole(file, "cell,parent,birth,end,fate,x,y\na,,0,8,,0,0\nb,a,8,12,dies,0,5\nc,a,,,,5,0\nd,,0,,,5,5\n");
  const auto said = succeeds({"init", scenario, "--from", file});
  CHECK_THAT(said.err, ContainsSubstring("2 cells have no mother") && ContainsSubstring("the table has no column z"));
  const auto ran = succeeds({"run", scenario, "--db", folder / "cells.db", "--no-pictures"});
  CHECK_THAT(ran.out + ran.err, !ContainsSubstring("warning"));
  const std::string tree = succeeds({"lineage", folder / "cells.db"}).out;
  CHECK_THAT(tree, ContainsSubstring("a  divided 0–8") && ContainsSubstring("b  died 8–12") &&
                       ContainsSubstring("c  alive since 8") && ContainsSubstring("d  alive since 0"));
  refuses({"init", scenario, "--force", "--from", file, "--root", "z"}, 3, "--root: the table has no cell 'z'");
  const auto first = readWhole(scenario);
  succeeds({"init", scenario, "--force", "--from", file, "--root", "a", "--units", "0.5µm,2min"});
  CHECK(readWhole(scenario) != first);
  CHECK_THAT(readWhole(scenario), ContainsSubstring("time: min, per-time: 4"));
}

TEST_CASE("a table of 100,000 rows is read within two seconds of processor time") {
  const TemporaryFolder folder;
  const std::string file = folder / "large.csv";
  std::string text = "track_id,t,z,y,x,parent_track_id,volume\n";
  for (int cell = 1; cell < 1024; ++cell)
    for (int depth = static_cast<int>(std::log2(cell)), t = 100 * depth; t < 100 * depth + 100; ++t)
      text += std::to_string(cell) + "," + std::to_string(t) + ",1.5," + std::to_string(cell % 32) + "," +
              std::to_string(cell / 32) + "," + (cell > 1 ? std::to_string(cell / 2) : "") + ",50.25\n";
  writeWhole(file, text);
  const double before = secondsOfChildren();
  succeeds({"init", folder / "large.yaml", "--from", file});
  if (memoryCanBeLimited) CHECK(secondsOfChildren() - before < 2);
}
