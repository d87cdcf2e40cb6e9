#pragma once
// Who hears what: data on stdout, messages on stderr.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace morula::cli {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

/// Data for people or programs, on stdout.
void print(const std::string& text);
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

/// True if stderr is a terminal on which lines can be rewritten.
bool isTerminal();

}  // namespace morula::cli
