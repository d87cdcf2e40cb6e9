// morula export --format: files, messages and refusals. Programs of others read the contents: export_readers.sh.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string bodies = R"(morula: 1
name: small
dna: |
  START: a0
  g1(a0|a0)
  g2(divide|a0)
stop: {time: 2.25}
physics: {mesh: {icosphere: 1}, contact: {}}
)";
const std::string genes =
    "morula: 1\nname: genes\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 3}\n";

struct StoredRun {
  TemporaryFolder folder;
  std::string database = folder / "run.db", id;
  explicit StoredRun(const std::string& scene, int code = 0) { run(scene, {}, code); }
  void run(const std::string& scene, const Words& more = {}, int code = 0) {
    writeWhole(folder / "scene.yaml", scene);
    const Words words{"run", folder / "scene.yaml", "--db", database, "--no-pictures", "--quiet"};
    id = jsonOf(joined(words, more), code)["run_id"];
  }
  Launched exported(const std::string& format, const std::string& path, const Words& more = {}) const {
    return launch(joined({"export", database, "--format", format, "-o", folder / path}, more));
  }
  Words files(const std::string& path) const {
    Words names;
    for (const auto& entry : fs::directory_iterator(folder / path)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
};

}  // namespace

TEST_CASE("of one run a file or a folder is written, and stdout names the files") {
  const StoredRun stored(bodies + "record: {meshes: 1}\n");
  for (const auto& [format, path] :
       {std::pair("newick", "tree.nwk"), {"npz", "run.npz"}, {"ply", "end.ply"}, {"gltf", "end.glb"}}) {
    const auto launched = stored.exported(format, path);
    INFO(launched.err);
    REQUIRE(launched.code == 0);
    CHECK(launched.err.empty());
    CHECK(launched.out == stored.folder / path + "\n");
    CHECK(fs::file_size(stored.folder / path) > 50);
  }
  CHECK(stored.exported("vtk", "vtk").code == 0);
  CHECK(stored.files("vtk") == Words{"cells.csv", "columns.json", "states.csv", "surfaces.pvd", "surfaces_0000.vtp",
                                     "surfaces_0001.vtp", "surfaces_0002.vtp", "surfaces_0003.vtp"});
  CHECK(stored.exported("ply", "series").code == 0);
  CHECK(stored.files("series") ==
        Words{"0000.ply", "0001.ply", "0002.ply", "0003.ply", "cells.csv", "columns.json", "states.csv", "times.csv"});
  CHECK(stored.exported("gltf", "series-of-one", {"--time", "1"}).code == 0);
  CHECK(stored.files("series-of-one") == Words{"0000.glb", "cells.csv", "columns.json", "states.csv", "times.csv"});
  CHECK(stored.exported("csv", "tables").code == 0);
  CHECK(stored.files("tables") == Words{"against_cells.csv", "against_stages.csv", "cell_samples.csv", "cells.csv",
                                        "checks.csv", "columns.json", "connections.csv", "contacts.csv",
                                        "divisions.csv", "experiments.csv", "runs.csv", "samples.csv", "settlings.csv",
                                        "time_steps.csv"});
  const Json json = Json::parse(stored.exported("newick", "again.nwk", {"--json"}).out);
  CHECK(json["format"] == "newick");
  CHECK(json["runs"][0]["run_id"] == stored.id);
  CHECK(json["runs"][0]["files"][0] == stored.folder / "again.nwk");
}

TEST_CASE("the same run gives the same bytes, kept or made again, whatever computes it") {
  StoredRun stored(bodies);
  CHECK(stored.exported("npz", "a.npz").code == 0);
  CHECK(stored.exported("npz", "b.npz", {"--threads", "2"}).code == 0);
  CHECK(readWhole(stored.folder / "a.npz") == readWhole(stored.folder / "b.npz"));
  const auto told = stored.exported("gltf", "c.glb");
  CHECK_THAT(told.err, ContainsSubstring("run " + stored.id +
                                         " kept no surfaces (record.meshes keeps them); simulating it "
                                         "again to its end at 2.25") &&
                           ContainsSubstring("the end equals the stored one, bit for bit"));
  CHECK(stored.exported("gltf", "d.glb", {"--quiet"}).err.empty());
  CHECK(stored.exported("gltf", "e.glb", {"--time", "2.25"}).code == 0);
  CHECK(readWhole(stored.folder / "c.glb") == readWhole(stored.folder / "d.glb"));
  CHECK(readWhole(stored.folder / "c.glb") == readWhole(stored.folder / "e.glb"));
}

TEST_CASE("a time that was not kept is made again; a kept one is the first step at or after it") {
  const StoredRun stored(bodies + "record: {meshes: 1}\n");
  CHECK(stored.exported("ply", "kept.ply", {"--time", "1"}).err.empty());
  const auto launched = stored.exported("ply", "made.ply", {"--time", "1.3"});
  CHECK(launched.code == 0);
  CHECK_THAT(launched.err, ContainsSubstring("kept surfaces at 0, 1") && ContainsSubstring("simulating it again"));
  CHECK(readWhole(stored.folder / "made.ply") != readWhole(stored.folder / "kept.ply"));
}

TEST_CASE("tracks, graphs and arrays without surfaces come from stored samples, without a second run") {
  const StoredRun stored(bodies + "record: {every: 0.25}\nunits: {length: µm, per-length: 27}\n");
  for (const auto& [format, path] : {std::pair("tracks", "run.csv"), {"geff", "run.geff"}}) {
    const auto launched = stored.exported(format, path);
    CHECK(launched.code == 0);
    CHECK(launched.err.empty());
    CHECK_THAT(launched.out, ContainsSubstring(stored.folder / path));
  }
  CHECK(stored.exported("npz", "without.npz", {"--no-surfaces"}).err.empty());
  CHECK(stored.exported("npz", "moment.npz", {"--no-surfaces", "--time", "1"}).err.empty());
  CHECK_THAT(stored.exported("npz", "with.npz").err, ContainsSubstring("simulating it again"));
  const std::string npz = readWhole(stored.folder / "without.npz");
  CHECK_THAT(npz, ContainsSubstring("volumes.npy") && !ContainsSubstring("surface_cell.npy"));
  CHECK_THAT(readWhole(stored.folder / "with.npz"), ContainsSubstring("surface_cell.npy"));
  CHECK(npz.size() > readWhole(stored.folder / "moment.npz").size());
  const std::string table = readWhole(stored.folder / "run.csv");
  CHECK(table.starts_with("track_id,t,z,y,x,parent_track_id,name,path,volume,fate\r\n1,0,"));
  const Json columns = Json::parse(readWhole(stored.folder / "run.columns.json"));
  CHECK(columns.size() == 10);
  CHECK(columns["x"]["unit"] == "µm");
  CHECK(columns["volume"]["unit"] == "µm³");
  CHECK(columns["t"]["unit"] == "time");
  // A table is written only where its description can be written, too.
  fs::remove(stored.folder / "run.csv");
  refuses(stored.exported("tracks", "run.csv"), 6, "run.columns.json' is there already");
  CHECK(!fs::exists(stored.folder / "run.csv"));
}

TEST_CASE("tables have columns of names beside those of paths, and a description of all columns") {
  const StoredRun stored(bodies +
                         "connections: {}\nnames: {egg: zygote, cells: {A: left}}\nunits: {time: min, per-time: 4}\n");
  REQUIRE(stored.exported("csv", "tables").code == 0);
  const auto all = nlohmann::ordered_json::parse(readWhole(stored.folder / "tables/columns.json"));
  for (const auto& file : stored.files("tables")) {
    if (!file.ends_with(".csv")) continue;
    const std::string text = readWhole(stored.folder / "tables/" + file);
    std::string header;
    for (const auto& [column, about] : all.at(file.substr(0, file.size() - 4)).items()) {
      CHECK(!about.at("meaning").get<std::string>().empty());
      header = header + (header.empty() ? "" : ",") + column;
    }
    CHECK(text.starts_with(header + "\r\n"));
  }
  CHECK_THAT(readWhole(stored.folder / "tables/cells.csv"), ContainsSubstring(",egg,,,0,1,divided,") &&
                                                                ContainsSubstring(",A,egg,zygote,1,") &&
                                                                ContainsSubstring(",AA,A,left,2,"));
  CHECK_THAT(readWhole(stored.folder / "tables/connections.csv"), ContainsSubstring(",0,A,left,B,,1,"));
  CHECK_THAT(readWhole(stored.folder / "tables/divisions.csv"), ContainsSubstring(",egg,zygote,1,"));
  const auto& volume = all["cell_samples"]["volume"];
  CHECK(volume["unit"] == "length³");
  CHECK(!volume.contains("known_unit"));
  CHECK(all["cells"]["born"]["known_unit"].dump() == R"({"name":"min","factor":4.0})");
}

TEST_CASE("cells that no sample holds are told, and their daughters' tracks come from the last ancestor with one") {
  const StoredRun stored(bodies + "record: {every: 2}\ncycle: {per-substance: {a0: 0.75}}\n");
  const auto launched = stored.exported("tracks", "run.csv");
  CHECK(launched.code == 0);
  CHECK_THAT(launched.err, ContainsSubstring("run " + stored.id +
                                             ": cells that lived between two samples have no rows: A and B; "
                                             "record.every: 0.75 takes a sample of each"));
  CHECK_THAT(readWhole(stored.folder / "run.csv"), ContainsSubstring(",1,AA,AA,"));
  CHECK(stored.exported("tracks", "again.csv", {"--quiet"}).err.empty());
}

TEST_CASE("a run that ends otherwise now is not exported") {
  StoredRun stored(bodies);
  change(stored.database, "UPDATE run SET state_hash = '000102030405060708090a0b0c0d0e0f'");
  refuses(stored.exported("ply", "end.ply"), 1, "simulated again, ends in another state: stored 0001020304");
  CHECK(!fs::exists(stored.folder / "end.ply"));
}

TEST_CASE("of several runs each has its own files, and tables hold all") {
  StoredRun stored(bodies + "variation: {cycle: 0.05}\n");
  const std::string first = stored.id;
  stored.run(bodies + "variation: {cycle: 0.05}\n", {"--seed", "7"});
  Words ids{first, stored.id};
  std::sort(ids.begin(), ids.end());
  CHECK(stored.exported("newick", "trees").code == 0);
  CHECK(stored.files("trees") == Words{ids[0] + ".nwk", ids[1] + ".nwk"});
  CHECK(stored.exported("ply", "plys", {"--time", "1"}).code == 0);
  CHECK(stored.files("plys") == Words{ids[0] + ".ply", ids[1] + ".ply"});
  CHECK(stored.exported("vtk", "vtks").code == 0);
  CHECK(stored.files("vtks") == ids);
  CHECK(stored.exported("csv", "runs.csv", {"--table", "runs"}).code == 0);
  const std::string runs = readWhole(stored.folder / "runs.csv");
  CHECK_THAT(runs, ContainsSubstring("\r\n" + first + ",small,0,done,") &&
                       ContainsSubstring("\r\n" + stored.id + ",small,7,done,"));
  CHECK(stored.exported("csv", "one.csv", {"--table", "runs", "--run", first}).code == 0);
  CHECK(readWhole(stored.folder / "one.csv").find(stored.id) == std::string::npos);
  CHECK(stored.exported("newick", "first.nwk", {"--run", first}).code == 0);
  CHECK(readWhole(stored.folder / "first.nwk") == readWhole(stored.folder / "trees/" + first + ".nwk"));
}

TEST_CASE("a run that failed is left out among others, which is said, and keeps its tree") {
  StoredRun stored(bodies);
  const std::string good = stored.id;
  stored.run(bodies, {"--set", "physics.membrane.production=40"}, 4);
  const auto launched = stored.exported("vtk", "all");
  CHECK(launched.code == 0);
  CHECK_THAT(launched.err, ContainsSubstring("run " + stored.id +
                                             " is left out, because it did not come to its "
                                             "end: "));
  CHECK(stored.files("all") == Words{good});
  CHECK_THAT(stored.exported("npz", "failed.npz", {"--run", stored.id}).err,
             ContainsSubstring("did not come to its end (failed), so there are no surfaces of it"));
  CHECK(stored.exported("newick", "trees").code == 0);
  CHECK(stored.files("trees").size() == 2);
  refuses(stored.exported("vtk", "failed", {"--run", stored.id}), 6, "did not come to its end (failed)");
}

TEST_CASE("cells without bodies have trees, tables and arrays, and no surfaces") {
  const StoredRun stored(genes);
  CHECK(stored.exported("npz", "run.npz").err.empty());
  CHECK(stored.exported("csv", "tables").code == 0);
  CHECK(stored.exported("newick", "tree.nwk").code == 0);
  CHECK_THAT(readWhole(stored.folder / "tree.nwk"),
             Catch::Matchers::EndsWith("egg:1[&&NHX:path=egg:fate=divided:state=a0 divide];\n"));
  for (const char* format : {"vtk", "ply", "gltf"})
    refuses(stored.exported(format, "none"), 2, "has no bodies, and so no surfaces; needs csv, newick or npz");
  for (const char* format : {"tracks", "geff"})
    refuses(stored.exported(format, "none"), 2, "has no bodies, and so no places of cells; needs csv, newick or npz");
  CHECK(!fs::exists(stored.folder / "none"));
}

TEST_CASE("what is asked for in a wrong way") {  // of requests that need surfaces; others: bad_commands
  const StoredRun stored(bodies + "record: {meshes: 1}\n");
  refuses(stored.exported("newik", "x"), 2, "--format: there is no format 'newik'; did you mean newick?");
  refuses(stored.exported("vtk", "x", {"--time", "9"}), 2,
          "--time: 9 is after the end of run " + stored.id + "; needs at most 2.25");
  refuses(stored.exported("newick", "x", {"--time", "1"}), 2, "--time: newick has no times");
  refuses(stored.exported("tracks", "x", {"--time", "1"}), 2, "--time: tracks has the times of all samples");
  for (const char* format : {"csv", "tracks", "ply"})
    refuses(stored.exported(format, "x", {"--no-surfaces"}), 2, "--no-surfaces: ");
  refuses(stored.exported("csv", "x.csv"), 2, "holds one table; name it with --table");
  refuses(stored.exported("csv", "x", {"--table", "cell"}), 2, "there is no table 'cell'; did you mean cells?");
  refuses(stored.exported("csv", "x", {"--table", "measures_world"}), 6, "has no rows for the table measures_world");
  refuses(stored.exported("vtk", "x", {"--run", "ffff"}), 6, "no run ffff");
  CHECK(!fs::exists(stored.folder / "x"));
  CHECK(!fs::exists(stored.folder / "x.csv"));
  writeWhole(stored.folder / "there.nwk", "another tree");
  refuses(stored.exported("newick", "there.nwk"), 6, "is there already; give another name");
  CHECK(readWhole(stored.folder / "there.nwk") == "another tree");
  refuses(stored.exported("vtk", ""), 6, "is there already");
}

TEST_CASE("a tree without comments is asked for of newick alone") {
  const StoredRun stored(genes);
  CHECK(stored.exported("newick", "plain.nwk", {"--no-comments"}).code == 0);
  CHECK(stored.exported("newick", "full.nwk").code == 0);
  const std::string plain = readWhole(stored.folder / "plain.nwk"), full = readWhole(stored.folder / "full.nwk");
  CHECK(plain.find('[') == std::string::npos);
  CHECK(full.find("[&&NHX:path=") != std::string::npos);
  for (const std::string format : {"npz", "csv"}) {
    const auto refused = stored.exported(format, "out", {"--no-comments"});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, ContainsSubstring("--no-comments: only --format newick has comments; leave it out"));
  }
}

TEST_CASE("tables tell the egg from no mother without quotes") {
  const StoredRun stored(genes);
  REQUIRE(stored.exported("csv", "cells.csv", {"--table", "cells"}).code == 0);
  const std::string table = readWhole(stored.folder / "cells.csv");
  CHECK_THAT(table, ContainsSubstring(",egg,,,0,") && ContainsSubstring(",A,egg,"));
  CHECK(table.find("\"\"") == std::string::npos);
}

TEST_CASE("a crate without a licence says that strict readers refuse it") {
  const StoredRun stored(genes);
  const Words words{"export", stored.database, "--ro-crate"};
  CHECK_THAT(succeeds(joined(words, {stored.folder / "without"})).err, ContainsSubstring("--license CC-BY-4.0"));
  CHECK(succeeds(joined(words, {stored.folder / "quiet", "--quiet"})).err.empty());
  CHECK(succeeds(joined(words, {stored.folder / "with", "--license", "CC-BY-4.0"})).err.empty());
}

TEST_CASE("a series of surfaces goes on after the last cell has died") {
  const StoredRun stored(
      "morula: 1\nname: gone\ndna: |\n  START: a0\n  g1(die|a0)\nstop: {time: 1.5}\n"
      "physics: {mesh: {icosphere: 0}, drag: 2}\nrecord: {every: 0.5}\n");
  CHECK(stored.exported("ply", "series").code == 0);
  CHECK(stored.files("series") ==
        Words{"0000.ply", "0001.ply", "0002.ply", "cells.csv", "columns.json", "states.csv", "times.csv"});
  CHECK_THAT(readWhole(stored.folder / "series/0002.ply"), ContainsSubstring("element vertex 0\n"));
  CHECK(stored.exported("ply", "end.ply").code == 2);
}

TEST_CASE("replay holds kept surfaces against the run made again") {
  StoredRun stored(bodies + "record: {meshes: 1}\n");
  CHECK(launch({"replay", stored.database}).code == 0);
  change(stored.database,
         "UPDATE mesh_sample SET vertices = zeroblob(length(vertices)) WHERE path = 'A' AND time = (SELECT max(time) "
         "FROM mesh_sample WHERE path = 'A')");
  CHECK_THAT(
      endsWith(1, {"replay", stored.database}).out,
      ContainsSubstring("mesh_sample     1 of ") && ContainsSubstring("vertices: stored 252 bytes with the hash "));
}
