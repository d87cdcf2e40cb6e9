// Checks that every sentence of scenarios/policies/README.md and scenarios/worm/README.md is the output of its command.
// Commands get the values of all runs of a study. The test repeats some runs, whose values must equal those in
// golden/FAMILY to the last bit; values of the others come from there. With MORULA_WHOLE_STUDIES=1 in the environment
// it repeats all runs, which takes a quarter of an hour of CPU time.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "catch.h"
#include "files/text.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using morula::Database;
using morula::Statement;
using Json = nlohmann::json;

namespace {

/// Returns the folder of a study within `scenarios/` and `golden/`.
std::string familyOf(const std::string& study) { return study == "worm-placement" ? "worm/" : "policies/"; }

/// Runs that the test repeats, by their number in the plan: a few short ones of each study.
const std::map<std::string, std::vector<std::size_t>> madeAgain{
    {"policies", {0, 249, 499}},  {"placement", {0, 139}},      {"settings", {0}},
    {"models", {0, 80}},          {"settling", {0, 60, 119}},   {"heavier", {20, 59}},
    {"heavier-128", {8}},         {"elegans-128", {20}},        {"elegans-1024", {6}},
    {"worm-placement", {0, 863}}, {"clones", {0, 239, 479}},    {"settling-sticky", {0, 39}},
    {"settling-128", {6}},        {"beyond-chaos-42", {0, 30}}, {"beyond-chaos-162", {0, 15}},
    {"beyond-chaos-step", {30}},  {"beyond-chaos-box", {0}},    {"beyond-chaos-thesis", {0, 29}}};

std::string sourceFile(const std::string& name) { return std::string(MORULA_SOURCE_DIR) + "/" + name; }

Words wordsOf(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// A block of code in a document: a command and its output. "…" stands for left-out lines, or for the rest of a line.
/// Each line of an answer to a question is a claim.
struct Shown {
  std::string text;  // the paragraph before the block
  Words command;     // without the program's name
  Words lines;       // "conditions measure=clone_radius labels.division=longest mean 0.742"
};

std::vector<Shown> shownIn(const std::string& markdown) {
  std::vector<Shown> shown;
  std::istringstream stream(markdown);
  bool inBlock = false, isShown = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inBlock = !inBlock, isShown = false;
    } else if (inBlock && line.starts_with("$ morula ")) {
      const auto words = wordsOf(line);
      shown.push_back({{words.begin() + 2, words.end()}, {}});
      isShown = true;
    } else if (isShown) {
      shown.back().lines.push_back(line);
    }
  }
  return shown;
}

/// Returns a number as text; texts stay.
std::string textOf(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Returns the member at a path such as "labels.division" or "points.8.mean"; null if there is none.
Json member(const Json& object, const std::string& path) {
  const Json* at = &object;
  std::istringstream stream(path);
  for (std::string key; std::getline(stream, key, '.');) {
    if (at->is_array() && std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; }))
      at = &at->at(std::stoul(key));
    else if (at->is_object() && at->contains(key)) at = &at->at(key);
    else return {};
  }
  return numbers;
}

/// Returns the only entry of a list whose members match words such as "measure=clone_radius".
Json entryOf(const Json& list, const Words& words) {
  Json found;
  int count = 0;
  for (const Json& entry : list) {
    const bool fits = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      const auto equals = word.find('=');
      return textOf(member(entry, word.substr(0, equals))) == word.substr(equals + 1);
    });
    if (fits) found = entry, ++count;
  }
  CHECK(count == 1);
  return found;
}

/// Rounds a value to the digits after the point that `like` has.
std::string rounded(double value, const std::string& like) {
  const auto point = like.find('.');
  const int digits = point == like.npos ? 0 : static_cast<int>(like.size() - point - 1);
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  const std::string text = buffer;
  return text.find_first_not_of("-0.") == text.npos && text.front() == '-' ? text.substr(1) : text;
}

/// A run's values as golden/FAMILY/NAME.csv keeps them (tests/studies/values.py).
struct KeptRun {
  std::string task, state, reason;                              // reason: for a failed run
  std::vector<std::tuple<double, std::string, double>> values;  // time, measure, value
};

std::vector<KeptRun> keptRuns(const std::string& study) {
  std::istringstream lines(readWhole(sourceFile("golden/" + familyOf(study) + study + ".csv")));
  std::string line;
  std::getline(lines, line);
  const auto head = morula::partsOf(line, ',');
  std::vector<KeptRun> runs;
  while (std::getline(lines, line)) {
    const auto cells = morula::partsOf(line, ',');
    if (runs.empty() || runs.back().task != cells[0]) runs.push_back({cells[0], cells[1], "", {}});
    if (cells[1] == "failed") runs.back().reason = line.substr(line.find(",failed,") + 8);
    else
      for (std::size_t i = 3; i < cells.size(); ++i)
        if (!cells[i].empty()) runs.back().values.emplace_back(std::stod(cells[2]), head[i], std::stod(cells[i]));
  }
  return runs;
}

/// Returns the values of the run with this id in a merged database.
std::vector<std::tuple<double, std::string, double>> valuesIn(Database& db, const std::string& run) {
  std::vector<std::tuple<double, std::string, double>> values;
  Statement rows(db, "SELECT time, measure, value FROM result WHERE run_id = ? ORDER BY time, measure");
  for (rows.start(run); rows.next();) values.emplace_back(rows.real(0), rows.text(1), rows.real(2));
  return values;
}

/// Repeats some of a study's runs, checks them against the golden, and merges them. Then adds the golden's values of
/// the other runs. Returns the database.
std::string databaseOf(const TemporaryFolder& temporary, const std::string& study) {
  const std::string to = temporary / study, file = to + "/study.db";
  if (std::filesystem::exists(file)) return file;
  INFO(study);
  const auto kept = keptRuns(study);
  Words command{"study",        "run",    "scenarios/" + familyOf(study) + study + ".study.yaml", "--out", to,
                "--no-predict", "--quiet"};
  const bool whole = std::getenv("MORULA_WHOLE_STUDIES");
  std::vector<std::size_t> made = madeAgain.at(study);
  if (whole)
    for (made.clear(); made.size() < kept.size();) made.push_back(made.size());
  for (const std::size_t number : made) command.insert(command.end(), {"--task", kept.at(number).task});
  succeeds(command);
  endsWith(whole ? 0 : 5, {"study", "merge", to, "--quiet"});  // most runs are missing
  Database db = opened(file);
  CHECK(db.integer("SELECT count(*) FROM task") == static_cast<std::int64_t>(kept.size()));
  CHECK(db.integer("SELECT count(*) FROM task WHERE status <> 'missing'") == static_cast<std::int64_t>(made.size()));
  db.execute("BEGIN; CREATE TEMPORARY TABLE copy AS SELECT * FROM run LIMIT 1");
  Statement find(db, "SELECT task.status, run_id, state_hash FROM task LEFT JOIN run USING (run_id) WHERE task_id = ?");
  Statement rename(db, "UPDATE copy SET run_id = ?, state_hash = ?");
  Statement add(db, "INSERT INTO run SELECT * FROM copy");
  Statement done(db, "UPDATE task SET status = 'done', run_id = ? WHERE task_id = ?");
  Statement failed(db, "UPDATE task SET status = 'failed', reason = ? WHERE task_id = ?");
  Statement value(db, "INSERT INTO result (run_id, time, measure, value) VALUES (?, ?, ?, ?)");
  for (const KeptRun& one : kept) {
    INFO(one.task);
    find.start(one.task);
    REQUIRE(find.next());
    const std::string status = find.text(0), id = find.text(1), state = find.text(2);
    find.next();
    if (status != "missing") {
      CHECK(status == (one.reason.empty() ? "done" : "failed"));
      if (one.reason.empty()) CHECK(state == one.state);
      CHECK(valuesIn(db, id) == one.values);
    } else if (!one.reason.empty()) {
      failed.run(one.reason, one.task);
    } else {
      rename.run(one.task, one.state);
      add.run();
      done.run(one.task, one.task);
      for (const auto& [time, measure, v] : one.values) value.run(one.task, time, measure, v);
    }
  }
  db.execute("COMMIT");
  reseal(file);
  return file;
}

/// Returns the scenario files that a study in scenarios/policies varies, as the study names them.
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

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(' ') + 1 - first);
}

/// Returns true if the output has this line; a line with "…" at its end is compared up to there.
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
    // Whole studies take minutes, so databaseOf repeats some runs only. Pictures need all runs.
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
  const auto family = GENERATE(std::string("policies"), std::string("worm"));
  auto answers = shownIn(readWhole(sourceFile("scenarios/" + family + "/README.md")));
  std::erase_if(answers, [](const Shown& one) { return one.command[0] != "study" || one.command[1] != "compare"; });
  CHECK(answers.size() >= (family == "worm" ? 4 : 10));
  std::map<Words, Json> said;  // output by command
  for (const Shown& answer : answers) {
    INFO(answer.text);
    REQUIRE(answer.command.size() >= 3);
    REQUIRE(answer.lines.size() >= 1);
    auto command = answer.command;
    command[2] = databaseOf(temporary, command[2].substr(0, command[2].find('/')));
    if (!said.contains(command)) { said.emplace(command, Json::parse(succeeds(command).out)); }
    for (const std::string& claim : answer.lines) {
      INFO(claim);
      const auto words = wordsOf(claim);
      std::size_t chosen = 1;  // words that choose the entry
      while (chosen < words.size() && words[chosen].find('=') != std::string::npos) ++chosen;
      REQUIRE(words.size() >= chosen + 2);
      const std::string& field = words[chosen];
      const std::string number = claim.substr(claim.find(' ' + field + ' ') + field.size() + 2);
      const Json entry =
          entryOf(said.at(command).at(words[0]), {words.begin() + 1, words.begin() + std::ptrdiff_t(chosen)});
      const Json value = member(entry, field);
      CHECK((value.is_number() ? rounded(value.get<double>(), number) : textOf(value)) == number);
      const std::string plain = number.front() == '-' ? number.substr(1) : number;
      CHECK_THAT(answer.text, ContainsSubstring(plain));
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
    for (std::string line; std::getline(lines, line);) printed[study].emplace_back(withSingleBlanks(line));
    succeeds({"study", "compare", kept, drawn});
    ++figures;
  }
  CHECK(figures >= (family == "worm" ? 1 : 8));
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
  // The results follow another law, as those of a changed simulator might.
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
      CHECK(readWhole(goldenOf(scenario)) == golden);
    }
    // The golden says nothing of a changed scenario; if one of several has changed, nothing of any.
    const auto& [first, unchanged] = *before.begin();
    const std::string& last = before.rbegin()->first;
    const Words oneMeasure = joined(command, {"--measure", "sphericity"});
    writeWhole(last, readWhole(last) + "\n");
    CHECK_THAT(endsWith(3, oneMeasure, {{"CI", ""}}).err, ContainsSubstring("of another scenario"));
    CHECK(readWhole(goldenOf(first)) == unchanged);
  }
}
