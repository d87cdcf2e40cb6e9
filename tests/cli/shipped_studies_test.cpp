// The claims of the shipped studies hold, scenarios/policies/README.md and scenarios/worm/README.md say what the claims
// say, and their figures are what their commands draw. All of this is asked of the values of all runs of a study: the
// test computes some of these runs again, and they must be to the last bit what golden/FAMILY keeps; the others are
// taken from there. With MORULA_WHOLE_STUDIES=1 in the environment all runs are computed again, which takes a quarter
// of an hour of CPU time. With MORULA_DRAW_FIGURES=1 the figures are drawn anew instead of compared.
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

/// The folder of a study below `scenarios/` and `golden/`.
std::string familyOf(const std::string& study) { return study == "worm-placement" ? "worm/" : "policies/"; }

/// Runs that the test makes again, by their number in the plan: of each study a few that take little time.
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

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(' ') + 1 - first);
}

std::string withSingleBlanks(const std::string& line) {
  std::string text;
  for (const std::string& word : wordsOf(line)) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A command in a block of code of a document, and the lines that it prints. "…" stands for lines, and at the end of a
/// line for its rest.
struct Shown {
  Words command;  // without the program's name
  Words lines;
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

/// A number in a text.
struct Number {
  std::size_t begin = 0, end = 0;
  double value = 0;
  int decimals = 0;  // after the point; of 6e-05 five
};

/// The numbers of a text, in their order. A part of a name (settle-0.03, F1) or of a reference (6.2.3) is none.
std::vector<Number> numbersIn(const std::string& text) {
  const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  const auto isName = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == '-');
  };
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t digits = i + (text[i] == '-');
    if (!isDigit(digits)) {
      ++i;
      continue;
    }
    Number number{i, digits, 0, 0};
    while (isDigit(number.end)) ++number.end;
    if (text[number.end] == '.' && isDigit(number.end + 1))
      for (++number.end; isDigit(number.end); ++number.end) ++number.decimals;
    if (text.compare(number.end, 2, "e-") == 0 && isDigit(number.end + 2)) {
      const std::size_t exponent = number.end + 2;
      for (number.end = exponent; isDigit(number.end);) ++number.end;
      number.decimals += std::stoi(text.substr(exponent, number.end - exponent));
    }
    const bool isPart =
        (i > 0 && isName(i - 1)) || isName(number.end) || (text[number.end] == '.' && isDigit(number.end + 1));
    number.value = std::stod(text.substr(i, number.end - i));
    if (!isPart) numbers.push_back(number);
    for (i = number.end; isPart && (isName(i) || (text[i] == '.' && isDigit(i + 1)));) ++i;
  }
  return numbers;
}

/// True if the results' number, rounded as far as the document's, is the same.
bool rounds(const Number& result, const Number& said, double scale = 1) {
  if (scale == 1 && said.decimals > result.decimals) return false;
  const auto rounded = [&](double value) { return std::llround(value * std::pow(10, said.decimals)); };
  return rounded(scale * result.value) == rounded(said.value);
}

Number negative(Number number) {
  number.value = -number.value;
  return number;
}

/// A line of results: what was found of a claim, or a line that a command prints.
struct Evidence {
  explicit Evidence(std::string line, const std::string& claim = "")
      : found(std::move(line)), words(claim + '\n' + found + '\n'), numbers(numbersIn(found)) {}
  std::string found, words;
  std::vector<Number> numbers;  // of `found`

  /// Looks for the number as a mean or a difference of either sign; not as an end of an interval, a p-value or a share of
  /// the variance.
  bool has(const Number& said, double scale = 1) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string before = found.substr(0, numbers[i].begin);
      const auto follows = [&](const char* end) { return before.ends_with(end); };
      const bool isOther = isInterval(i) || isInterval(i + 1) || (scale == 1 && follows("±")) || follows("p = ") ||
                           follows("p < ") || follows("η² ") || follows(" at most ");
      if (!isOther && (rounds(numbers[i], said, scale) || rounds(negative(numbers[i]), said, scale))) return true;
    }
    return false;
  }

  /// "low to high", or the same of the opposite difference.
  bool hasInterval(const Number& low, const Number& high) const {
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const Number &first = numbers[i - 1], &second = numbers[i];
      if (isInterval(i) && ((rounds(first, low) && rounds(second, high)) ||
                            (rounds(negative(second), low) && rounds(negative(first), high))))
        return true;
    }
    return false;
  }

  bool says(const std::string& part) const { return words.find(part) != words.npos; }

 private:
  /// True if the number before this one and this one are "low to high".
  bool isInterval(std::size_t i) const {
    if (i == 0 || i >= numbers.size()) return false;
    const std::size_t end = numbers[i - 1].end;
    return found.substr(end, numbers[i].begin - end) == " to ";
  }
};

/// A paragraph of a document, and the comment below it: <!-- STUDY: PART OF A CLAIM; PART OF A LINE -->.
struct Paragraph {
  std::string text;  // on one line, without code and addresses of links
  std::string study;
  Words chosen;
};

/// Takes what stands between `open` and `close` out of a text.
std::string without(const std::string& text, const std::string& open, const std::string& close) {
  std::string rest;
  std::size_t at = 0;
  for (std::size_t begin; (begin = text.find(open, at)) != text.npos;) {
    rest += text.substr(at, begin - at);
    const std::size_t end = text.find(close, begin + open.size());
    if (end == text.npos) return rest;
    at = end + close.size();
  }
  return rest + text.substr(at);
}

std::vector<Paragraph> paragraphsOf(const std::string& markdown) {
  std::vector<Paragraph> paragraphs;
  std::istringstream lines(without(markdown, "```", "```") + "\n\n");
  std::string whole;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) {
      if (!line.starts_with("|") && !line.starts_with("#")) whole += (whole.empty() ? "" : " ") + trimmed(line);
      continue;
    }
    Paragraph& paragraph = paragraphs.emplace_back();
    const auto comment = whole.find("<!-- ");
    paragraph.text = without(without(whole.substr(0, comment), "`", "`"), "](", ")");
    if (comment != whole.npos) {
      const std::string words = whole.substr(comment + 5, whole.find(" -->", comment) - comment - 5);
      paragraph.study = words.substr(0, words.find(':'));
      for (const std::string& part : morula::partsOf(words.substr(paragraph.study.size() + 1), ';'))
        paragraph.chosen.push_back(trimmed(part));
    }
    whole.clear();
  }
  return paragraphs;
}

/// Radius of the worm's egg [µm], by which scenarios/worm/README.md converts lengths.
constexpr double eggRadius = 17.05;

/// Every number with a decimal point, every percentage, every "9 of 10" and every interval of a paragraph is in the
/// evidence; an interval in brackets in the same line as the number before it.
void checkNumbers(const std::string& text, const std::vector<Evidence>& evidence) {
  const auto numbers = numbersIn(text);
  const auto digits = [&](const Number& a) { return text.substr(a.begin, a.end - a.begin); };
  const auto between = [&](const Number& a, const Number& b) { return text.substr(a.end, b.begin - a.end); };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Number& number = numbers[i];
    const Number* next = i + 1 < numbers.size() ? &numbers[i + 1] : nullptr;
    const std::string before = text.substr(0, number.begin), after = text.substr(number.end, 4);
    const bool isShare = after.starts_with(" %");
    INFO(text.substr(number.begin, 30));
    const auto anyLine = [&](const auto& holds) { return std::ranges::any_of(evidence, holds); };
    if (before.ends_with("within ")) {
      CHECK(anyLine([&](const Evidence& line) {
        const std::string margin = "within " + digits(number) + (isShare ? "%" : "");
        return line.says(margin + ' ') || line.says(margin + '\n');
      }));
    } else if (before.ends_with("p = ")) {
      CHECK(anyLine([&](const Evidence& line) { return line.says("p = " + digits(number) + ' '); }));
    } else if (after.starts_with(" µm")) {
      CHECK(anyLine([&](const Evidence& line) { return line.has(number, eggRadius); }));
    } else if (next && between(number, *next) == " of ") {
      CHECK(anyLine([&](const Evidence& line) {
        return line.says(' ' + digits(number) + " of " + digits(*next) + ' ') ||
               (number.value == next->value && line.says("every one of " + digits(*next) + ' '));
      }));
      ++i;
    } else if (next && between(number, *next) == " to " && (number.decimals > 0 || next->decimals > 0)) {
      const Number* mean = i > 0 && between(numbers[i - 1], number) == " (" ? &numbers[i - 1] : nullptr;
      CHECK(
          anyLine([&](const Evidence& line) { return line.hasInterval(number, *next) && (!mean || line.has(*mean)); }));
      ++i;
    } else if (isShare) {
      CHECK(anyLine([&](const Evidence& line) { return line.says(' ' + digits(number) + " %"); }));
    } else if (number.decimals > 0) {
      CHECK(anyLine([&](const Evidence& line) { return line.has(number); }));
    }
  }
}

/// A run's values as golden/FAMILY/NAME.csv keeps them (tests/studies/values.py).
struct KeptRun {
  std::string task, state, reason;                              // reason: of a run that failed
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

/// The row of the run with this id, in a merged database.
std::vector<std::tuple<double, std::string, double>> valuesIn(Database& db, const std::string& run) {
  std::vector<std::tuple<double, std::string, double>> values;
  Statement rows(db, "SELECT time, measure, value FROM result WHERE run_id = ? ORDER BY time, measure");
  for (rows.start(run); rows.next();) values.emplace_back(rows.real(0), rows.text(1), rows.real(2));
  return values;
}

/// Makes some of a study's runs and merges them; what the golden keeps of these must be what they gave. Then puts what
/// it keeps of all others beside them. Returns the database.
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
  const auto family = GENERATE(std::string("policies"), std::string("worm"));
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
    // The golden says nothing of another scenario; if one of several is another, it says nothing of all.
    const auto& [first, unchanged] = *before.begin();
    const std::string& last = before.rbegin()->first;
    const Words oneMeasure = joined(command, {"--measure", "sphericity"});
    writeWhole(last, readWhole(last) + "\n");
    CHECK_THAT(endsWith(3, oneMeasure, {{"CI", ""}}).err, ContainsSubstring("of another scenario"));
    CHECK(readWhole(goldenOf(first)) == unchanged);
  }
}
