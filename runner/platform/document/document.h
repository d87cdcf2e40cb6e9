#pragma once
// Documents on results, as blocks that a terminal, a page, Markdown and other programs each get in their own form.
// Blocks hold no markup, so any text may stand in them.
#include <string>
#include <variant>
#include <vector>

#include "document/table.h"
#include "image/colour.h"

namespace morula {

struct Block;

/// A document: blocks one below the other.
struct Document {
  std::vector<Block> blocks;

  template <class Kind>
  Document& add(Kind block);
  Document& add(Document others);
  Document& say(Words words);
  Document& note(Words words);     // adds a sentence in less conspicuous type
  Document& heading(Words words);  // adds a heading inside of a section
  bool empty() const { return blocks.empty(); }
};

struct Sentence {
  enum class Kind {
    plain,
    first,
    note,
    heading,
    part
  };  // first: the main statement; part: a sentence of a verdict of several parts
  Words words;
  Kind kind = Kind::plain;
};

/// A finding, and below it its reasons.
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

/// Lines that are shown unchanged. A longer text is cut, with a remark.
struct Verbatim {
  std::string text;
  std::size_t maxBytes = 200'000;
};

/// A picture or a chart.
struct Picture {
  enum class Size { usual, wide, large };  // wide: two columns; large: has many words, so it is scrolled and not shrunk
  std::string type, bytes;                 // "image/png", "image/svg+xml"
  std::string what;                        // a description for people who cannot see the picture
  std::string caption;
  Size size = Size::usual;
  std::string name = {};  // the name for Swipe, in its section
  std::string id = {};    // the id of its element, unique on a page
};

/// Two pictures that lie over each other, by their names, where programs run.
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

/// Files that a page holds for download.
struct Downloads {
  struct File {
    std::string name, type, bytes;
  };
  std::vector<File> files;
};

/// The block that the explorer fills.
struct ExplorerPlace {};

/// A block that another program of the page fills, found by its id. Where no programs run the block says `without`.
struct ProgramPlace {
  std::string id, without;
};

/// Blocks that belong together.
struct Group {
  enum class Kind { pictures, charts, folded };  // folded: shown on a click on its title
  Kind kind;
  std::string title;
  Document body;
};

struct Block : std::variant<Sentence, FindingList, PlainList, Verbatim, Table, Picture, Swipe, LineKey, Downloads,
                            ExplorerPlace, ProgramPlace, Group> {
  using variant::variant;
};

/// A document with a title, the commands that reproduce its content, and the id of its element on a page.
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
/// Makes a group that is folded until its title is clicked.
Group folded(std::string title, Document body);

/// Returns a size in words: "31 bytes", "2.75 kB", "1.2 MB".
std::string inBytes(std::size_t bytes);

/// Writes a document for a terminal, without pictures and downloads.
std::string textOf(const Document& document);
/// Writes a document as HTML, without the tags of the section around it.
std::string htmlOf(const Document& document);
std::string htmlOf(const Words& words);

}  // namespace morula
