// A golden holds every column of every table that a run records.
#include "store/recorded_tables.h"

#include <functional>
#include <map>
#include <set>

#include "catch.h"
#include "example_run.h"
#include "golden/golden.h"
#include "store/result_rows.h"
#include "store/row_texts.h"
#include "store/run_tables.h"

using namespace morula;

namespace {

/// Returns two of each record, without NULL in a column that may have a value.
RunResults fullResults() {
  RunResults r = exampleResults();
  for (Sample& s : r.samples) {
    for (auto& value : s.world.values) value = value.value_or(0.5);
    for (CellMeasures& c : s.cells)
      for (auto& value : c.values) value = value.value_or(0.25);
    for (ContactMeasures& c : s.contacts)
      for (auto& value : c.values) value = value.value_or(0.75);
    s.more = {{Scope::world, "energy", {}, {}, 3}, {Scope::cell, "extent_1", CellPath::parse("A"), {}, 1.5}};
    s.surfaces = {{CellPath::parse("A"), 0, {1, 2, 3}, {0.5, 0.25, 0.125}, {{{1, 2, 3}}, {{4, 5, 6}}, {{7, 8, 9}}}}};
  }
  r.meshes = {{0, 3, {{{0, 1, 2}}}}};
  r.settlings = {{0.5, 12, 4, 900, 1e-6, 1e-9, 1e-5}};
  r.experiments = {{1, 0.5, 12, DoneTo::pair, CellPath::parse("A"), CellPath::parse("B")}};
  return r;
}

std::vector<GoldenItem> itemsOf(const RunResults& results) {
  RecordedTables tables;
  tables.addAll(results, 700);
  return tables.items();
}

GoldenData dataOf(const RunResults& results) {
  GoldenData data{"test/example", "0123456789abcdef0123456789abcdef", 7, {GoldenBits{"solver", {1, 2}}}};
  for (GoldenItem& item : itemsOf(results)) data.items.push_back(std::move(item));
  return data;
}

Golden goldenOf(const RunResults& results, std::vector<ToleranceRule> rules = {}) {
  const Golden golden{dataOf(results), "A. Tester", "first", std::move(rules), "x.golden"};
  return readGolden(writeGolden(golden), golden.file);
}

/// Changes the column of a record with this number, if its type can be changed.
struct ChangeColumn {
  int column;  // counted down
  bool changed = false;
  template <class T>
  void change(T& value) {
    using Member = std::remove_cvref_t<T>;
    if constexpr (IsMeasures<Member>) {
      value.each([&](const auto&, std::size_t i) {
        if (column-- == 0) value.of.values[i] = value.of.values[i].value_or(0) + 1, changed = true;
      });
    } else if constexpr (requires { value.isAbsent; }) {
      if (value.isAbsent) --column;
      else change(value.of);
    } else if constexpr (IsOptional<Member>) {
      if (value) change(*value);
      else if (column-- == 0) value.emplace(), changed = true;
    } else if constexpr (std::same_as<Member, Vector>) {
      for (double* x : {&value.x, &value.y, &value.z})
        if (column-- == 0) *x += 1, changed = true;
    } else if (column-- == 0) {
      changed = true;
      if constexpr (HasChoices<Member>)
        value = value == choices<Member>[0].value ? choices<Member>[1].value : choices<Member>[0].value;
      else if constexpr (IsTemplate<Member, AnyReal> || IsTemplate<Member, AllBits>) value.of += 1;
      else if constexpr (IsTemplate<Member, TextOf>) value.read(std::string("gene"));
      else if constexpr (IsTemplate<Member, BytesOf>) value.read(std::string("abcdef"));
      else if constexpr (std::same_as<Member, Hash>) ++value.low;
      else if constexpr (std::same_as<Member, CellPath>) value = value.daughter(true);
      else if constexpr (std::same_as<Member, std::string>) value += "x";
      else if constexpr (std::same_as<Member, bool>) value = !value;
      else if constexpr (std::is_arithmetic_v<Member>) value += 1;
    }
  }
};

}  // namespace

TEST_CASE("what goldens hold are all tables that a run stores") {
  const RunResults results = fullResults();
  std::map<std::string, std::int64_t> rows;
  const auto count = [&](std::uint64_t, const auto& row, const auto&...) {
    ++rows[sqlTable<std::remove_cvref_t<decltype(row)>>().info.name];
  };
  visitRecords(results, count);
  visitEnd(results, 700, count);
  BegunRun run;
  run.finish(results);
  for (const SqlTable* t : runTables()) {
    if (!isResult(t->info.part) || t->info.part == TablePart::checks) continue;
    INFO(t->info.name);
    CHECK(rows[t->info.name] > 0);
    CHECK(rows[t->info.name] == run.count(t->info.name));
  }
}

TEST_CASE("one changed value of any column of any table fails the check, and the column is named") {
  const RunResults results = fullResults();
  const Golden golden = goldenOf(results);
  REQUIRE(compareGolden(golden, dataOf(results)).passed());
  std::set<std::string> held;
  for (const auto* column : all<GoldenColumn>(golden.data)) held.insert(column->name);
  // Changes go through the lists of fields, as rows go into tables, so a new column is tried, too.
  std::set<std::string> tried;
  const auto tryRow = [&](std::uint64_t step, const auto& original, const auto&... context) {
    using Row = std::remove_cvref_t<decltype(original)>;
    const SqlTable& table = sqlTable<Row>();
    if (std::string_view(table.info.name) == "step_hash" || std::string_view(table.info.name) == "cell_hash") return;
    for (std::size_t i = 0; i < table.own.size(); ++i) {
      Row row = original;
      ChangeColumn change{static_cast<int>(i)};
      listFields(row, [&](const FieldInfo&, auto&& member) { change.change(member); });
      const RowTexts before = textsOf(original, context...), after = textsOf(row, context...);
      if (!change.changed || before == after) continue;  // a mother's path follows from her daughter's
      const std::string name = std::string(table.info.name) + '/' + table.own[i].name;
      INFO(name);
      RecordedTables was, is;
      was.addRow(table, step, before), is.addRow(table, step, after);
      GoldenData first{"s", "0", 0, was.items()}, second{"s", "0", 0, is.items()};
      const CheckReport report = compareGolden({first, "A", "B", {}, "x.golden"}, second);
      REQUIRE_FALSE(report.passed());
      CHECK(describe(report).find(table.own[i].name) != std::string::npos);
      tried.insert(name);
    }
  };
  visitRecords(results, tryRow);
  visitEnd(results, 700, tryRow);
  for (const std::string& name : held) {
    const auto isContext = name.ends_with("/time") || name.ends_with("/number") || name == "faces/mesh";
    if (!isContext && name != "cell/parent") CHECK(tried.contains(name));
  }
  RunResults others = results;
  others.meshes[0].faces[0][0] = 2;
  CHECK_FALSE(compareGolden(golden, dataOf(others)).passed());
  others = results;
  others.samples[1].more.pop_back();
  CHECK_FALSE(compareGolden(golden, dataOf(others)).passed());
}

TEST_CASE("rows may come in parts and in any order, and as a database gives them back") {
  const RunResults results = fullResults();
  RunResults turned = results;
  std::ranges::reverse(turned.samples), std::ranges::reverse(turned.lineage), std::ranges::reverse(turned.divisions);
  CHECK(compareGolden(goldenOf(results), dataOf(turned)).passed());

  RecordedTables parts;
  RunResults first = results, rest = results;
  first.samples.pop_back(), rest.samples.erase(rest.samples.begin());
  parts.addRecords(first);
  parts.addAll(rest, 700);
  GoldenData data = dataOf(results);
  std::erase_if(data.items, [](const GoldenItem& i) { return checkOf(i) == "tables"; });
  for (GoldenItem& item : parts.items()) data.items.push_back(std::move(item));
  CHECK(compareGolden(goldenOf(results), data).passed());

  BegunRun run;
  run.finish(results);
  CHECK(compareGolden(goldenOf(results), dataOf(run.store.results(run.id))).passed());
}

TEST_CASE("what was not measured is not 0") {
  RunResults results = fullResults();
  results.samples[1].contacts[0]["area"] = 0;
  const Golden golden = goldenOf(results);
  results.samples[1].contacts[0]["area"] = {};
  const CheckReport report = compareGolden(golden, dataOf(results));
  CHECK_FALSE(report.passed());
  CHECK(describe(report).find("area: expected '0', actual '-' (- is not measured)") != std::string::npos);
}

TEST_CASE("a number in a row is told, held against the tolerance for it, and its table is held exactly") {
  const RunResults results = fullResults();
  RunResults others = results;
  others.samples[1].contacts[0]["area"] = 0.7 * (1 + 1e-12);
  const auto failed = [&](const Golden& golden) {
    std::set<std::string> checks;
    for (const CheckResult& r : compareGolden(golden, dataOf(others)).results)
      if (!r.passed) checks.insert(r.check);
    return checks;
  };
  CHECK(failed(goldenOf(results)) == std::set<std::string>{"values", "tables"});
  const auto loose = goldenOf(results, {readRule("tolerance contact/* rel 1e-9 why \"weighed\"", "rule")});
  CHECK(failed(loose) == std::set<std::string>{"tables"});
  others.samples[1].contacts[0]["area"] = 0.8;
  CHECK(failed(loose) == std::set<std::string>{"values contact/*", "tables"});
  const CheckReport report = compareGolden(loose, dataOf(others));
  for (const CheckResult& r : report.results)
    if (!r.passed) CHECK(r.failureClass == FailureClass::record);
  CHECK(describe(report).find("/A/B/area at step 700: expected 0.7, actual 0.8") != std::string::npos);
}

TEST_CASE("a table of many rows is held without them") {
  RunResults results = fullResults();
  for (int i = 0; i < 100; ++i)
    results.connections.push_back({CellPath::parse("A"), CellPath::parse("B"), 1.0 * i, -1, ReleaseCause::none});
  const Golden golden = goldenOf(results);
  for (const auto* row : all<GoldenRow>(golden.data)) CHECK_FALSE(row->name.starts_with("connection/"));
  REQUIRE(compareGolden(golden, dataOf(results)).passed());
  results.connections[50].made += 1;
  CHECK_FALSE(compareGolden(golden, dataOf(results)).passed());
  results.connections.resize(3);  // with few rows, columns and not rows report the difference
  const std::string told = describe(compareGolden(golden, dataOf(results)));
  CHECK(told.find("column connection/made: rows: expected '102', actual '3'") != std::string::npos);
  CHECK(told.find("connection/0") == std::string::npos);
}

TEST_CASE("a golden of format 1 says what it does not hold, one of format 2 without tables fails") {
  const RunResults results = fullResults();
  Golden golden = goldenOf(results);
  std::erase_if(golden.data.items, [](const GoldenItem& i) { return checkOf(i) == "tables"; });
  CheckReport report = compareGolden(golden, dataOf(results));
  REQUIRE_FALSE(report.passed());
  CHECK(report.results.back().failureClass == FailureClass::inputChanged);
  golden.version = 1;
  golden = readGolden(writeGolden(golden), golden.file);
  CHECK(golden.version == 1);
  report = compareGolden(golden, dataOf(results));
  CHECK(report.passed());
  CHECK(describe(report).find("--    tables: not compared: recorded tables") != std::string::npos);
  std::string text = writeGolden(goldenOf(results));
  text.replace(0, text.find('\n'), "morula golden 1");  // the golden's seal covers its format
  CHECK_THROWS_AS(readGolden(text, "x.golden"), InputError);
}

TEST_CASE("a column that joins a table later is compared after the next acceptance") {
  const RunResults results = fullResults();
  Golden golden = goldenOf(results);
  std::erase_if(golden.data.items, [](const GoldenItem& i) {
    const auto* column = std::get_if<GoldenColumn>(&i);
    return column && column->name == "contact/area";
  });
  for (GoldenItem& item : golden.data.items)
    if (auto* row = std::get_if<GoldenRow>(&item); row && row->name.starts_with("contact/"))
      row->values.text = row->values.text.substr(row->values.text.find(' ') + 1);
  CHECK(compareGolden(golden, dataOf(results)).passed());
}
