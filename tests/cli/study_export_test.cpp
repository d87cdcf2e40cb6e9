// morula study export: one crate of a whole study, its methods, and study replay, which repeats it elsewhere.
#include <cstdlib>
#include <set>

#include "catch.h"
#include "cli/crate.h"
#include "launch.h"
#include "reseal.h"
#include "stored.h"

using namespace morula::test;

namespace {

/// A study of eight short runs, whose scenarios and genes lie in folders beside and below the study file.
struct CrateOfStudy {
  TemporaryFolder folder;
  std::string file = folder / "studies/small.study.yaml", out = folder / "out", crate = folder / "the crate";
  CrateOfStudy() {
    fs::create_directories(folder / "studies");
    fs::create_directories(folder / "genes");
    std::string scenario = readWhole(MORULA_SOURCE_DIR "/tests/studies/small.yaml");
    const auto dna = scenario.find("dna: |"), stop = scenario.find("stop:");
    scenario.replace(dna, stop - dna, "dna: {file: ../genes/two words.dna}\n");
    writeWhole(folder / "studies/small.yaml", scenario);
    writeWhole(folder / "genes/two words.dna", "START: a0\ng1(a0|a0)\ng2(divide|a0)\n");
    writeWhole(file,
               "morula-study: 1\nname: small\nbase: small.yaml\nvary:\n"
               "  division: {longest: {}, random: {division.plane: random}}\n  room: {own: {}, wide: "
               "{physics.shell.sphere: 1.2}}\nseeds: 1..2\nmeasures: [sphericity, extent]\n"
               "check: [{measure: sphericity, a: {division: longest}, b: {division: random}, says: higher}]\n");
    study("run", {"--no-predict", "--quiet"});
  }
  Launched study(const std::string& verb, const Words& more = {}, int code = 0) const {
    const Words words{"study", verb, file, "--allow-outside"};
    return endsWith(code, joined(words, joined(verb == "run" ? Words{"--out", out} : Words{}, more)));
  }
  Launched exported(const Words& more) const {
    return succeeds(joined({"study", "export", out, "--license", "CC-BY-4.0"}, more));
  }
};

Json metadataOf(const std::string& crate) { return Json::parse(readWhole(crate + "/ro-crate-metadata.json")); }

bool isSame(const Json& replay, const std::string& file) {
  for (const Json& one : replay["derived"])
    if (one["file"] == file) return one["same"];
  return false;
}

}  // namespace

TEST_CASE("a study's crate is strict RO-Crate 1.1, and repeats elsewhere to the byte") {
  const CrateOfStudy study;
  study.exported({"--out", study.crate, "--agent", "A. Nother"});
  const Json metadata = metadataOf(study.crate);
  CHECK(mistakes(metadata, study.crate, true) == "");
  for (const char* part : {"README.md", "study/study/small.study.yaml", "study/study/small.yaml",
                           "study/genes/two%20words.dna", "study.db", "values.csv", "comparison.json", "comparison.txt",
                           "claims.json", "methods.md", "references.bib", "figures/values.svg", "report.html"}) {
    CAPTURE(part);
    CHECK(hasPart(metadata, part));
  }
  CHECK_THAT(readWhole(study.crate + "/README.md"), ContainsSubstring("\nmorula study replay .\n"));

  // Elsewhere, and without the sources: only the crate is left.
  const std::string moved = study.folder / "elsewhere/crate";
  fs::create_directories(study.folder / "elsewhere");
  fs::rename(study.crate, moved);
  for (const char* gone : {"studies", "genes", "out"}) fs::remove_all(study.folder / gone);
  const Json replay = jsonOf({"study", "replay", moved});
  CHECK(replay["same_bytes"] == true);
  CHECK(replay["runs"].size() == 2);
  for (const Json& run : replay["runs"]) CHECK((run["same"] == true && run["rows"] > 10));
  for (const char* file : {"values.csv", "comparison.json", "claims.json"}) CHECK(isSame(replay, file));
  CHECK(mistakes(metadata, moved, true) == "");  // nothing was left in the crate
  CHECK(jsonOf({"study", "replay", moved, "--runs", "1000000"})["runs"].size() == 8);

  // Changed files are told, and the others are still the same.
  writeWhole(moved + "/values.csv", "division,room\n");
  writeWhole(moved + "/new", "");
  const Json changed = jsonOf({"study", "replay", moved, "--runs", "1"}, 1);
  CHECK(changed["files"]["changed"] ==
        Json({"new: not in ro-crate-metadata.json", "values.csv: changed since the crate was made"}));
  CHECK_FALSE(isSame(changed, "values.csv"));
  CHECK(isSame(changed, "comparison.json"));
  writeWhole(moved + "/study/genes/two words.dna", "START: a0\ng1(a1|a0)\ng2(divide|a0)\n");
  const Json other = jsonOf({"study", "replay", moved}, 1);
  CHECK(other["plan"].size() >= 1);
  CHECK(other["runs"].empty());
}

TEST_CASE("a crate can be a zip, and the methods can be written alone") {
  const CrateOfStudy study;
  const std::string zip = study.folder / "small.zip", methods = study.folder / "methods.md";
  study.exported({"--out", zip, "--no-page"});
  REQUIRE(std::system(("cd '" + study.folder.path() + "' && python3 -m zipfile -e small.zip unpacked").c_str()) == 0);
  const std::string crate = study.folder / "unpacked/small";
  CHECK(mistakes(metadataOf(crate), crate, true) == "");
  CHECK(jsonOf({"study", "replay", crate})["same_bytes"] == true);

  succeeds({"study", "export", study.out, "--methods", methods});
  CHECK_FALSE(fs::exists(study.out + "/crate"));
  const std::string text = readWhole(methods), sources = readWhole(study.folder / "methods.bib");
  CHECK(text == readWhole(crate + "/methods.md"));
  CHECK(sources == readWhole(crate + "/references.bib"));
  for (const char* word :
       {"Morula 0.1.0 [@morula]", "commit ", "division (longest, random), room (own, wide)", "2 seeds each (1, 2)",
        "[@holm1979]", "sphericity (`sphericity`)", "extent (`extent`, length)"})
    CHECK_THAT(text, ContainsSubstring(word));
  CHECK(text.find("schuirmann") == text.npos);  // no claim of equivalence
  // Every source that is cited is there, and no other; the program's is CITATION.cff's.
  std::set<std::string> cited, there;
  const std::regex key("@([a-z]+[0-9]{4}|morula)\\b"), entry("@[a-z]+\\{([a-z0-9]+),");
  for (std::sregex_iterator at(text.begin(), text.end(), key), end; at != end; ++at) cited.insert((*at)[1]);
  for (std::sregex_iterator at(sources.begin(), sources.end(), entry), end; at != end; ++at) there.insert((*at)[1]);
  CHECK(cited == there);
  CHECK(cited.size() >= 6);
  const std::string citation = readWhole(MORULA_SOURCE_DIR "/CITATION.cff");
  for (const char* word : {"Morula: a deterministic, scenario-driven simulator of dividing cells", "0.1.0",
                           "Physical Simulation and Visualisation of Cells", "LiTH-ISY-EX--08/4071--SE", "Nilsson"}) {
    CAPTURE(word);
    CHECK_THAT(citation, ContainsSubstring(word));
    CHECK_THAT(sources, ContainsSubstring(word));
  }
}

TEST_CASE("what cannot be a crate of a study is refused, with the way") {
  const CrateOfStudy study;
  const std::string run = study.folder / "run.db", folder = study.folder / "is-there";
  succeeds({"run", study.folder / "studies/small.yaml", "--allow-outside", "--db", run, "--no-pictures"});
  refuses({"study", "export", run}, 3, "holds runs of no study; ");
  fs::create_directories(folder);
  writeWhole(folder + "/mine", "");
  refuses({"study", "export", study.out, "--out", folder}, 6, "is-there");
  writeWhole(study.folder / "mine.zip", "mine");
  refuses({"study", "export", study.out, "--out", study.folder / "mine.zip"}, 6, "mine.zip");
  CHECK(readWhole(study.folder / "mine.zip") == "mine");
  refuses({"study", "replay", study.out}, 6, "is no crate of a study: ");
  change(study.out + "/study.db", "UPDATE task SET status = 'missing', run_id = NULL WHERE number = 0");
  reseal(study.out + "/study.db");
  refuses({"study", "export", study.out}, 3, "1 of 8 runs have no result; compute them by `");
}
