// The file around the fields, and which scene it is of.
#include "simulation/checkpoint.h"

#include <algorithm>
#include <cstring>

#include "simulation/checkpoint_state.h"
#include "simulation/scene_parts.h"

namespace morula {
namespace {

constexpr std::string_view magic = "MORULACP";
constexpr std::size_t numberSize = sizeof(std::uint64_t);
constexpr std::size_t headSize = magic.size() + 2 * numberSize, tailSize = 2 * numberSize;

[[noreturn]] void refuse(const std::string& why) { throw InputError("checkpoint: " + why); }

void append(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), numberSize);
}

std::uint64_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint64_t value;
  std::memcpy(&value, bytes.data() + at, numberSize);
  return value;
}

Hash hashOf(std::uint64_t version, std::string_view fields) {
  Hasher h;
  h.field("checkpoint").add(version).add(fields);
  return h.digest();
}

std::string sealed(const std::string& fields) {
  std::string bytes;
  bytes.reserve(headSize + fields.size() + tailSize);
  bytes += magic;
  append(bytes, checkpointVersion);
  append(bytes, fields.size());
  bytes += fields;
  const Hash hash = hashOf(checkpointVersion, fields);
  append(bytes, hash.high);
  append(bytes, hash.low);
  return bytes;
}

std::string_view unsealed(std::string_view bytes) {
  if (bytes.substr(0, magic.size()) != magic) refuse("these bytes are not a checkpoint");
  if (bytes.size() < headSize) refuse("it is cut short within its first bytes");
  const std::uint64_t version = numberAt(bytes, magic.size()), length = numberAt(bytes, magic.size() + numberSize);
  if (version != checkpointVersion)
    refuse("it has format " + std::to_string(version) + ", and this program reads format " +
           std::to_string(checkpointVersion) + ": go on with the program that wrote it");
  const std::size_t rest = bytes.size() - headSize;
  if (rest < tailSize || rest - tailSize < length)
    refuse("it is cut short: " + std::to_string(bytes.size()) + " bytes of it are here");
  if (rest - tailSize > length) refuse("more bytes follow than belong to it");
  const std::string_view fields = bytes.substr(headSize, length);
  const Hash kept{numberAt(bytes, headSize + length), numberAt(bytes, headSize + length + numberSize)};
  if (kept != hashOf(version, fields)) refuse("it is damaged: its hash is not that of its content");
  return fields;
}

void writeScene(FieldWriter& out, const Scene& scene) {
  Texts names, hashes;
  for (const auto& [name, hash] : hashSceneParts(scene)) names.push_back(name), hashes.push_back(hash);
  out.add("scene.parts", names);
  out.add("scene.hashes", hashes);
}

void checkScene(FieldReader& in, const Scene& scene) {
  const Texts names = in.texts("scene.parts"), hashes = in.texts("scene.hashes");
  const std::vector<ScenePart> parts = hashSceneParts(scene);
  if (names.size() != hashes.size()) refuse("it tells too little of its scene");
  std::string others;
  const auto differ = [&](const std::string& name) { others += (others.empty() ? "" : ", ") + name; };
  for (const auto& [name, hash] : parts) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end() || hashes[at - names.begin()] != hash) differ(name);
  }
  for (const std::string& name : names)  // what the other scene has besides
    if (std::ranges::find(parts, name, &ScenePart::name) == parts.end()) differ(name);
  if (!others.empty()) refuse("it is of another scene; this one differs in: " + others);
}

}  // namespace

std::string saveState(const World& world) {
  FieldWriter fields;
  writeScene(fields, world.model);
  writeState(fields, world);
  return sealed(fields.bytes());
}

void restoreState(World& world, std::string_view checkpoint) {
  FieldReader fields(unsealed(checkpoint), "checkpoint");
  checkScene(fields, world.model);
  SavedState state = readState(fields, world);
  checkSavedState(state, world);
  takeOver(world, std::move(state));
}

}  // namespace morula
