#include "files/content.h"

#include "files/read_file.h"

namespace morula {
namespace {

/// Returns true if a line of the text begins with `beginning`.
bool hasLine(std::string_view text, std::string_view beginning) {
  if (text.starts_with(beginning)) return true;
  for (auto at = text.find(beginning); at != text.npos; at = text.find(beginning, at + 1))
    if (at > 0 && text[at - 1] == '\n') return true;
  return false;
}

}  // namespace

Content contentOf(std::string_view head) {
  if (head.empty()) return Content::empty;
  for (const auto picture : {pngBeginning, svgBeginning, pdfBeginning, webmBeginning, gifBeginning})
    if (head.starts_with(picture)) return Content::picture;
  if (head.size() > 8 && head.substr(4).starts_with(mp4Beginning)) return Content::picture;
  if (head.starts_with(std::string_view("SQLite format 3\0", 16))) return Content::database;
  for (const auto report : {junitBeginning, summaryBeginning, jsonBeginning})
    if (head.starts_with(report)) return Content::report;
  if (head.starts_with(pageBeginning)) return Content::page;
  if (head.starts_with(sceneBeginning)) return Content::scene;
  if (hasLine(head, "morula golden ")) return Content::golden;  // a golden may begin with the marker of a merge
  if (hasLine(head, "morula:") || hasLine(head, "morula-study:") || head.find("\"morula\":") != head.npos)
    return Content::scenario;
  if (hasLine(head, "START:")) return Content::dna;
  return Content::other;
}

Content contentOfFile(const std::filesystem::path& file) { return contentOf(readHead(file, 4096)); }

const char* name(Content content) {
  constexpr const char* names[] = {"empty", "a picture", "a database", "a golden file", "a scenario",
                                   "DNA",   "a report",  "a page",     "a scene",       "a file of another kind"};
  return names[static_cast<int>(content)];
}

}  // namespace morula
