// Finds DNA that is well written but cannot work. A misspelling must not give an organism that silently does nothing,
// so a name that nothing can ever produce, or a gene that can never be active, is an error.
#include <algorithm>
#include <map>

#include "base/did_you_mean.h"
#include "biology/dna_text.h"
#include "biology/substances.h"

namespace morula::dna_text {

std::string quoted(const std::string& text) { return "'" + text + "'"; }

namespace {

std::string atLine(const Place& place) { return "line " + std::to_string(place.line); }

/// Returns all names that a cell can come to hold; names of lines that could not be read count as possible.
std::set<std::string> possibleSubstances(const Lines& lines) {
  std::set<std::string> names = lines.unreadableWords;
  names.insert({substance::a, substance::b});
  for (const Word& word : lines.start) names.insert(word.text);
  for (const GeneLine& gene : lines.genes) names.insert(gene.product.text);
  return names;
}

std::set<std::string> inputsOfAllGenes(const Lines& lines) {
  std::set<std::string> names;
  for (const GeneLine& gene : lines.genes)
    for (const auto* words : {&gene.inputs, &gene.repressors})
      for (const Word& input : *words) names.insert(input.text);
  return names;
}

bool isAsymmetry(const std::string& name) { return name == substance::a || name == substance::b; }

/// Only the simulator inserts substances that senses name: START and genes must not.
const char* const sensedOnly = " is inserted by a sense (senses); take another name";

void checkStart(const Lines& lines, const std::set<std::string>& sensed, Diagnostics& diagnostics) {
  if (!lines.hasStartLine)
    diagnostics.add(lines.begin, "no START line; name the egg's substances, for example START: a0");
  std::map<std::string, Place> seen;
  for (const Word& word : lines.start) {
    const auto [first, isNew] = seen.emplace(word.text, word.place);
    if (word.text == "START") diagnostics.add(word.place, "START cannot be a substance; take another name");
    else if (!isNew)
      diagnostics.add(word.place,
                      quoted(word.text) + " is in START already (" + atLine(first->second) + "); remove one");
    else if (isAsymmetry(word.text))
      diagnostics.add(word.place, quoted(word.text) + " is given to daughters only, at a division; take another name");
    else if (word.text == substance::divide || word.text == substance::die)
      diagnostics.add(word.place, quoted(word.text) +
                                      " acts when a gene produces it; START a substance and a gene such as g1(" +
                                      word.text + "|a0)");
    else if (sensed.contains(word.text)) diagnostics.add(word.place, quoted(word.text) + sensedOnly);
  }
}

void checkNames(const Lines& lines, Diagnostics& diagnostics) {
  std::map<std::string, Place> names;
  std::map<std::vector<std::string>, const GeneLine*> contents;
  for (const GeneLine& gene : lines.genes) {
    const auto [firstName, isNewName] = names.emplace(gene.name.text, gene.name.place);
    if (!isNewName)
      diagnostics.add(gene.name.place, "gene " + quoted(gene.name.text) + " exists already (" +
                                           atLine(firstName->second) + "); give this one another name");
    std::vector<std::string> content;
    for (const Word& input : gene.inputs) content.push_back(input.text);
    for (const Word& repressor : gene.repressors) content.push_back('!' + repressor.text);
    std::ranges::sort(content);
    content.push_back(gene.product.text);
    const auto [firstGene, isNewGene] = contents.emplace(content, &gene);
    if (!isNewGene)
      diagnostics.add(gene.product.place, "the same product and inputs as gene " +
                                              quoted(firstGene->second->name.text) + " (" +
                                              atLine(firstGene->second->name.place) + "); remove one of the two");
  }
}

void checkProduct(const Word& product, const std::set<std::string>& sensed, Diagnostics& diagnostics) {
  if (product.text == "START") diagnostics.add(product.place, "START cannot be a substance; take another name");
  else if (isAsymmetry(product.text))
    diagnostics.add(product.place,
                    "no gene produces " + quoted(product.text) + ": daughters get it at a division; take another name");
  else if (sensed.contains(product.text)) diagnostics.add(product.place, quoted(product.text) + sensedOnly);
}

void checkInputs(const GeneLine& gene, const std::set<std::string>& possible, Diagnostics& diagnostics) {
  std::set<std::string> seen;
  for (const Word& input : gene.inputs) {
    const bool isNew = seen.insert(input.text).second;
    if (diagnostics.isTold(input.place)) continue;
    const std::string name = quoted(input.text);
    if (input.text == "START") {
      diagnostics.add(input.place, "START cannot be a substance; take another name");
    } else if (!isNew) {
      diagnostics.add(input.place, name + " is an input of this gene already; remove one");
    } else if (isAsymmetry(input.text) && seen.contains(substance::a) && seen.contains(substance::b)) {
      diagnostics.add(input.place, "no cell holds both 'A' and 'B', so this gene is never active; remove one");
    } else if (input.text == substance::die) {
      diagnostics.add(input.place,
                      "a cell that holds 'die' runs no further cycle, so this gene is never active; "
                      "take another input");
    } else if (!possible.contains(input.text)) {
      const std::vector<std::string> candidates(possible.begin(), possible.end());
      const std::string meant = closest(input.text, candidates);
      diagnostics.add(input.place, "nothing produces " + name + ", so this gene is never active; " +
                                       (meant.empty() ? "add it to START or write a gene that produces it"
                                                      : "did you mean " + quoted(meant) + "?"));
    }
  }
}

/// Reports repressors without effect: a substance that is never present represses nothing, and one that is also an
/// input represses always.
void checkRepressors(const GeneLine& gene, const std::set<std::string>& possible, Diagnostics& diagnostics) {
  std::set<std::string> inputs, seen;
  for (const Word& input : gene.inputs) inputs.insert(input.text);
  for (const Word& repressor : gene.repressors) {
    if (diagnostics.isTold(repressor.place)) continue;
    const std::string name = quoted(repressor.text);
    if (repressor.text == "START") {
      diagnostics.add(repressor.place, "START cannot be a substance; take another name");
    } else if (!seen.insert(repressor.text).second) {
      diagnostics.add(repressor.place, name + " represses this gene already; remove one");
    } else if (inputs.contains(repressor.text)) {
      diagnostics.add(repressor.place,
                      name +
                          " must be both present and absent, so this gene is never active; remove one of the two "
                          "inputs");
    } else if (repressor.text == substance::die) {
      diagnostics.add(repressor.place,
                      "a cell that holds 'die' runs no further cycle, so '!die' is always true; remove it");
    } else if (!possible.contains(repressor.text)) {
      const std::vector<std::string> candidates(possible.begin(), possible.end());
      const std::string meant = closest(repressor.text, candidates);
      diagnostics.add(repressor.place, "nothing produces " + name + ", so it represses nothing; " +
                                           (meant.empty() ? "remove it or write a gene that produces it"
                                                          : "did you mean " + quoted(meant) + "?"));
    }
  }
}

}  // namespace

void checkMeaning(const Lines& lines, const DnaSurroundings* surroundings, Diagnostics& diagnostics) {
  const std::set<std::string> sensed = surroundings ? surroundings->sensed : std::set<std::string>{};
  checkStart(lines, sensed, diagnostics);
  checkNames(lines, diagnostics);
  std::set<std::string> possible = possibleSubstances(lines);
  if (surroundings) possible.insert(surroundings->given.begin(), surroundings->given.end());
  possible.insert(sensed.begin(), sensed.end());
  const std::set<std::string> read = inputsOfAllGenes(lines);
  // Without all of START everything would seem unproduced: one diagnostic is enough.
  if (!lines.hasStartLine || !lines.areNamesKnown) possible.insert(read.begin(), read.end());
  for (const GeneLine& gene : lines.genes) {
    checkProduct(gene.product, sensed, diagnostics);
    checkInputs(gene, possible, diagnostics);
    checkRepressors(gene, possible, diagnostics);
  }
}

}  // namespace morula::dna_text
