// Finds DNA that is well written and could work, but has no effect. A misspelling must not become an organism that
// silently does less than it should. DNA that may be meant as it stands is a warning.
#include <algorithm>
#include <map>

#include "base/did_you_mean.h"
#include "biology/dna_text.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"

namespace morula::dna_text {
namespace {

bool isActing(const std::string& name) { return std::ranges::find(substance::acting, name) != substance::acting.end(); }

std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns the acting substance that a name which nothing reads probably means, or "". With two edits a short word
/// could be any other word.
std::string misspelt(const std::string& name) {
  if (name.size() > 10) return "";  // longer than any acting substance by more than two letters
  for (const std::string& word : substance::acting)
    if (editDistance(lowerCase(name), word) <= (word.size() >= 6 ? 2 : 1)) return word;
  return "";
}

class EffectCheck {
 public:
  EffectCheck(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics, Diagnostics& warnings)
      : lines_(lines), surroundings_(surroundings), diagnostics_(diagnostics), warnings_(warnings) {
    // A line that could not be read may have said anything.
    read_ = lines.unreadableWords;
    for (const GeneLine& gene : lines.genes)
      for (const auto* words : {&gene.inputs, &gene.repressors})
        for (const Word& input : *words) read_.insert(input.text);
  }

  void check() {
    for (const Word& word : lines_.start) checkSpelling(word);
    for (const GeneLine& gene : lines_.genes) checkSpelling(gene.product);
    if (!surroundings_) return;
    // A line that could not be read may have been a gene that reads anything.
    if (!lines_.unreadableWords.empty()) return;
    std::set<std::string> seen;  // repetitions have been reported
    for (const Word& word : lines_.start)
      if (seen.insert(word.text).second) checkStart(word);
    if (lines_.hasStartLine) checkReach();
  }

 private:
  bool isReadOutside(const std::string& name) const {
    return surroundings_ &&
           std::ranges::any_of(surroundings_->read, [&](const std::string& pattern) { return fits(pattern, name); });
  }

  /// Checks a START substance or a product: does it act in this scene, and if not, was it meant to?
  void checkSpelling(const Word& word) {
    const std::string& name = word.text;
    if (name == substance::a || name == substance::b) return;
    if (read_.contains(name) && !isCase(name)) return;
    if (isActing(name)) {
      if (!surroundings_) return;
      if (const auto found = surroundings_->inert.find(name); found != surroundings_->inert.end())
        diagnostics_.add(word.place, quoted(name) + " has no effect here: " + found->second);
      return;
    }
    if (isReadOutside(name) && !isCase(name)) return;
    const std::string meant = misspelt(name);
    if (meant.empty()) return;
    const std::string text = quoted(name) + " does nothing; did you mean " + quoted(meant) + "?";
    // `grown` or `divided` may be a name for what has become of the cell.
    if (name.starts_with(meant)) warnings_.add(word.place, text);
    else diagnostics_.add(word.place, text);
  }

  /// True for a name such as `Divide`, which is wrong even where a gene reads it.
  static bool isCase(const std::string& name) {
    return std::ranges::any_of(substance::acting,
                               [&](const std::string& word) { return name != word && equalButForCase(name, word); });
  }

  void checkStart(const Word& word) {
    const std::string& name = word.text;
    if (name == "START" || name == substance::a || name == substance::b || isActing(name) || read_.contains(name) ||
        isReadOutside(name) || !misspelt(name).empty())
      return;
    // Cells without any gene may be there for their bodies alone.
    if (lines_.genes.empty())
      warnings_.add(word.place, "there is no gene that reads " + quoted(name) +
                                    ", so cells neither divide nor change; add a gene such as g1(divide|" + name + ")");
    else
      diagnostics_.add(word.place, "no gene reads " + quoted(name) +
                                       ", so it has no effect; remove it, or write a gene that reads it");
  }

  /// Notes that a cell can come to hold this substance, and so what genes make of it. Repressors may be absent.
  void reach(const std::string& name) {
    std::vector<std::string> found{name};
    while (!found.empty()) {
      const std::string next = found.back();
      found.pop_back();
      if (!reachable_.insert(next).second) continue;
      const auto [begin, end] = readers_.equal_range(next);
      for (auto reader = begin; reader != end; ++reader)
        if (--missing_[reader->second] == 0) found.push_back(lines_.genes[reader->second].product.text);
    }
  }

  /// Reports genes whose inputs are all produced, and yet never present: one diagnostic for each substance that would
  /// wake others up.
  void checkReach() {
    std::set<std::string> produced;
    for (std::size_t i = 0; i < lines_.genes.size(); ++i) {
      produced.insert(lines_.genes[i].product.text);
      std::set<std::string> inputs;
      for (const Word& input : lines_.genes[i].inputs)
        if (inputs.insert(input.text).second) readers_.emplace(input.text, i);
      missing_.push_back(inputs.size());
    }
    for (const std::string& name : surroundings_->given) reach(name);
    for (const Word& word : lines_.start) reach(word.text);
    // Divisions give A and B, and inputs that nothing produces have been reported.
    for (const std::string& name : read_)
      if (!produced.contains(name)) reach(name);
    for (const GeneLine& gene : lines_.genes)
      for (const Word& input : gene.inputs) {
        if (reachable_.contains(input.text)) continue;
        if (!diagnostics_.isTold(input.place)) diagnostics_.add(input.place, whyAbsent(input.text, gene));
        reach(input.text);
      }
  }

  std::string whyAbsent(const std::string& name, const GeneLine& reader) const {
    std::string producers;
    for (const GeneLine& gene : lines_.genes)
      if (gene.product.text == name) producers += (producers.empty() ? "" : ", ") + gene.name.text;
    if (producers == reader.name.text)
      return "only this gene produces " + quoted(name) +
             " and needs the substance itself, so the gene is never active; add the substance to START or write "
             "another gene that produces it";
    return quoted(name) + " is never present, because its producer (" + producers +
           ") is never active; add it to START or write another gene that produces it";
  }

  const Lines& lines_;
  const DnaSurroundings* surroundings_;
  Diagnostics& diagnostics_;
  Diagnostics& warnings_;
  std::set<std::string> read_;                       // substances that genes read
  std::set<std::string> reachable_;                  // substances that a cell can come to hold
  std::multimap<std::string, std::size_t> readers_;  // genes by their inputs
  std::vector<std::size_t> missing_;                 // [gene] inputs that are not reachable
};

}  // namespace

void checkEffect(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics,
                 Diagnostics& warnings) {
  EffectCheck(lines, surroundings, diagnostics, warnings).check();
}

}  // namespace morula::dna_text
