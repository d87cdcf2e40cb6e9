#include "document/document.h"

#include "base/number_text.h"
#include "files/printable.h"

namespace morula {

Document& Document::add(Document others) {
  for (Block& block : others.blocks) blocks.push_back(std::move(block));
  return *this;
}

Document& Document::say(Words words) { return add(Sentence{std::move(words)}); }
Document& Document::note(Words words) { return add(Sentence{std::move(words), Sentence::Kind::note}); }
Document& Document::heading(Words words) { return add(Sentence{std::move(words), Sentence::Kind::heading}); }

std::string inBytes(std::size_t bytes) {
  if (bytes < 1000) return counted(bytes, "byte");
  const auto size = static_cast<double>(bytes);
  return size < 1e6 ? numberText(size / 1e3, 3) + " kB" : numberText(size / 1e6, 3) + " MB";
}

Document verdict(Words sentence, std::vector<Finding> findings) {
  return Document().add(Sentence{std::move(sentence), Sentence::Kind::first}).add(FindingList{std::move(findings)});
}

Group folded(std::string title, Document body) { return {Group::Kind::folded, std::move(title), std::move(body)}; }

namespace {

struct AsText {
  std::string operator()(const Sentence& s) const {
    const bool isHeading = s.kind == Sentence::Kind::heading || s.kind == Sentence::Kind::part;
    return (isHeading ? "\n" : "") + printable(s.words.text()) + "\n";
  }
  std::string operator()(const FindingList& f) const {
    std::string text;
    for (const Finding& finding : f.list) text += "  " + printable(finding.words.text()) + "\n";
    return text;
  }
  std::string operator()(const PlainList& items) const {
    std::string text;
    for (const Words& words : items.list) text += "  " + printable(words.text()) + "\n";
    return text;
  }
  std::string operator()(const Verbatim& v) const { return printable(v.text); }
  std::string operator()(const Table& table) const { return textOf(table); }
  std::string operator()(const Group& group) const { return textOf(group.body); }
  std::string operator()(const auto&) const { return {}; }
};

}  // namespace

std::string textOf(const Document& document) {
  std::string text;
  for (const Block& block : document.blocks) text += std::visit(AsText{}, block);
  return text;
}

}  // namespace morula
