#include "report_data/words.h"

#include <map>

#include "base/number_text.h"
#include "files/printable.h"
#include "page/html.h"

namespace morula {

std::string shown(std::string_view text) { return htmlText(printable(text)); }

std::string shownValue(const std::string& text) {
  return text.find(' ') == text.npos && text.size() > 24 ? "<span class=\"long\">" + shown(text) + "</span>"
                                                         : shown(text);
}

std::string shownBlock(std::string_view text, std::size_t mostBytes) {
  if (text.size() <= mostBytes) return "<pre tabindex=\"0\">" + shown(text) + "</pre>\n";
  return "<pre tabindex=\"0\">" + shown(text.substr(0, mostBytes)) + "</pre>\n<p class=\"note\">The first " +
         std::to_string(mostBytes) + " of " + std::to_string(text.size()) + " bytes.</p>\n";
}

std::string findingsHtml(const std::vector<Finding>& findings) {
  std::string html = "<ul class=\"findings\">\n";
  struct Look {
    Finding::Kind kind;
    const char *name, *mark;
  };
  static constexpr Look looks[] = {{Finding::Kind::bad, "bad", "✗ Fault"},
                                   {Finding::Kind::warning, "warn", "! Warning"},
                                   {Finding::Kind::note, "plain", "–"},
                                   {Finding::Kind::good, "good", "✓"}};
  // The worst first.
  for (const Look& look : looks)
    for (const Finding& f : findings)
      if (f.kind == look.kind)
        html += std::string("<li class=\"") + look.name + "\"><span class=\"mark " + look.name + "\">" +
                look.mark + "</span>" + f.html + "</li>\n";
  return html + "</ul>\n";
}

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& texts, std::size_t most) {
  const bool all = texts.size() <= most;
  const std::size_t count = all ? texts.size() : most;
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? "" : all && i + 1 == count ? " and " : ", ") + texts[i];
  return all ? text : text + " and " + std::to_string(texts.size() - most) + " more";
}

std::string inBytes(std::size_t bytes) {
  if (bytes < 1000) return counted(bytes, "byte");
  const auto size = static_cast<double>(bytes);
  return size < 1e6 ? numberText(size / 1e3, 3) + " kB" : numberText(size / 1e6, 3) + " MB";
}

std::string failureHtml(const std::string& failure) {
  const auto end = failure.find("; ");
  if (end == failure.npos) return shown(failure);
  std::string html = shown(failure.substr(0, end)) + "<ul class=\"why\">";
  for (std::size_t from = end + 2, to = 0; to != failure.npos; from = to + 2) {
    to = failure.find("; ", from);
    html += "<li>" + shown(failure.substr(from, to == failure.npos ? to : to - from)) + "</li>";
  }
  return html + "</ul>";
}

std::string failedInWords(const CheckResult& failed) {
  if (failed.check == "run") return "the run failed";
  if (failed.kind == "sanity") return "its end is not sane";
  if (failed.kind == "invariant") return "what must always hold does not";
  if (failed.kind == "bullet") return "Bullet comes to something else";
  static const std::map<std::string, std::string> words{
      {"INPUT_CHANGED", "the scenario or its golden changed"},
      {"SETUP", "it starts otherwise"},
      {"LINEAGE", "the lineage differs"},
      {"COMPUTATION", "computed values differ"},
      {"CHAOS", "a last place has grown"},
      {"IMAGE", "the picture differs"},
      {"COST", "the cost differs"},
      {"NONDETERMINISM", "it gives different bits each time"}};
  const auto found = words.find(failed.failureClass);
  return found == words.end() ? failed.failureClass : found->second;
}

const std::string& titleOf(const RunFacts& run) { return run.title; }

std::string sourceOf(const RunFacts& run) {
  for (const Document& d : run.documents)
    if (d.role == "scenario") return d.path;
  return run.run.record.scenario + ".yaml";
}

std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options) {
  return "./morula " + verb + " " + shellWord(run.database) + " --run " + run.run.id +
         (options.empty() ? "" : " " + options);
}

}  // namespace morula
