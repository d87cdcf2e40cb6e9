#include "report/words.h"

#include <algorithm>

#include "files/printable.h"
#include "page/html.h"

namespace morula {

std::string shown(std::string_view text) { return htmlText(printable(text)); }

std::string shownBlock(std::string_view text, std::size_t mostBytes) {
  if (text.size() <= mostBytes) return "<pre tabindex=\"0\">" + shown(text) + "</pre>\n";
  return "<pre tabindex=\"0\">" + shown(text.substr(0, mostBytes)) + "</pre>\n<p class=\"note\">The first " +
         std::to_string(mostBytes) + " of " + std::to_string(text.size()) + " bytes.</p>\n";
}

std::string findingsHtml(const std::vector<Finding>& findings) {
  std::string html = "<ul class=\"findings\">\n";
  // The worst first; what is said once need not be said again.
  for (const auto kind : {Finding::Kind::bad, Finding::Kind::warning, Finding::Kind::good})
    for (const Finding& f : findings) {
      if (f.kind != kind) continue;
      const bool bad = kind == Finding::Kind::bad, warning = kind == Finding::Kind::warning;
      const std::string name = bad ? "bad" : warning ? "warn" : "good";
      html += "<li class=\"" + name + "\"><span class=\"mark " + name + "\">" +
              (bad       ? "✗ Fault"
               : warning ? "! Warning"
                         : "✓") +
              "</span>" + f.html + "</li>\n";
    }
  return html + "</ul>\n";
}

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string titleOf(const RunFacts& run, const std::vector<RunFacts>& all) {
  const auto called = [](const RunFacts& r) {
    return (r.label.empty() ? r.run.record.scenario : r.label) + ", seed " +
           std::to_string(r.run.record.seed);
  };
  const auto same =
      std::count_if(all.begin(), all.end(), [&](const RunFacts& r) { return called(r) == called(run); });
  return called(run) + (same > 1 ? " (" + run.run.id + ")" : "");
}

std::string shellWord(const std::string& word) {
  static constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options) {
  return "./morula " + verb + " " + shellWord(run.database) + " --run " + run.run.id +
         (options.empty() ? "" : " " + options);
}

}  // namespace morula
