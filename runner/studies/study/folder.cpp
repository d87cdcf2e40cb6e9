// Files and places as they are called from the study's folder.
#include "base/utf8.h"
#include "study/conditions.h"

namespace morula::study {
namespace {

/// Returns a path as seen from the folder; unchanged if that cannot be said, as of "/a" from "b".
std::string fromFolder(const std::string& path, const std::filesystem::path& folder) {
  const auto shorter = std::filesystem::path(path).lexically_relative(folder.lexically_normal());
  return shorter.empty() ? path : shorter.generic_string();
}

/// A place "file:line:column" of this file, with its new name.
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
    scenario.warnings.clear();  // they were told as the files are called here
  }
  study.file = name;
}

}  // namespace morula::study
