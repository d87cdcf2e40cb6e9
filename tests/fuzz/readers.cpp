#include "fuzz/readers.h"

#include <algorithm>
#include <filesystem>

#include "accuracy/accuracy.h"
#include "analysis/margins.h"
#include "analysis/study_results.h"
#include "base/error.h"
#include "base/hash.h"
#include "biology/dna.h"
#include "drawing/drawing.h"
#include "drawing/png_file.h"
#include "explain/run_source.h"
#include "golden/golden.h"
#include "mesh/convex_shell.h"
#include "mesh/mesh.h"
#include "report/page_parts.h"
#include "scenario/scenario.h"
#include "simulation/restore.h"
#include "biology/cell_selection.h"
#include "study/plan.h"
#include "study/study_file.h"
#include "study_store/task_file.h"
#include "system/json.h"
#include "system/usage_error.h"
#include "tasks/run_study.h"
#include "temporary_folder.h"
#include "unit/analysis/study_db.h"
#include "unit/scenario/every_part.h"

namespace morula::fuzz {

namespace {

namespace fs = std::filesystem;

/// Returns the small files with this ending below folders of the repository, sorted by name.
std::vector<std::string> filesIn(std::initializer_list<const char*> folders, std::string_view ending) {
  constexpr std::uintmax_t most = 20'000;  // [byte] larger files are only slower
  std::vector<fs::path> files;
  for (const char* folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MORULA_SOURCE_DIR) / folder))
      if (entry.path().string().ends_with(ending) && entry.file_size() < most) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(readText(file));
  return texts;
}

std::string text(std::string_view bytes) { return std::string(bytes); }

const Scene& smallScene() {
  static const Scene scene = readScenario(readText(fs::path(MORULA_SOURCE_DIR) / "tests/studies/small.yaml"),
                                          "small.yaml", "", {parseOverride("physics.mesh.icosphere=0")})
                                 .scene;
  return scene;
}

/// Reads a scenario that names these bytes as a file.
void readNamed(const char* role, const std::string& path, std::string_view bytes) {
  readScenario("morula: 1\nname: fuzz\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {cycles: 3}\n" + path, "fuzz.yaml",
               "", {}, {{role, "fuzz.txt", text(bytes)}});
}

/// A checkpoint's fields begin after its head, and a hash follows them [core/state/checkpoint.cpp]. Mutated fields
/// are sealed with their hash, which else would refuse nearly all of them.
constexpr std::size_t checkpointHead = 24, checkpointTail = 16;

std::string sealed(std::string_view fields) {
  const auto append = [](std::string& to, std::uint64_t value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  std::string bytes = "MORULACP";
  append(bytes, checkpointVersion);
  append(bytes, fields.size());
  bytes += fields;
  Hasher h;
  h.field("checkpoint").add(checkpointVersion).add(fields);
  append(bytes, h.digest().high), append(bytes, h.digest().low);
  return bytes;
}

std::vector<std::string> checkpoints() {
  std::vector<std::string> fields;
  World world = makeWorld(smallScene());
  for (int i = 0; i < 3; ++i) {
    const std::string bytes = saveState(world);
    fields.push_back(bytes.substr(checkpointHead, bytes.size() - checkpointHead - checkpointTail));
    for (int k = 0; k < 40 && !finished(world); ++k) step(world);
  }
  return fields;
}

std::vector<std::string> plans() {
  Study study = loadStudy(fs::path(MORULA_SOURCE_DIR) / "tests/studies/small.study.yaml");
  return {writePlan(makePlan(study, {.predict = false}))};
}

std::vector<std::string> taskFiles() {
  TaskOutcome outcome;
  outcome.task.id = "0123456789abcdef";
  outcome.record.scenario = "fuzz";
  outcome.end = {.status = RunStatus::failed, .failure = "numerical failure: too fast"};
  outcome.task.reason = outcome.end.failure;
  outcome.timing.started = outcome.timing.ended = "2008-06-17 12:00:00";
  return {emptyTaskFile(), taskFileBytes(std::move(outcome))};
}

std::vector<std::string> mergedStudies() {
  const TemporaryFolder folder;
  MadeStudy study;
  study.axes = {{"division", {"longest", "random"}}};
  study.seeds = 2;
  study.values = [](const std::vector<int>& levels, int seed) {
    return std::map<std::string, double>{{"clone_radius", levels[0] + 0.5 * seed}};
  };
  writeStudy(study, folder / "study.db");
  return {readText(folder / "study.db")};
}

std::vector<std::string> pictures() {
  Image image(17, 9, paper);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = {std::uint8_t(i * 37), 1, std::uint8_t(i)};
  std::vector<std::string> files{pngFile(image)};
  image.opacity.assign(image.pixels.size(), 100);
  files.push_back(pngFile(image));
  return files;
}

/// Returns an empty object: the corpus has better seeds.
std::vector<std::string> justEmpty() { return {"{}"}; }

/// Writes the bytes into a file and returns its name.
std::string fileOf(std::string_view bytes) {
  static const TemporaryFolder folder;
  const fs::path file = folder / "bytes";
  writeText(file, text(bytes));
  return file;
}

/// Reads a scenario; every refusal must begin with a place in the file.
void readAsScenario(std::string_view bytes) {
  try {
    readScenario(text(bytes), "fuzz.yaml", "");
  } catch (const InputError& refused) {
    if (std::string_view(refused.what()).starts_with("fuzz.yaml:")) throw;
    throw std::logic_error(std::string("refused without a place: ") + refused.what());
  }
}

const Reader all[] = {
    {"scenario", readAsScenario,
     [] {
       auto files = filesIn({"scenarios", "tests/bad_scenarios"}, ".yaml");
       files.resize(5 * files.size(), test::everyPart);  // four of five inputs are made of this scenario
       return files;
     },
     5},
    {"override",
     [](std::string_view b) {
       readScenario(readText(fs::path(MORULA_SOURCE_DIR) / "tests/studies/small.yaml"), "small.yaml", "",
                    {parseOverride(text(b))});
     },
     [] {
       return std::vector<std::string>{"physics.drag=2", "stop={cycles: 2}", "division.plane={axis: [1, 0, 0]}"};
     }},
    {"study", [](std::string_view b) { readStudy(text(b), "fuzz.study.yaml"); },
     [] {
       return filesIn({"scenarios", "tests/bad_studies", "tests/studies"}, ".study.yaml");
     }},
    {"dna", [](std::string_view b) { parseDna(b, "fuzz.dna"); },
     [] {
       return filesIn({"scenarios", "tests/bad_dna"}, ".dna");
     }},
    {"obj", [](std::string_view b) { readObj(text(b), "fuzz.obj"); }, [] { return filesIn({"scenarios"}, ".obj"); }},
    {"shell", [](std::string_view b) { readConvexShell(text(b), "fuzz.obj"); },
     [] { return filesIn({"scenarios"}, ".obj"); }},
    {"golden", [](std::string_view b) { readGolden(text(b), "fuzz.golden"); },
     [] { return filesIn({"golden"}, ".golden"); }},
    {"checkpoint",
     [](std::string_view b) {
       static World world = makeWorld(smallScene());
       restoreState(world, sealed(b));
       if (!finished(world)) step(world);
     },
     checkpoints},
    {"plan", [](std::string_view b) { readPlan(text(b), "plan.json"); }, plans},
    {"accuracy",
     [](std::string_view b) {
       accuracyFrom(parseJson(b));
       accuracyPart(fileOf(b));  // makes the page of the result
     },
     justEmpty},
    {"check", [](std::string_view b) { checkPart(readChecked(fileOf(b)), "report.json"); }, justEmpty},
    {"trail", [](std::string_view b) { readHashTrace(text(b)); }, justEmpty},
    {"names", [](std::string_view b) { readNamed("names", "names: {file: x}\n", b); }, justEmpty},
    {"reference", [](std::string_view b) { readNamed("reference", "check: {reference: {file: x}}\n", b); }, justEmpty},
    {"png", [](std::string_view b) { readPng(text(b), "fuzz.png"); }, pictures},
    {"words",
     [](std::string_view b) {
       const std::string word = text(b);
       const auto refused = [](auto&& read) {
         try {
           read();
         } catch (const InputError&) {
         } catch (const UsageError&) {}
       };
       refused([&] { parseSelection(word); });
       refused([&] { parseShard(word); });
       refused([&] { parseMargins({word}, {"sphericity"}); });
       refused([&] { CellPath::parse(word); });
     },
     [] {
       return std::vector<std::string>{"AAA*", "generation 3", "3/40", "sphericity=5%", "skin"};
     }},
    {"task", [](std::string_view b) { TaskFile(fileOf(b)).whatIsWrong(); }, taskFiles},
    {"merged", [](std::string_view b) { readStudyResults(fileOf(b)); }, mergedStudies},
};

}  // namespace

std::span<const Reader> readers() { return all; }

const Reader* readerNamed(std::string_view name) {
  const auto found = std::ranges::find(all, name, [](const Reader& r) { return std::string_view(r.name); });
  return found == std::end(all) ? nullptr : found;
}

bool takes(const Reader& reader, std::string_view bytes) {
  try {
    reader.read(bytes);
    return true;
  } catch (const InputError&) {
  } catch (const UsageError&) {
  } catch (const FileError&) {  // StoreError among them
  } catch (const NumericalError&) {
  } catch (const Json::exception&) {}
  return false;
}

}  // namespace morula::fuzz
