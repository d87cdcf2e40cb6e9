// Runs in every test: each reader reads its seeds, earlier findings (corpus/READER), and a fixed number of random
// mutations, the same on every machine.
//
//   fuzz_mutations COUNT [READER [FOLDER]]   COUNT inputs of each (Reader::times). A finding gives exit 1 and the
//                                            input in a file; FOLDER gets the seeds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/random.h"
#include "fuzz/readers.h"
#include "temporary_folder.h"

using namespace morula;
using namespace morula::fuzz;

namespace {

/// A source of random numbers: each call returns one from 0 to `below` − 1.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : seed_(seed) {}
  std::size_t operator()(std::size_t below) {
    return static_cast<std::size_t>(randomUnit({seed_, {}}, next_++) * static_cast<double>(below));
  }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

/// Returns a random piece of text of at most 60 bytes.
std::string_view pieceOf(const std::string& from, Chance& draw) {
  const std::size_t begin = draw(from.size() + 1), length = draw(std::min<std::size_t>(from.size() - begin, 60) + 1);
  return std::string_view(from).substr(begin, length);
}

std::string mutated(const std::vector<std::string>& seeds, Chance& draw) {
  static const char* const hostile[] = {"0",  "-1",   "1e308", "nan",     "99999999999999999999",
                                        "[",  "{",    "\"",    "\n",      "\xff",
                                        ": ", "*",    "]",     "}",       ",",
                                        "'",  "|",    ">",     "&",       "!",
                                        "#",  "%",    "@",     "~",       "?",
                                        "<",  ".",    "-",     "\t",      "\r",
                                        "\\", "\x01", "\x7f",  "\xc3\xa9"};
  std::string input = seeds[draw(seeds.size())];
  for (std::size_t changes = 1 + draw(4); changes > 0; --changes) {
    const std::size_t at = draw(input.size() + 1);
    switch (draw(6)) {
      case 0:
        if (at < input.size()) input[at] = static_cast<char>(draw(256));
        break;
      case 1: input.erase(at, draw(40)); break;
      case 2: input.insert(at, pieceOf(seeds[draw(seeds.size())], draw)); break;
      case 3: input.insert(at, hostile[draw(std::size(hostile))]); break;
      case 4: input.insert(at, std::string(pieceOf(input, draw))); break;
      default: input.resize(at); break;
    }
  }
  return input;
}

bool isFine(const Reader& reader, const std::string& input, std::size_t& taken) {
  std::string why;
  try {
    taken += takes(reader, input);
    return true;
  } catch (const std::exception& error) { why = error.what(); }
  const std::string file = std::string("finding-") + reader.name;
  writeText(file, input);
  std::printf("%s: %s; the input is in %s\n", reader.name, why.c_str(), file.c_str());
  return false;
}

std::vector<std::string> seedsOf(const Reader& reader) {
  std::vector<std::string> seeds = reader.seeds();
  const auto folder = std::filesystem::path(MORULA_SOURCE_DIR) / "tests/fuzz/corpus" / reader.name;
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files) seeds.push_back(readText(file));
  return seeds;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: fuzz_mutations COUNT [READER [FOLDER]]\n", stderr), 2;
  const std::size_t count = std::strtoull(argv[1], nullptr, 10);
  bool fine = true;
  for (const Reader& reader : readers()) {
    if (argc > 2 && std::string_view(argv[2]) != reader.name) continue;
    const auto seeds = seedsOf(reader);
    std::size_t taken = 0, read = seeds.size();
    bool isClean = true;
    for (const std::string& seed : seeds) isClean = isFine(reader, seed, taken) && isClean;
    for (std::size_t i = 0; argc > 3 && i < seeds.size(); ++i)
      writeText(std::filesystem::path(argv[3]) / std::to_string(i), seeds[i]);
    for (std::size_t i = 0; i < reader.times * count && isClean; ++i, ++read) {
      Chance draw(i);
      isClean = isFine(reader, mutated(seeds, draw), taken);
    }
    std::printf("%-10s %zu read, %zu taken\n", reader.name, read, taken);
    fine = fine && isClean;
  }
  return fine ? 0 : 1;
}
