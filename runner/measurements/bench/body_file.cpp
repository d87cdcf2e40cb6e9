#include "bench/body_file.h"

#include "base/error.h"
#include "base/fields.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"

namespace morula {
namespace {

constexpr std::uint64_t maxBytes = std::uint64_t{4} << 30;

std::string digest(const std::vector<double>& numbers) {
  Hasher h;
  return h.field("numbers").add(std::span<const double>(numbers)).digest().text();
}

}  // namespace

std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key) {
  if (!fileExists(file)) return {};
  try {
    const std::string bytes = readFile(file, maxBytes);
    FieldReader in(bytes, "bodies");
    const std::vector<std::string> header = in.texts("key and digest");
    const std::vector<std::uint64_t> counts = in.numbers("bodies and vertices");
    const std::vector<double> numbers = in.reals("numbers");
    in.end();
    if (header != std::vector{key.text(), digest(numbers)} || counts.size() != 2) return {};
    if (counts[1] > numbers.size() || counts[0] * (3 + 6 * counts[1]) != numbers.size()) return {};
    std::vector<Body> bodies(counts[0]);
    const double* next = numbers.data();
    for (Body& body : bodies) {
      body.mass = *next++, body.restScale = *next++, body.pressureConstant = *next++;
      for (auto* array : {&body.position, &body.velocity})
        for (std::size_t v = 0; v < counts[1]; ++v, next += 3) array->push_back({next[0], next[1], next[2]});
    }
    return bodies;
  } catch (const InputError&) { return {}; }
}

void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies) {
  std::vector<double> numbers;
  for (const Body& body : bodies) {
    numbers.insert(numbers.end(), {body.mass, body.restScale, body.pressureConstant});
    for (const auto* array : {&body.position, &body.velocity})
      for (const Vector& a : *array) numbers.insert(numbers.end(), {a.x, a.y, a.z});
  }
  FieldWriter out;
  out.add("key and digest", std::vector{key.text(), digest(numbers)});
  out.add("bodies and vertices",
          std::vector<std::uint64_t>{bodies.size(), bodies.empty() ? 0 : bodies[0].position.size()});
  out.add("numbers", numbers);
  makeFolder(file.parent_path());
  overwriteFile(file, out.bytes());
}

}  // namespace morula
