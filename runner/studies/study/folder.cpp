// Files and places relative to the study's folder.
#include "base/utf8.h"
#include "study/conditions.h"

namespace morula::study {
namespace {

/// Returns a path relative to the folder; unchanged if there is none, such as for "/a" and "b".
std::string fromFolder(const std::string& path, const std::filesystem::path& folder) {
  const auto shorter = std::filesystem::path(path).lexically_relative(folder.lexically_normal());
  return shorter.empty() ? path : shorter.generic_string();
}

/// Renames the file in a place "file:line:column".
void rename(std::string& place, const std::string& file, const std::string& name) {
  if (place.starts_with(file + ":")) place = name + place.substr(file.size());
}

/// Returns a text that a plan's file can hold: bytes that are not UTF-8 become U+FFFD.
std::string asStored(const std::string& text) {
  for (std::string_view rest = text; !rest.empty();) {
    const int length = utf8Length(rest);
    if (length == 0) return parseJson(jsonText(Json(text))).get<std::string>();
    rest.remove_prefix(std::size_t(length));
  }
  return text;
}

}  // namespace

void countFromFolder(Plan& plan) {
  Study& study = plan.study;
  const auto folder = folderOf(study.file);
  const std::string file = study.file, name = std::filesystem::path(file).filename().string();
  for (StudyAxis& axis : study.axes)
    for (Level& level : axis.levels)
      for (Override& change : level.overrides) rename(change.place, file, name);
  for (Condition& condition : plan.conditions) {
    Scenario& scenario = condition.scenario;
    const std::string own = scenario.file;
    scenario.file = fromFolder(own, folder);
    for (NamedFile& named : scenario.files) {
      named.path = fromFolder(named.path, folder);
      named.content = asStored(named.content);
    }
    for (auto& [path, place] : scenario.places) {
      rename(place, own, scenario.file);
      rename(place, file, name);
    }
    scenario.warnings.clear();  // they were reported with their present names
  }
  study.file = name;
}

}  // namespace morula::study
