#include "biology/dna.h"

#include <algorithm>

#include "base/error.h"
#include "biology/dna_text.h"
#include "biology/substances.h"

namespace morula {

using namespace dna_text;

namespace {

Dna compose(const Lines& lines, std::string_view text) {
  Dna dna;
  dna.source = text;
  std::set<std::string> names = {substance::a, substance::b};
  for (const Word& word : lines.start) names.insert(word.text);
  for (const GeneLine& gene : lines.genes) {
    names.insert(gene.product.text);
    for (const auto* words : {&gene.inputs, &gene.repressors})
      for (const Word& input : *words) names.insert(input.text);
  }
  dna.substances.assign(names.begin(), names.end());

  const auto id = [&](const Word& word) { return *findSubstance(dna, word.text); };
  for (const Word& word : lines.start) dna.start.push_back(id(word));
  std::ranges::sort(dna.start);
  for (const GeneLine& line : lines.genes) {
    Gene gene{line.name.text, id(line.product), {}, {}};
    for (const Word& input : line.inputs) gene.inputs.push_back(id(input));
    for (const Word& repressor : line.repressors) gene.repressors.push_back(id(repressor));
    std::ranges::sort(gene.inputs);
    std::ranges::sort(gene.repressors);
    dna.genes.push_back(std::move(gene));
  }
  return dna;
}

}  // namespace

Dna parseDna(std::string_view text, const std::string& file, int firstLine, int firstColumn, const std::string& path,
             const DnaSurroundings* surroundings) {
  Diagnostics diagnostics, warnings;
  const Lines lines = readLines(text, {firstLine, firstColumn}, diagnostics);
  checkMeaning(lines, surroundings, diagnostics);
  checkEffect(lines, surroundings, diagnostics, warnings);
  diagnostics.report(file, path);
  Dna dna = compose(lines, text);
  dna.warnings = warnings.lines(file, path);
  return dna;
}

std::optional<SubstanceId> findSubstance(const Dna& dna, std::string_view name) {
  const auto found = std::ranges::lower_bound(dna.substances, name);
  if (found == dna.substances.end() || *found != name) return std::nullopt;
  return static_cast<SubstanceId>(found - dna.substances.begin());
}

}  // namespace morula
