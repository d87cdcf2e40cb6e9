#pragma once
// A study file, read as strictly as a scenario: scenarios × policies × seeds, and what is measured.
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "golden/result_state.h"
#include "scenario/scenario.h"
#include "yaml/problems.h"

namespace morula {

/// One value of an axis: a label, and overrides of the scenario. Each override's place is the place of its value in the
/// study file, "file:line:column".
struct Level {
  std::string label;
  std::vector<Override> overrides;  // none: the scenario as it is
};

struct StudyAxis {
  std::string name;
  std::vector<Level> levels;  // one or more, in the order of the file
};

/// Combinations of levels that are not run: those with one of these levels in each axis that names some.
struct LeftOut {
  std::vector<std::vector<std::size_t>> levels;  // [axis]; empty: any level
  scenario::Place place;
};

/// A scenario that the study varies.
struct Base {
  std::string label;      // in the axis `base`, if there are several: given, or the file's name without ".yaml"
  std::string file;       // relative to the study's folder
  scenario::Place place;  // place of the base in the study file
};

enum class HashesKept { none, end, all };
template <>
inline constexpr auto choices<HashesKept> =
    std::to_array<Choice<HashesKept>>({{HashesKept::none, "none", "no hash of a state"},
                                       {HashesKept::end, "end", "the hash of the last state"},
                                       {HashesKept::all, "all", "hashes on the way, too"}});

enum class SamplesKept { end, all };
template <>
inline constexpr auto choices<SamplesKept> =
    std::to_array<Choice<SamplesKept>>({{SamplesKept::end, "end", "the cells at the end"},
                                        {SamplesKept::all, "all", "the cells whenever measures are taken"}});

enum class PicturesKept { none, firstSeed, all };
template <>
inline constexpr auto choices<PicturesKept> = std::to_array<Choice<PicturesKept>>(
    {{PicturesKept::none, "none", "no picture"},
     {PicturesKept::firstSeed, "first-seed", "one picture of each condition, with its first seed"},
     {PicturesKept::all, "all", "one picture of each run"}});

/// The times at which measures are taken, besides the end.
enum class Moments { end, eachDivision, every };
template <>
inline constexpr auto choices<Moments> = std::to_array<Choice<Moments>>(
    {{Moments::end, "end", "at the end alone"},
     {Moments::eachDivision, "each-division", "at the start and after each step in which cells divided"},
     {Moments::every, "every", "at the start and at regular times"}});
struct When {
  Moments moments = Moments::end;
  double every = 0;  // [time] with Moments::every
  friend bool operator==(const When&, const When&) = default;
};

struct Kept {
  HashesKept hashes = HashesKept::end;
  SamplesKept samples = SamplesKept::end;
  PicturesKept pictures = PicturesKept::none;
  friend bool operator==(const Kept&, const Kept&) = default;
};

/// The limits of one run; absent: no limit.
struct RunLimits {
  std::optional<double> cpu;            // [s]
  std::optional<std::uint64_t> memory;  // [byte]
  friend bool operator==(const RunLimits&, const RunLimits&) = default;
};

/// The statement of a claim on a pair, about its first side compared with the second.
enum class Says { lower, higher, equivalent, noEffect, mean };
template <>
inline constexpr auto choices<Says> =
    std::to_array<Choice<Says>>({{Says::lower, "lower", "a difference is shown, and a is lower"},
                                 {Says::higher, "higher", "a difference is shown, and a is higher"},
                                 {Says::equivalent, "equivalent", "both agree within a margin"},
                                 {Says::noEffect, "no-effect", "no difference is shown"}});

/// A claim on the results that must stay true.
struct Claim {
  std::string measure;                                // as AskedMeasure::name
  Says says = Says::lower;                            // mean: a statement on a condition, not on a pair
  std::vector<std::optional<std::size_t>> a, b = {};  // [axis] level; absent: mean over all. Of a condition: a alone
  double mean = 0;                                    // [unit of the measure] the claimed mean of a condition
  std::string within = {};                            // the margin, "0.01" or "5%"; "" if none is needed
  scenario::Place place = {}, marginPlace = {};
};

struct Study {
  std::string file;   // path as given by the user
  std::string bytes;  // content of the file
  std::string name, summary;
  std::vector<Base> bases;
  std::vector<StudyAxis>
      axes;  // in the file's order; several bases are the first axis, `base`, whose levels override nothing
  std::vector<std::uint64_t> seeds;   // one or more, each once, in the order of the file
  std::vector<std::string> measures;  // as AskedMeasure::name [observation/asked_measure.h], each once
  When when;
  Kept keep;
  RunLimits limits;
  AllowedRuns allowed;                         // decides nothing that is run
  std::vector<scenario::Place> measurePlaces;  // the places of the measures in the file
  bool allowOutside = false;                   // scenarios and their files may lie anywhere
  std::vector<LeftOut> leftOut = {};           // from the file's text
  std::vector<Claim> claims = {};              // decide nothing that is run; only from a study file, not from a plan
};

/// Reads and checks a study file. Throws InputError with one line per mistake, all of them at once, sorted by line:
/// `file:line:column: path: what is wrong; what would be right`. If the file itself has mistakes, its scenarios are
/// checked, too, as far as the file could be read; if not, makePlan checks them. Throws FileError if it cannot be read.
/// The scenarios of the study must lie in its folder, or below its folder `scenarios`, unless `allowOutside`.
Study loadStudy(const std::filesystem::path& file, bool allowOutside = false);
/// Reads a study from a text in memory, as if it lay in `file`.
Study readStudy(std::string bytes, const std::filesystem::path& file, bool allowOutside = false);

/// Returns how many failed and insane runs the text of a study file allows; none if it cannot be read.
AllowedRuns allowedIn(const std::string& bytes);

/// Fills `leftOut` from the text of the study, whose axes are known.
void addLeftOut(Study& study);

/// Returns true if the file is a study rather than a scenario: its first key, beside comments, is `morula-study`, or
/// its name ends in .study.yaml.
bool isStudy(const std::filesystem::path& file);

}  // namespace morula
