#pragma once
// One page that needs nothing but itself: no network, no other file. What it shows comes as finished HTML: runner/document writes it.
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
  bool runsAgain =
      false;  // the program starts the simulator: WebAssembly, in a worker that is made of the page's own text
};

/// The file. Equal pages give equal bytes. A content security policy forbids all requests, and every program but `program`.
std::string pageFile(const Page& page);

/// The page's own style sheet.
const char* pageStyle();

}  // namespace morula
