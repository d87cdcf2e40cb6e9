// The claims of the shipped studies hold, the README.md of their folders say what the claims
// say, and their figures are what their commands draw, by the values of all runs (kept_studies.h). With
// MORULA_DRAW_FIGURES=1 in the environment the figures are drawn anew instead of compared.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/evidence.h"
#include "cli/kept_studies.h"
#include "figures.h"
// Included last, because of CHECK:
#include "catch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// The files of the scenarios that a study in scenarios/policies varies, as it names them.
std::vector<std::string> basesOf(const std::string& study) {
  std::istringstream lines(readWhole(sourceFile("scenarios/policies/" + study + ".study.yaml")));
  std::vector<std::string> bases;
  for (std::string line; std::getline(lines, line);)
    for (const std::string begin : {"base: ", "  - "})
      if (line.starts_with(begin) && line.ends_with(".yaml")) bases.push_back(line.substr(begin.size()));
  return bases;
}

/// …/scenarios/FAMILY/NAME.yaml -> …/golden/FAMILY/NAME.golden
std::string goldenOf(const std::string& scenario) {
  const auto file = std::filesystem::path(scenario).lexically_normal(), family = file.parent_path();
  return (family.parent_path().parent_path() / "golden" / family.filename() / file.stem()).string() + ".golden";
}

/// The line itself, or up to the "…" at its end.
bool isPrinted(const std::string& line, const std::string& output) {
  const std::string rest = "…";
  const bool cut = line.ends_with(rest);
  const std::string wanted = trimmed(cut ? line.substr(0, line.size() - rest.size()) : line);
  std::istringstream stream(output);
  for (std::string printed; std::getline(stream, printed);) {
    printed = trimmed(printed);
    if (cut ? printed.starts_with(wanted) : printed == wanted) return true;
  }
  return false;
}

/// Returns a golden without its digest, and with intervals without width as "one-path". Old form: shipped goldens have
/// such intervals until they are written anew; then the files can be compared as they are.
std::string withoutOldIntervals(const std::string& golden) {
  std::string text;
  std::istringstream lines(golden);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("end ")) continue;
    const std::size_t low = line.find(" low "), high = line.find(" high "), runs = line.find(" runs ");
    if (line.starts_with("statistic ") && low != line.npos &&
        line.substr(low + 5, high - low - 5) == line.substr(high + 6, runs - high - 6))
      line.replace(low, runs - low, " one-path");
    text += line + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("Every line that the tutorial shows is what its command prints") {
  const TemporaryFolder temporary;
  const auto shown = shownIn(readWhole(sourceFile("scenarios/policies/TUTORIAL.md")));
  CHECK(shown.size() >= 6);
  for (const Shown& one : shown) {
    auto command = one.command;
    for (std::string& word : command) {
      if (word == "clones/study.db") word = databaseOf(temporary, "clones");
      if (word.ends_with(".svg") || word.ends_with(".png") || word.ends_with(".html")) word = temporary / word;
    }
    const std::string& verb = command[0];
    // The whole study takes minutes: databaseOf makes some of its runs. Pictures need them all.
    if ((verb == "study" && command[1] == "run") || std::ranges::find(command, "--pictures") != command.end()) continue;
    if (verb == "run" || verb == "study") command.insert(command.end(), {"--out", temporary / "results"});
    CAPTURE(command);
    const auto run = succeeds(command);
    for (const std::string& line : one.lines) {
      INFO(line);
      CHECK(isPrinted(line, run.out + run.err));
    }
  }
}

TEST_CASE("the claims of the shipped studies hold, and their READMEs say what these and the figures' commands say") {
  const TemporaryFolder temporary;
  const auto family = GENERATE(std::string("policies"), std::string("worm"), std::string("urchin"));
  const std::string folder = "scenarios/" + family + "/", markdown = readWhole(sourceFile(folder + "README.md"));
  const bool draws = std::getenv("MORULA_DRAW_FIGURES");
  std::map<std::string, std::vector<Evidence>> claims, printed;  // by study
  for (const auto& [study, runs] : madeAgain) {
    if (familyOf(study) != family + "/") continue;
    const Json checked = jsonOf({"study", "check", databaseOf(temporary, study)});
    for (const Json& claim : checked["claims"]) {
      INFO(claim.dump());
      CHECK(claim["holds"] == true);
      claims[study].emplace_back(claim["found"].get<std::string>(), claim["claim"].get<std::string>());
    }
  }
  std::size_t figures = 0;
  for (const Shown& one : shownIn(markdown)) {
    auto command = one.command;
    CAPTURE(command);
    REQUIRE(command.size() > 4);
    const std::string study = command[2].substr(0, command[2].find('/')), figure = "figures/" + command.back();
    REQUIRE(claims.contains(study));
    CHECK_THAT(markdown, ContainsSubstring("](" + figure + ")"));
    const std::string kept = sourceFile(folder + figure), drawn = draws ? kept : temporary / "figure.png";
    std::filesystem::create_directories(std::filesystem::path(drawn).parent_path());
    command[2] = databaseOf(temporary, study), command.back() = drawn;
    std::istringstream lines(succeeds(command).out);
    bool inTable = false;  // of an interaction, which is one piece of evidence
    for (std::string line; std::getline(lines, line);) {
      const std::string words = withSingleBlanks(line);
      if (inTable && !words.empty()) printed[study].back() = Evidence(printed[study].back().found + '\n' + words);
      else printed[study].emplace_back(words);
      inTable = !words.empty() && (inTable || words.find(", interaction η²") != words.npos);
    }
    succeeds({"render", kept, "--compare", drawn});
    for (const std::string ending : {".svg", ".pdf"}) {  // as a journal prints it
      auto printed = command;
      printed.back() = temporary / ("printed" + ending);
      succeeds(joined(printed, {"--size", "85mm"}));
      const std::string file = readWhole(printed.back());
      CHECK(wrongOn(ending == ".svg" ? pageOfSvg(file) : pageOfPdf(file), 85) == "");
      CHECK((ending == ".svg" || holdsFonts(file)));
    }
    ++figures;
  }
  CHECK(figures >= (family == "policies" ? 8 : family == "worm" ? 1 : 0));
  std::map<std::string, std::set<const Evidence*>> stated;  // claims by study
  for (const Paragraph& paragraph : paragraphsOf(markdown)) {
    INFO(paragraph.text);
    if (paragraph.study.empty())
      CHECK(std::ranges::none_of(numbersIn(paragraph.text), [](const Number& one) { return one.decimals > 0; }));
    if (paragraph.study.empty() || paragraph.study == "no study") continue;
    REQUIRE(claims.contains(paragraph.study));
    std::vector<Evidence> evidence;
    for (const std::string& words : paragraph.chosen) {
      INFO(words);
      const auto chosen = [&](const Evidence& line) { return line.says(words); };
      for (const Evidence& claim : claims.at(paragraph.study))
        if (chosen(claim)) evidence.push_back(claim), stated[paragraph.study].insert(&claim);
      if (std::ranges::any_of(claims.at(paragraph.study), chosen)) continue;
      const auto& lines = printed[paragraph.study];
      CHECK(std::ranges::count_if(lines, chosen) == 1);
      std::ranges::copy_if(lines, std::back_inserter(evidence), chosen);
    }
    checkNumbers(paragraph.text, evidence);
  }
  for (const auto& [study, all] : claims)
    for (const Evidence& claim : all) {
      INFO(study << ": no paragraph states " << claim.words);
      CHECK((study == "clones" || stated[study].contains(&claim)));  // those of clones: TUTORIAL.md
    }
}

TEST_CASE("the claims of a shipped study hold of its results, and others would not") {
  const TemporaryFolder temporary;
  const std::string database = databaseOf(temporary, "models");
  const Json json = jsonOf({"study", "check", database});
  CHECK(json["missing"] == 0);
  REQUIRE(json["claims"].size() == 10);
  for (const Json& claim : json["claims"]) {
    INFO(claim.dump());
    CHECK(claim["holds"] == true);
  }
  // The results of another law, as a changed simulator might give them.
  change(database,
         "UPDATE result SET value = 0.6 * value WHERE measure = 'clone_radius' AND run_id IN (SELECT run_id FROM "
         "replicate JOIN task USING (task_id) WHERE replicate.condition_id = (SELECT min(condition_id) + 1 FROM "
         "condition))");
  const auto failing = endsWith(1, {"study", "check", database, "--reports", temporary / "reports"});
  CHECK_THAT(failing.out,
             ContainsSubstring("models: 9 of 10 claims hold\n  FAIL  clone_radius: thesis-law equivalent to shell "
                               "within 5%\n        clone_radius: 64 % wider under shell") &&
                 ContainsSubstring("; different within "));
  CHECK_THAT(readWhole(temporary / "reports/junit.xml"),
             ContainsSubstring("failures=\"1\"") && ContainsSubstring("models.study.yaml:"));
}

TEST_CASE("the statistics in goldens are those of the studies") {
  const TemporaryFolder temporary;
  for (const char* folder : {"scenarios", "golden"})
    std::filesystem::copy(sourceFile(folder), temporary / folder, std::filesystem::copy_options::recursive);
  std::size_t onePath = 0;  // number of goldens with runs that stay one path
  for (const std::string study :
       {"elegans-128", "elegans-1024", "beyond-chaos-42", "beyond-chaos-162", "beyond-chaos-step"}) {
    std::map<std::string, std::string> before;  // goldens by their scenario
    Words command{"study", "compare", databaseOf(temporary, study), "--by", "settings", "--into-golden", ""};
    for (const std::string& base : basesOf(study)) {
      const std::string scenario = temporary / "scenarios/policies/" + base;
      before[scenario] = readWhole(goldenOf(scenario));
      CHECK_THAT(before[scenario], ContainsSubstring("\nstatistic sphericity against half-step difference "));
      command.back() += (command.back().empty() ? "" : ",") + scenario;
    }
    REQUIRE(!before.empty());
    succeeds(command, {{"CI", ""}});
    for (const auto& [scenario, golden] : before) {
      INFO(scenario);
      const std::string written = readWhole(goldenOf(scenario));
      CHECK(withoutOldIntervals(written) == withoutOldIntervals(golden));
      onePath += written.find(" one-path runs ") != written.npos;
    }
    // The golden says nothing of another scenario; if one of several is another, it says nothing of all.
    const auto& [first, unchanged] = *before.begin();
    const std::string& last = before.rbegin()->first;
    const Words oneMeasure = joined(command, {"--measure", "sphericity"});
    writeWhole(last, readWhole(last) + "\n");
    CHECK_THAT(endsWith(3, oneMeasure, {{"CI", ""}}).err, ContainsSubstring("of another scenario"));
    const std::string written = readWhole(goldenOf(first));
    CHECK(withoutOldIntervals(written) == withoutOldIntervals(unchanged));
  }
  CHECK(onePath > 0);
}
