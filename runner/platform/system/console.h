#pragma once
// What is printed where: data on stdout, messages on stderr. The only file that writes to either. Every text passes through
// `printable`, because texts hold names, paths and messages that come from the files of others.
#include <iosfwd>
#include <string>
#include <vector>

#include "system/json.h"

namespace morula {

/// Data for people or programs, on stdout.
void print(const std::string& text);
/// Bytes for another program, on stdout, as they are.
void printBytes(const std::string& bytes);
/// One JSON object on stdout, with "morula": 1 in front.
void printJson(const Json& members);

/// A remark on stderr; not said when `quiet`.
void tell(const std::string& text, bool quiet);
/// "morula: …" on stderr.
void tellError(const std::string& text);
/// Lines that begin with "file:line:column:", as editors and other programs read them.
void tellInputError(const std::string& text);

/// The same for what may not be meant: "warning: file:line:column: …"; not said when `quiet`.
void tellWarnings(const std::vector<std::string>& lines, bool quiet);

/// Shows a line that the next one replaces, on a terminal; otherwise lines below each other.
void showProgress(const std::string& line);
/// Removes the line that showProgress left on a terminal.
void clearProgress();

/// Where a worker that this program has started reads its question and writes its answer.
std::istream& questionStream();
std::ostream& answerStream();
/// Throws FileError unless all that was printed has arrived: a full disk is no success.
void flushOutput();
/// Makes sure that files which are opened later do not become standard input, output or error, where those are closed.
void reserveStandardStreams();

/// True if stderr is a terminal on which lines can be rewritten.
bool isTerminal();

}  // namespace morula
