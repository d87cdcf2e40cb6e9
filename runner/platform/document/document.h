#pragma once
// Documents on results, as blocks that a terminal, a page, Markdown and other programs each get in their own form.
// Nothing here is markup: every text may come from anywhere.
#include <string>
#include <variant>
#include <vector>

#include "document/table.h"
#include "image/colour.h"

namespace morula {

struct Block;

/// Blocks one below the other.
struct Document {
  std::vector<Block> blocks;

  template <class Kind>
  Document& add(Kind block);
  Document& add(Document others);
  Document& say(Words words);
  Document& note(Words words);     // what is worth less ink
  Document& heading(Words words);  // inside of a section
  bool empty() const { return blocks.empty(); }
};

struct Sentence {
  enum class Kind {
    plain,
    first,
    note,
    heading,
    part
  };  // first: what is known first of all; part: of a verdict of several parts
  Words words;
  Kind kind = Kind::plain;
};

/// A finding, and below it the reason.
struct Finding {
  enum class Kind { good, note, warning, bad };
  Kind kind;
  Words words;
  std::vector<std::string> why = {};
  bool operator==(const Finding&) const = default;
};
struct FindingList {
  std::vector<Finding> list;
};

struct PlainList {
  std::vector<Words> list;
};

/// Lines as they are; a longer text is cut, which is said.
struct Verbatim {
  std::string text;
  std::size_t maxBytes = 200'000;
};

/// A picture or a chart.
struct Picture {
  enum class Size { usual, wide, large };  // wide: two columns; large: with many words, is not shrunk but scrolled
  std::string type, bytes;                 // "image/png", "image/svg+xml"
  std::string what;                        // for people who cannot see it
  std::string caption;
  Size size = Size::usual;
  std::string name = {};  // by which Swipe knows it in its section
  std::string id = {};    // of its element, on a page once
};

/// The pictures with these names lie over each other, where programs run.
struct Swipe {
  std::string first, second;
  std::string titles;  // "ours | Bullet's"
};

/// The key to the lines of charts.
struct LineKey {
  struct Line {
    Colour colour;
    bool isDashed;
    Words words;
  };
  std::vector<Line> lines;
};

/// Files that can be taken along; a page holds them.
struct Downloads {
  struct File {
    std::string name, type, bytes;
  };
  std::vector<File> files;
};

/// The place of the explorer.
struct ExplorerPlace {};

/// A place, by its id, in which another program of the page builds; where none runs it says `without`.
struct ProgramPlace {
  std::string id, without;
};

/// Blocks that belong together.
struct Group {
  enum class Kind { pictures, charts, folded };  // folded: until it is asked for by its title
  Kind kind;
  std::string title;
  Document body;
};

struct Block : std::variant<Sentence, FindingList, PlainList, Verbatim, Table, Picture, Swipe, LineKey, Downloads,
                            ExplorerPlace, ProgramPlace, Group> {
  using variant::variant;
};

/// A document with a title, the commands that make what it shows again, and the id of its element on a page.
struct PageSection {
  std::string id;  // letters, digits and -
  std::string title;
  Document body;
  std::vector<std::string> commands = {};
};

template <class Kind>
Document& Document::add(Kind block) {
  blocks.emplace_back(std::move(block));
  return *this;
}

/// Makes a document of a verdict in one sentence, and of findings.
Document verdict(Words sentence, std::vector<Finding> findings);
/// Folded away until it is asked for by its title.
Group folded(std::string title, Document body);

/// "31 bytes", "2.75 kB", "1.2 MB".
std::string inBytes(std::size_t bytes);

/// Writes a document for a terminal, without pictures and downloads.
std::string textOf(const Document& document);
/// HTML, between the tags of a section.
std::string htmlOf(const Document& document);
std::string htmlOf(const Words& words);

}  // namespace morula
