#include "cli/console.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace morula::cli {

namespace {

std::string red(const std::string& text) {
  const char* plain = std::getenv("NO_COLOR");
  return isTerminal() && !(plain && *plain) ? "\x1b[31m" + text + "\x1b[0m" : text;
}

}  // namespace

void print(const std::string& text) { std::cout << text; }

void printJson(const Json& members) {
  Json object{{"morula", 1}};
  object.update(members);
  std::cout << object.dump(2) << "\n";
}

void tell(const std::string& text, bool quiet) {
  if (!quiet) std::cerr << text << "\n";
}

void tellError(const std::string& text) { std::cerr << red("morula: ") << text << "\n"; }

void tellInputError(const std::string& text) { std::cerr << text << "\n"; }

void tellWarnings(const std::vector<std::string>& lines, bool quiet) {
  for (const auto& line : lines) tell("warning: " + line, quiet);
}

bool isTerminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind && std::string(kind) != "dumb";
}

}  // namespace morula::cli
