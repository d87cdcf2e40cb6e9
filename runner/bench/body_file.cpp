#include "bench/body_file.h"

#include <sstream>

#include "base/error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"

namespace morula {

namespace {

// key, count, vertices, then the numbers of each body, then the digest of these numbers; in the machine's own
// byte order, for it never leaves it.
struct Header {
  Hash key;
  std::uint64_t count = 0, vertices = 0;
};

constexpr std::uint64_t maxBytes = std::uint64_t{4} << 30;

template <class T>
bool readRaw(std::istream& in, T* to, std::size_t n) {
  return static_cast<bool>(in.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(n * sizeof(T))));
}
template <class T>
void writeRaw(std::ostream& out, const T* from, std::size_t n) {
  out.write(reinterpret_cast<const char*>(from), static_cast<std::streamsize>(n * sizeof(T)));
}

Hash digest(const std::vector<double>& numbers) {
  Hasher h;
  h.field("numbers").add(std::span<const double>(numbers));
  return h.digest();
}

}  // namespace

std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key) {
  if (!fileExists(file)) return {};
  const std::string bytes = readFile(file, maxBytes);
  const std::uint64_t size = bytes.size();
  std::istringstream in(bytes);
  Header header;
  if (!readRaw(in, &header, 1) || header.key != key) return {};
  const std::size_t perBody = 3 + 6 * header.vertices;
  if (header.vertices > size || header.count > size || size != sizeof header + header.count * perBody * 8 + sizeof(Hash))
    return {};
  std::vector<double> numbers(header.count * perBody);
  Hash stored;
  if (!readRaw(in, numbers.data(), numbers.size()) || !readRaw(in, &stored, 1) || stored != digest(numbers))
    return {};

  std::vector<Body> bodies(header.count);
  const double* next = numbers.data();
  for (Body& body : bodies) {
    body.mass = *next++, body.restScale = *next++, body.pressureConstant = *next++;
    for (auto* array : {&body.position, &body.velocity})
      for (std::size_t v = 0; v < header.vertices; ++v, next += 3)
        array->push_back({next[0], next[1], next[2]});
  }
  return bodies;
}

void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies) {
  std::vector<double> numbers;
  for (const Body& body : bodies) {
    numbers.insert(numbers.end(), {body.mass, body.restScale, body.pressureConstant});
    for (const auto* array : {&body.position, &body.velocity})
      for (const Vector& a : *array) numbers.insert(numbers.end(), {a.x, a.y, a.z});
  }
  const Header header{key, bodies.size(), bodies.empty() ? 0 : bodies[0].position.size()};
  const Hash sum = digest(numbers);
  std::ostringstream out;
  writeRaw(out, &header, 1);
  writeRaw(out, numbers.data(), numbers.size());
  writeRaw(out, &sum, 1);
  makeFolder(file.parent_path());
  overwriteFile(file, out.str());
}

}  // namespace morula
