// Runs a reader for libFuzzer. The environment names the reader: MORULA_FUZZ=scenario fuzz_readers CORPUS, as in
// fuzz.sh.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/readers.h"

namespace {

const morula::fuzz::Reader& chosen() {
  const char* name = std::getenv("MORULA_FUZZ");
  if (const auto* reader = morula::fuzz::readerNamed(name ? name : "")) return *reader;
  std::fputs("MORULA_FUZZ names none of the readers:", stderr);
  for (const auto& reader : morula::fuzz::readers()) std::fprintf(stderr, " %s", reader.name);
  std::fputs("\n", stderr);
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const morula::fuzz::Reader& reader = chosen();
  takes(reader, {reinterpret_cast<const char*>(data), size});
  return 0;
}
