#pragma once
// One page that needs nothing but itself: no network, no other file. What it shows comes as finished HTML, written with html.h.
#include <string>
#include <vector>

namespace morula {

/// A section of the page.
struct PageBlock {
  std::string id;                          // of the element; letters, digits and -
  std::string title;                       // plain text
  std::string html;                        // what it shows
  std::vector<std::string> commands = {};  // plain text: what makes this again
};

/// Bytes for the explorer, kept as base64 in an element of this id.
struct PageBytes {
  std::string id, bytes;
};

struct Page {
  std::string title;    // plain text
  std::string summary;  // plain text, under the title; may be empty
  std::string verdict;  // HTML: the first thing to be seen
  std::vector<PageBlock> blocks;
  std::string data;  // JSON for the explorer; "" where there is nothing to explore
  std::vector<PageBytes> bytes;
  std::string command;  // plain text: what makes this page again; may be empty
  std::string program;  // the explorer, JavaScript in one piece; "": the page stands without it
};

/// The file. Equal pages give equal bytes. A content security policy forbids all requests, and every program but `program`.
std::string pageFile(const Page& page);

/// A table; `head` and `rows` are HTML. `caption` is plain text, for people who do not see the heading above it.
std::string htmlTable(const std::string& caption, const std::vector<std::string>& head,
                      const std::vector<std::vector<std::string>>& rows);
/// An SVG or PNG with a text for people who cannot see it; both texts are plain.
std::string htmlPicture(const std::string& type, const std::string& bytes, const std::string& what,
                        const std::string& caption);
/// The same, of a picture with many words: where there is no room it can be scrolled, for it does not become too small to read.
std::string htmlLarge(const std::string& type, const std::string& bytes, const std::string& what,
                      const std::string& caption);
/// Folded away until it is asked for. `title` is plain text.
std::string htmlFolded(const std::string& title, const std::string& html);

/// The page's own style sheet.
const char* pageStyle();

}  // namespace morula
