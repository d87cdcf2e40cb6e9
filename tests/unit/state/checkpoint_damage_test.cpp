// A damaged checkpoint is refused, and the world stays as it was.
#include <cstring>
#include <functional>
#include <map>
#include <variant>

#include "base/fields.h"
#include "base/random.h"
#include "catch.h"
#include "simulation/restore.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

constexpr std::size_t headSize = 24, tailSize = 16;

World savedWorld() { return ranTo(scenes::life(), 4.1); }

/// Returns restoreState's message, or "" if it accepts the checkpoint.
std::string complaint(World& world, const std::string& checkpoint) {
  try {
    restoreState(world, checkpoint);
  } catch (const InputError& e) { return e.what(); }
  return "";
}

std::string complaint(const std::string& checkpoint, const Scene& scene = scenes::life()) {
  World world = makeWorld(scene);
  const Hash before = stateHash(world);
  const std::string text = complaint(world, checkpoint);
  if (!text.empty()) CHECK(stateHash(world) == before);
  return text;
}

std::string withByte(std::string bytes, std::size_t at, int change) {
  bytes[at] = static_cast<char>(bytes[at] ^ change);
  return bytes;
}

/// Returns the bytes with length and hash that fit their content, as written by somebody who knows the format.
std::string sealedAgain(std::string bytes) {
  std::uint64_t version;
  const std::uint64_t length = bytes.size() - headSize - tailSize;
  std::memcpy(&version, bytes.data() + 8, 8);
  std::memcpy(bytes.data() + 16, &length, 8);
  Hasher h;
  h.field("checkpoint").add(version).add(std::string_view(bytes).substr(headSize, bytes.size() - headSize - tailSize));
  const Hash hash = h.digest();
  std::memcpy(bytes.data() + bytes.size() - 16, &hash.high, 8);
  std::memcpy(bytes.data() + bytes.size() - 8, &hash.low, 8);
  return bytes;
}

using Numbers = std::vector<std::uint64_t>;
using Doubles = std::vector<double>;
using Texts = std::vector<std::string>;

/// A checkpoint's fields, which can be changed one by one and put together again.
class Fields {
 public:
  explicit Fields(const std::string& checkpoint) : checkpoint_(checkpoint) {
    std::string_view rest = std::string_view(checkpoint).substr(headSize);
    while (rest.size() > tailSize) {
      const char* begin = rest.data();
      std::uint64_t length, count;
      std::memcpy(&length, begin, 8);
      const std::string name(begin + 8, length);
      const char kind = begin[8 + length];
      std::memcpy(&count, begin + 9 + length, 8);
      const char* values = begin + 17 + length;
      const char* end = values + 8 * count;
      if (kind == 'u') add(name, Numbers(count), values);
      else if (kind == 'd') add(name, Doubles(count), values);
      else {
        REQUIRE(kind == 't');
        Texts texts;
        for (end = values; texts.size() < count; end += 8 + length) {
          std::memcpy(&length, end, 8);
          texts.emplace_back(end + 8, length);
        }
        names_.push_back(name);
        fields_[name] = texts;
      }
      rest.remove_prefix(static_cast<std::size_t>(end - begin));
    }
  }

  template <class Values>
  Values& of(const std::string& name) {
    CAPTURE(name);
    REQUIRE(fields_.contains(name));
    return std::get<Values>(fields_.at(name));
  }

  std::string checkpoint() const {
    FieldWriter out;
    for (const std::string& name : names_)
      std::visit([&](const auto& values) { out.add(name, values); }, fields_.at(name));
    return sealedAgain(checkpoint_.substr(0, headSize) + out.bytes() + std::string(tailSize, '\0'));
  }

 private:
  template <class Values>
  void add(const std::string& name, Values values, const char* bytes) {
    std::memcpy(values.data(), bytes, 8 * values.size());
    names_.push_back(name);
    fields_[name] = values;
  }

  std::string checkpoint_;
  Texts names_;
  std::map<std::string, std::variant<Numbers, Doubles, Texts>> fields_;
};

}  // namespace

TEST_CASE("Cut short at any length, a checkpoint is refused") {
  const std::string whole = saveState(makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1}));
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    CHECK_THAT(complaint(world, whole.substr(0, length)), ContainsSubstring("checkpoint: "));
  }
  CHECK(complaint(world, whole).empty());
  CHECK_THAT(complaint(world, whole.substr(0, 100)), ContainsSubstring("cut short: 100 bytes"));
  CHECK_THAT(complaint(world, whole + "x"), ContainsSubstring("more bytes follow"));
}

TEST_CASE("Any flipped bit of a checkpoint is noticed") {
  const std::string whole = saveState(makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1}));
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1});
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int bit = 0; bit < 8; ++bit)
      if (complaint(world, withByte(whole, at, 1 << bit)).empty()) FAIL("byte " << at << ", bit " << bit);
  CHECK_THAT(complaint(world, withByte(whole, 0, 1)), ContainsSubstring("these bytes are not a checkpoint"));
  CHECK_THAT(complaint(world, withByte(whole, 8, 1)), ContainsSubstring("has format 5"));
  CHECK_THAT(complaint(world, withByte(whole, headSize + 50, 1)), ContainsSubstring("damaged"));
}

TEST_CASE("Damage behind a hash that fits is refused too, or is a state that can be gone on with") {
  const std::string whole = saveState(savedWorld());
  REQUIRE(complaint(sealedAgain(whole)).empty());
  World world = makeWorld(scenes::life());
  int refused = 0, taken = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto random = randomWords({7, {}, 0, Purpose::test}, i);
    // Most bytes are coordinates; the fields that hold a state together stand before them.
    const std::size_t size = i % 3 == 0 ? whole.size() - headSize - tailSize : 6000;
    const std::string bytes = sealedAgain(withByte(whole, headSize + random[0] % size, 1 + random[1] % 255));
    if (!complaint(world, bytes).empty()) {
      ++refused;
      continue;
    }
    ++taken;
    try {
      step(world);
    } catch (const NumericalError&) {  // an absurd state may end the run, with a message
    }
  }
  CHECK(refused > 500);
  CHECK(taken > 500);
}

TEST_CASE("A checkpoint of another scene is refused, and the message says what differs") {
  const std::string saved = saveState(savedWorld());
  const auto differs = [&](const char* part, const std::function<void(Scene&)>& change) {
    Scene other = scenes::life();
    change(other);
    CAPTURE(part);
    CHECK_THAT(complaint(saved, other),
               ContainsSubstring(std::string("another scene; this scene differs in: ") + part));
  };
  differs("dna", [](Scene& s) { s.dna = parseDna(scenes::uniqueFour, "test.dna"); });
  differs("cycle", [](Scene& s) { s.cycle.length = 1.5; });
  differs("seed", [](Scene& s) { s.seed = 2; });
  differs("physics", [](Scene& s) { s.mechanics->physics.drag = 0.31; });
  differs("physics.mesh", [](Scene& s) { s.mechanics->mesh = scenes::scaled(makeIcosphere(1), 0.94); });
  differs("physics.contact", [](Scene& s) { s.mechanics->contact->viscosity = 0.2; });
  differs("physics.contact", [](Scene& s) { s.mechanics->contact.reset(); });
  differs("division", [](Scene& s) { s.mechanics->division.otherwise.plane = DivisionPlane::random; });
  differs("division", [](Scene& s) { s.mechanics->division.rules = {{.of = {"a0"}, .share = 0.4}}; });
  differs("connections", [](Scene& s) { s.mechanics->connections->releaseDistance.reset(); });
  differs("variation", [](Scene& s) { s.variation.cycle = 0.1; });
  differs("physics, physics.mesh, physics.contact, division, connections", [](Scene& s) { s.mechanics.reset(); });
}

TEST_CASE("A checkpoint knows of a variation that this scene has not, and asks nothing of that of the start") {
  Scene varied = scenes::life();
  varied.variation = {.cycle = 0.1, .start = 0.5};
  const std::string saved = saveState(makeWorld(varied));
  CHECK_THAT(complaint(saved, scenes::life()), ContainsSubstring("differs in: variation"));
  varied.variation.start = 0;
  CHECK(complaint(saved, varied) == "");
}

TEST_CASE("A state whose parts contradict each other is refused") {
  const std::string good = saveState(savedWorld());
  REQUIRE(Fields(good).checkpoint() == good);
  const auto refused = [&](const char* why, const std::function<void(Fields&)>& change) {
    Fields bad(good);
    change(bad);
    CAPTURE(why);
    CHECK_THAT(complaint(bad.checkpoint()), ContainsSubstring(why));
  };
  const auto real = [](const char* field, double value) { return [=](Fields& f) { f.of<Doubles>(field)[0] = value; }; };
  const auto number = [](const char* field, std::uint64_t value) {
    return [=](Fields& f) { f.of<Numbers>(field)[0] = value; };
  };
  const auto text = [](const char* field, const std::string& value) {
    return [=](Fields& f) { f.of<Texts>(field)[0] = value; };
  };
  const auto shorter = [](const char* field) { return [=](Fields& f) { f.of<Doubles>(field).pop_back(); }; };
  refused("the clock", real("clock.time", INFINITY));
  refused("the clock", number("clock.epoch step", ~std::uint64_t{0}));
  refused("the time step", real("clock.time step", 0));
  refused("holds no single value", [](Fields& f) { f.of<Numbers>("clock.step").push_back(1); });
  refused("no substance 'a99'", text("states", "a99"));
  refused("sorted", text("states", "a1 a0"));
  refused("no state", number("cells.state", 1000));
  refused("cells have columns of different lengths", shorter("cells.growth"));
  refused("only the letters A and B", text("lineage.path", "X"));
  refused("at most 120", text("lineage.path", std::string(121, 'A')));
  refused("unknown fate", number("lineage.fate", 3));
  refused("not those of the lineage", number("lineage.fate", 0));
  refused("lineage have columns of different lengths", shorter("lineage.born"));
  refused("order of cells", [](Fields& f) {
    std::swap(f.of<Texts>("cells.path")[0], f.of<Texts>("cells.path")[1]);
    std::swap(f.of<Numbers>("cells.entry")[0], f.of<Numbers>("cells.entry")[1]);
  });
  refused("is not in the lineage", number("cells.entry", 1000000));
  refused("place in the lineage", number("cells.entry", std::uint64_t{1} << 32));
  refused("time of a cell cycle", real("cells.last cycle", -INFINITY));
  refused("divisions have columns of different lengths", shorter("divisions.axis"));
  refused("a mesh that the scene has not", number("bodies.coarseness", 1));
  refused("bodies have columns", shorter("bodies.velocity"));
  refused("bodies have columns", shorter("bodies.volume"));
  refused("mass or size", real("bodies.vertex mass", -1));
  refused("influence radius", real("contacts.radius", INFINITY));
  refused("contacts have columns", shorter("contacts.reference"));
  refused("contacts have columns", [](Fields& f) { f.of<Numbers>("contacts.counters").pop_back(); });
  refused("'boredom' is none of", text("connections.cause", "boredom"));
  refused("a connection of",
          [](Fields& f) { std::swap(f.of<Texts>("connections.a")[0], f.of<Texts>("connections.b")[0]); });
  refused("a connection of", real("connections.released", -1));
}

TEST_CASE("A checkpoint knows sub-steps and what keeps its cells in shape") {
  const Scene scene = scenes::byPositions(scenes::life(), 2), shapes = scenes::byShapes(scenes::life());
  const std::string bySteps = saveState(makeWorld(scene)), byShapes = saveState(makeWorld(shapes));
  const auto differs = [](const std::string& saved, Scene other,
                          const std::function<void(PhysicsParameters&)>& change) {
    change(other.mechanics->physics);
    CHECK_THAT(complaint(saved, other), ContainsSubstring("another scene; this scene differs in: physics"));
  };
  CHECK(complaint(bySteps, scene) == "");
  CHECK(complaint(byShapes, shapes) == "");
  differs(bySteps, scene, [](PhysicsParameters& p) { p.substeps = 3; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.cell.model = CellModel::shell; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.stiffness = 401; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.linear = 0.25; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.damping = 5; });
}
