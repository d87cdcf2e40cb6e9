#include "report/sources.h"

#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "loop/stored_scenario.h"
#include "report/study_part.h"
#include "system/json.h"
#include "system/usage_error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

/// By what a file holds, not by its name. Whether it is one.
bool addSource(const std::string& file, Sources& sources) {
  const std::string head = readBeginning(file, 16);
  if (contentOf(head) == Content::database)
    return (isMergedStudy(file) ? sources.studies : sources.databases).push_back(file), true;
  if (!head.starts_with('{')) return false;
  const Json json = tryParseJson(readFile(file));
  if (!json.is_object() || !json.contains("morula")) return false;
  if (json.contains("rows") && json.contains("scenario")) return sources.accuracies.push_back(file), true;
  if (json.contains("results")) return sources.checks.push_back(file), true;
  return false;
}

}  // namespace

Sources sourcesOf(const std::vector<std::string>& what) {
  Sources sources;
  for (const std::string& name : what) {
    if (!fileExists(name)) throw FileError("'" + name + "': no such file or folder");
    if (!isFolder(name)) {
      if (!addSource(name, sources))
        throw UsageError("'" + name + "' is " + std::string(morula::name(contentOfFile(name))) +
                         "; report needs a database that morula run has written, a report.json of morula check "
                         "--reports, what morula accuracy --json has printed, or a folder of these");
      continue;
    }
    bool any = false;
    for (const char* ending : {".db", ".json"})
      for (const fs::path& file : filesBelow(name, ending)) any = addSource(file.generic_string(), sources) || any;
    // A merged study holds the runs of all of its tasks.
    for (const std::string& study : sources.studies)
      std::erase_if(sources.databases, [tasks = (fs::path(study).parent_path() / "tasks/").generic_string()](
                                           const std::string& file) { return file.starts_with(tasks); });
    if (!any) throw UsageError("'" + name + "': no database and no report in this folder; morula run writes one");
  }
  return sources;
}

}  // namespace morula
