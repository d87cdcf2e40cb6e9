#pragma once
// One page that needs nothing but itself: no network, no other file. What it shows comes as finished HTML:
// runner/document writes it. And texts and bytes as they may stand in HTML: every text from a scenario or a database
// goes through one of these.
#include <string>
#include <string_view>
#include <vector>

namespace morula {

/// Between tags and in quoted attributes: & < > " ' are named. What is not UTF-8 must have been made visible before.
std::string htmlText(std::string_view text);

/// JSON for a script element: < > & and the line ends of Unicode (U+2028, U+2029) as \u003c …, so that nothing in it
/// ends the element or begins a comment. It reads as the same JSON.
std::string scriptJson(std::string_view json);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// "data:image/png;base64,…"
std::string dataUri(std::string_view type, std::string_view bytes);

/// The 32 bytes of the SHA-256 [FIPS 180-4], by which a page says which programs may run in it.
std::string sha256(std::string_view bytes);

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
  // The program starts the simulator: WebAssembly, in a worker that is made of the page's own text.
  bool runsAgain = false;
};

/// The file. Equal pages give equal bytes. A content security policy forbids all requests, and every program but
/// `program`.
std::string pageFile(const Page& page);

/// The page's own style sheet.
const char* pageStyle();

}  // namespace morula
