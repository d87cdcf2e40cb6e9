#include "library/scene_format.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "biology/sense.h"
#include "division/policy.h"
#include "state/scene.h"

namespace morula {

namespace scene_format {

namespace {

constexpr std::string_view title = "morula-scene ", lastWord = "hash ";

struct Writer {
  std::string out;
  void number(std::uint64_t n) { out += std::to_string(n) + '\n'; }
  void text(const std::string& s) { out += std::to_string(s.size()) + ' ' + s + '\n'; }
};

class Reader {
 public:
  Reader(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(at_) + ": " + what);
  }
  std::uint64_t number() {
    const std::uint64_t n = digits();
    skip('\n');
    return n;
  }
  std::string text() {
    const std::uint64_t size = digits();
    skip(' ');
    if (size > rest_.size()) refuse("a text of " + std::to_string(size) + " bytes is cut off");
    std::string s(rest_.substr(0, size));
    rest_.remove_prefix(size);
    line_ += static_cast<std::uint64_t>(std::count(s.begin(), s.end(), '\n'));
    skip('\n');
    return s;
  }
  /// Reads the length of a list. Each of its members takes two bytes at least, so no number can ask for more memory
  /// than the text has.
  std::size_t length() {
    const std::uint64_t n = number();
    if (n > rest_.size() / 2) refuse("a list of " + std::to_string(n) + " is longer than the rest of the scene");
    return static_cast<std::size_t>(n);
  }
  void end() const {
    if (!rest_.empty()) refuse("the scene is complete; nothing may follow");
  }

 private:
  std::uint64_t digits() {
    at_ = line_;
    std::uint64_t n = 0;
    const char *begin = rest_.data(), *end = begin + rest_.size();
    const auto [next, error] = std::from_chars(begin, end, n);
    if (error != std::errc() || (*begin == '0' && next != begin + 1))
      refuse("needs a whole number below 2^64, without zeros before it");
    rest_.remove_prefix(static_cast<std::size_t>(next - begin));
    return n;
  }
  void skip(char c) {
    if (rest_.empty() || rest_.front() != c)
      refuse(c == ' ' ? "needs a blank and a text" : "needs the end of the line");
    rest_.remove_prefix(1);
    if (c == '\n') ++line_;
  }

  std::string_view rest_;
  std::string name_;
  std::uint64_t line_ = 2, at_ = 2;  // the next line, behind the title; the line of the last number
};

/// Returns how many values a choice has; they are counted from 0.
template <class Enum>
std::size_t countOf() {
  if constexpr (requires { choices<Enum>.size(); }) return choices<Enum>.size();
  else if constexpr (std::is_same_v<Enum, SenseKind>) return senseKinds().size();
  else if constexpr (std::is_same_v<Enum, DivisionPlane>) return divisionPlanes().size();
  else if constexpr (std::is_same_v<Enum, CellSelection::Kind>) return 5;
  else {
    static_assert(std::is_same_v<Enum, DivisionSize::Rule>);
    return 2;
  }
}

void add(Writer& w, const double& a) { w.number(std::bit_cast<std::uint64_t>(a)); }
void add(Reader& r, double& a) {
  a = std::bit_cast<double>(r.number());
  if (std::isnan(a)) r.refuse("these bits are not those of a finite number");
}
void add(Writer& w, const std::string& a) { w.text(a); }
void add(Reader& r, std::string& a) { a = r.text(); }
void add(Writer& w, const CellPath& a) { w.text(a.text()); }
void add(Reader& r, CellPath& a) {
  const std::string text = r.text();
  if (text.size() > CellPath::maxDepth || text.find_first_not_of("AB") != text.npos)
    r.refuse("'" + text + "' is no path of a cell");
  a = CellPath::parse(text);
}

template <class T>
concept Whole = std::is_integral_v<T> || std::is_enum_v<T>;

void add(Writer& w, const Whole auto& a) { w.number(static_cast<std::uint64_t>(a)); }
template <Whole T>
void add(Reader& r, T& a) {
  const std::uint64_t n = r.number();
  a = static_cast<T>(n);
  bool holds = static_cast<std::uint64_t>(a) == n;
  if constexpr (std::is_enum_v<T>) holds = holds && n < countOf<T>();
  if (!holds) r.refuse(std::to_string(n) + " is no value that this member can have");
}

template <class T>
void add(Writer& w, std::vector<T>& a) {
  w.number(a.size());
  for (T& one : a) add(w, one);
}
template <class T>
void add(Reader& r, std::vector<T>& a) {
  const std::size_t size = r.length();
  for (std::size_t i = 0; i < size; ++i) add(r, a.emplace_back());
}
template <class T>
void add(Writer& w, std::optional<T>& a) {
  w.number(a.has_value());
  if (a) add(w, *a);
}
template <class T>
void add(Reader& r, std::optional<T>& a) {
  bool given = false;
  add(r, given);
  if (given) add(r, a.emplace());
}
template <class T>
void add(Writer& w, std::shared_ptr<const T>& a) {
  std::optional<T> one = a ? std::optional(*a) : std::nullopt;
  add(w, one);
}
template <class T>
void add(Reader& r, std::shared_ptr<const T>& a) {
  std::optional<T> one;
  add(r, one);
  if (one) a.reset(new T(std::move(*one)));  // make_shared would compare names of types
}
void add(Writer& w, std::map<std::string, double>& a) {
  w.number(a.size());
  for (auto& [name, value] : a) w.text(name), add(w, value);
}
void add(Reader& r, std::map<std::string, double>& a) {
  for (std::size_t left = r.length(); left > 0; --left) {
    std::string name = r.text();
    if (!a.empty() && name <= a.rbegin()->first)
      r.refuse(
          "this name is not after the one before it; needs names in "
          "ascending order, each once");
    add(r, a[name]);
  }
}

template <class Words, class T, std::size_t count>
void add(Words& w, std::array<T, count>& a) {
  for (T& one : a) add(w, one);
}

template <class Words, HasMembers T>
void add(Words& w, T& a) {
  std::apply([&](auto&... member) { (add(w, member), ...); }, members(a));
}

/// Checks members that refer to others: numbers of substances and of vertices. Meshes must be valid, as those of
/// scenarios.
void checkReferences(const Scene& scene, const Reader& reader) {
  const Dna& dna = scene.dna;
  const auto areKnown = [&](const std::vector<SubstanceId>& ids) {
    return std::all_of(ids.begin(), ids.end(), [&](SubstanceId s) { return s < dna.substances.size(); });
  };
  bool good = std::is_sorted(dna.substances.begin(), dna.substances.end()) && areKnown(dna.start);
  for (const Gene& gene : dna.genes)
    good = good && areKnown({gene.product}) && areKnown(gene.inputs) && areKnown(gene.repressors);
  if (!good) reader.refuse("the DNA names a substance that is not in its list");
  if (!scene.mechanics) return;
  std::vector<const Mesh*> meshes{&scene.mechanics->mesh};
  for (const Mesh& mesh : scene.mechanics->coarser) meshes.push_back(&mesh);
  const auto& shell = scene.mechanics->physics.shell;
  if (shell && shell->mesh) meshes.push_back(&shell->mesh->mesh);
  for (const Mesh* mesh : meshes) {
    for (const Face& face : mesh->faces)
      for (const auto vertex : face)
        if (vertex < 0 || std::size_t(vertex) >= mesh->vertices.size())
          reader.refuse("a face names vertex " + std::to_string(vertex) + ", which the mesh does not have");
    checkClosedManifold(*mesh, "a mesh of the scene");
  }
}

}  // namespace

}  // namespace scene_format

using namespace scene_format;

std::string writeScene(Scene scene) {
  Writer w{std::string(title) + std::to_string(sceneFormat) + '\n'};
  add(w, scene);
  return w.out + std::string(lastWord) + Hasher().add(w.out).digest().text() + '\n';
}

Scene readScene(std::string_view text, const std::string& name) {
  const std::string first = std::string(title) + std::to_string(sceneFormat) + '\n';
  const auto fail = [&](const std::string& what) { throw InputError(name + ":1: " + what); };
  if (!text.starts_with(title))
    fail("the text is no scene; a scene begins with \"" + first.substr(0, first.size() - 1) + "\"");
  if (!text.starts_with(first))
    fail("a scene of another version; needs " + std::to_string(sceneFormat) +
         ", as the program writes that this one belongs to");
  const std::size_t tail = lastWord.size() + 33;
  if (text.size() < first.size() + tail || text.substr(text.size() - tail, lastWord.size()) != lastWord)
    fail("the scene is cut off, or text follows it; needs a hash as its last line");
  const std::string_view body = text.substr(0, text.size() - tail);
  const std::string hash = Hasher().add(body).digest().text() + '\n', stored(text.substr(text.size() - 33));
  if (hash != stored)
    fail("the scene was changed after it had been written: its hash is " + hash.substr(0, 32) + ", and " +
         stored.substr(0, 32) + " is what stands below it");
  Scene scene;
  Reader reader(body.substr(first.size()), name);
  add(reader, scene);
  reader.end();
  checkReferences(scene, reader);
  return scene;
}

}  // namespace morula
