#include "engines/wire.h"

#include <charconv>
#include <istream>
#include <ostream>
#include <string>

#include "base/error.h"

namespace morula {

namespace {

constexpr const char* requestTitle = "morula-bullet-request-1";
constexpr const char* resultTitle = "morula-bullet-result-1";
constexpr std::size_t most = 100'000'000;  // of anything: a count beyond it is a broken message

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  Writer& word(const char* text) { return out_ << '\n' << text, *this; }
  Writer& number(double a) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, a).ptr;
    return out_.put(' ').write(text, end - text), *this;
  }
  Writer& vector(const Vector& a) { return number(a.x).number(a.y).number(a.z); }

 private:
  std::ostream& out_;
};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(in) {}
  void word(const std::string& expected) {
    std::string found;
    in_ >> found;
    if (found != expected)
      throw InputError("Bullet's message: '" + found + "' stands where '" + expected + "' was expected");
  }
  double number() {
    std::string text;
    in_ >> text;
    double a = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), a);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size())
      throw InputError("Bullet's message: '" + text + "' stands where a number was expected");
    return a;
  }
  double number(const char* expected) { return word(expected), number(); }
  std::size_t count() {
    const double a = number();
    if (!(a >= 0 && a <= most)) throw InputError("Bullet's message: a count is out of range");
    return static_cast<std::size_t>(a);
  }
  std::size_t count(const char* expected) { return word(expected), count(); }
  Vector vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::istream& in_;
};

void write(Writer& w, const std::vector<Body>& cells) {
  w.word("cells").number(double(cells.size()));
  for (const Body& cell : cells) {
    w.word("cell").number(cell.mass).number(cell.restScale).number(cell.pressureConstant);
    w.number(double(cell.position.size()));
    for (const Point& x : cell.position) w.vector(x);
    for (const Vector& v : cell.velocity) w.vector(v);
  }
}

std::vector<Body> readCells(Reader& r) {
  std::vector<Body> cells(r.count("cells"));
  for (Body& cell : cells) {
    cell.mass = r.number("cell");
    cell.restScale = r.number();
    cell.pressureConstant = r.number();
    cell.position.resize(r.count());
    cell.velocity.resize(cell.position.size());
    for (Point& x : cell.position) x = r.vector();
    for (Vector& v : cell.velocity) v = r.vector();
  }
  return cells;
}

}  // namespace

void writeRequest(std::ostream& out, const BulletRequest& request) {
  const BulletScene& s = request.scene;
  Writer w(out);
  w.word(requestTitle);
  w.word("baseline").number(static_cast<int>(s.baseline));
  w.word("steps").number(request.steps);
  w.word("reports").number(double(request.reports.size()));
  for (const int step : request.reports) w.number(step);
  w.word("time_step").number(s.timeStep);
  w.word("contact").number(s.contact);
  w.word("margin").number(s.margin);
  w.word("iterations").number(s.iterations);
  w.word("integrator").number(static_cast<int>(s.physics.integrator));
  w.word("membrane").number(s.physics.membrane.stiffness).number(s.physics.membrane.damping);
  w.word("outside").number(s.physics.pressure.outside);
  w.word("drag").number(s.physics.drag);
  w.word("shell").number(s.physics.shell.has_value());
  if (const auto& shell = s.physics.shell)
    for (const double a : shell->semiAxes) w.number(a);
  w.word("vertices").number(double(s.mesh.vertices.size()));
  for (const Point& x : s.mesh.vertices) w.vector(x);
  w.word("faces").number(double(s.mesh.faces.size()));
  for (const Face& f : s.mesh.faces)
    for (const auto v : f) w.number(v);
  write(w, s.cells);
  w.word("end\n");
  out.flush();
}

BulletRequest readRequest(std::istream& in) {
  BulletRequest request;
  BulletScene& s = request.scene;
  Reader r(in);
  r.word(requestTitle);
  const std::size_t baseline = r.count("baseline");
  if (baseline > 2) throw InputError("Bullet's message: there is no such baseline");
  s.baseline = static_cast<Baseline>(baseline);
  request.steps = static_cast<int>(r.count("steps"));
  request.reports.resize(r.count("reports"));
  for (int& step : request.reports) step = static_cast<int>(r.count());
  s.timeStep = r.number("time_step");
  s.contact = r.number("contact") != 0;
  s.margin = r.number("margin");
  s.iterations = static_cast<int>(r.count("iterations"));
  const std::size_t integrator = r.count("integrator");
  if (integrator > static_cast<std::size_t>(Integrator::xpbd))
    throw InputError("Bullet's message: there is no such integrator");
  s.physics.integrator = static_cast<Integrator>(integrator);
  s.physics.membrane.stiffness = r.number("membrane");
  s.physics.membrane.damping = r.number();
  s.physics.pressure.outside = r.number("outside");
  s.physics.drag = r.number("drag");
  if (r.number("shell") != 0) {
    s.physics.shell = ShellParameters{};
    for (double& a : s.physics.shell->semiAxes) a = r.number();
  }
  s.mesh.vertices.resize(r.count("vertices"));
  for (Point& x : s.mesh.vertices) x = r.vector();
  s.mesh.faces.resize(r.count("faces"));
  for (Face& f : s.mesh.faces)
    for (auto& v : f) v = static_cast<std::int32_t>(r.count());
  s.cells = readCells(r);
  r.word("end");
  return request;
}

void writeResult(std::ostream& out, const BulletResult& result) {
  Writer w(out);
  w.word(resultTitle);
  w.word("step_seconds").number(double(result.stepSeconds.size()));
  for (const double s : result.stepSeconds) w.number(s);
  write(w, result.cells);
  w.word("reports").number(double(result.reports.size()));
  for (const auto& cells : result.reports) write(w, cells);
  w.word("end\n");
  out.flush();
}

BulletResult readResult(std::istream& in) {
  BulletResult result;
  Reader r(in);
  r.word(resultTitle);
  result.stepSeconds.resize(r.count("step_seconds"));
  for (double& s : result.stepSeconds) s = r.number();
  result.cells = readCells(r);
  result.reports.resize(r.count("reports"));
  for (auto& cells : result.reports) cells = readCells(r);
  r.word("end");
  return result;
}

}  // namespace morula
