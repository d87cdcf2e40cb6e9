#pragma once
// One self-contained HTML page: no network, no other file. Its contents come as finished HTML (runner/document). Every
// text from a scenario or a database must pass through one of the functions that escape or encode.
#include <string>
#include <string_view>
#include <vector>

#include "image/base64.h"

namespace morula {

/// Escapes & < > " ' for HTML text and quoted attributes. Bytes that are not UTF-8 must be replaced before.
std::string htmlText(std::string_view text);

/// Escapes JSON for a script element: < > & and the Unicode line ends (U+2028, U+2029) become \u003c …, so that no text
/// ends the element or begins a comment. The JSON's meaning stays.
std::string scriptJson(std::string_view json);

/// Returns a data URI such as "data:image/png;base64,…".
std::string dataUri(std::string_view type, std::string_view bytes);

/// Returns the 32 bytes of the SHA-256 [FIPS 180-4], which the page's policy names for its programs.
std::string sha256(std::string_view bytes);

/// A section of the page.
struct PageBlock {
  std::string id;                          // of the HTML element; letters, digits and -
  std::string title;                       // plain text
  std::string html;                        // contents
  std::vector<std::string> commands = {};  // plain text: commands that reproduce the block
};

/// Bytes for the explorer, stored as base64 in an element with this id.
struct PageBytes {
  std::string id, bytes;
};

struct Page {
  std::string title;    // plain text
  std::string summary;  // plain text, under the title; may be empty
  std::string verdict;  // HTML, at the top of the page
  std::vector<PageBlock> blocks;
  std::string data;  // JSON for the explorer; "" without an explorer
  std::vector<PageBytes> bytes;
  std::string command;  // plain text: the command that reproduces the page; may be empty
  std::string program;  // the explorer's JavaScript; "": the page has no program
  // True if the program starts the simulator: WebAssembly, in a worker made of the page's own text.
  bool runsAgain = false;
};

/// Returns the page as a file. Equal pages give equal bytes. A content security policy forbids all requests, and every
/// program but `program`.
std::string pageFile(const Page& page);

const char* pageStyle();

}  // namespace morula
