// The compiled part of Python's package: organisms, tables as NumPy arrays, and errors by kind.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <limits>
#include <thread>

#include "base/floating_point.h"
#include "observation/asked_measure.h"
#include "python/organism.h"
#include "store/run_tables.h"
#include "store/store.h"

namespace py = pybind11;
using namespace morula;

namespace {

std::atomic<int> working = 0;        // threads inside of the simulator
std::atomic<bool> isEnding = false;  // the interpreter ends

struct Working {
  Working() { ++working; }
  ~Working() { --working; }
};

/// A thread's turn with an organism. Other Python threads run meanwhile; a second one with this organism is refused.
class Turn {
 public:
  explicit Turn(Organism& organism) : organism_(organism) {
    if (organism.inUse.test_and_set()) throw std::runtime_error("another thread uses this simulator");
  }
  ~Turn() { organism_.inUse.clear(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  Organism& organism_;
  Working counted_;
  py::gil_scoped_release released_;
  FloatingPointMode mode_;
};

/// Makes a function for Python of a member of Organism that runs without the interpreter's lock.
template <class Result, class... Args>
auto alone(Result (Organism::*member)(Args...) const) {
  return [member](Organism& organism, std::decay_t<Args>... args) {
    const Turn turn(organism);
    return (organism.*member)(args...);
  };
}

template <class T>
py::array arrayOf(std::vector<T> values, std::vector<py::ssize_t> shape = {}) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  if (shape.empty()) shape = {py::ssize_t(kept->size())};
  T* first = kept->data();
  const py::capsule owner(kept.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(std::move(shape), first, owner);
}

/// Whole numbers become int64 where no row lacks one, texts str or None.
py::object arrayOf(DataColumn& column) {
  if (column.kind == DataColumn::Kind::real) return arrayOf(std::move(column.numbers));
  if (column.kind == DataColumn::Kind::whole) {
    for (const double x : column.numbers)
      if (x != x) return arrayOf(std::move(column.numbers));
    return arrayOf(std::vector<std::int64_t>(column.numbers.begin(), column.numbers.end()));
  }
  py::array texts(py::dtype("O"), std::vector<py::ssize_t>{py::ssize_t(column.texts.size())});
  auto** place = static_cast<PyObject**>(texts.mutable_data());
  for (const auto& text : column.texts) {
    py::object value = py::none();
    if (text && column.kind == DataColumn::Kind::bytes) value = py::bytes(*text);
    else if (text) value = py::str(*text);
    Py_XDECREF(std::exchange(*place++, value.release().ptr()));
  }
  return texts;
}

/// Returns a dict of arrays, and a dict of the units that columns have.
py::tuple toPython(DataTable table) {
  py::dict columns, units;
  for (DataColumn& column : table.columns) {
    if (!column.unit.empty()) units[py::str(column.name)] = column.unit;
    columns[py::str(column.name)] = arrayOf(column);
  }
  return py::make_tuple(columns, units);
}

auto tableBy(DataTable (Organism::*member)(const std::string&) const) {
  return [make = alone(member)](Organism& organism, const std::string& name) { return toPython(make(organism, name)); };
}

void run(Organism& organism, double time, std::uint64_t most) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  const auto stops = [&] {  // Ctrl-C, and the end of the interpreter, are looked for 50 times a second
    if (isEnding) throw std::runtime_error("the interpreter ends");
    if (const auto now = Clock::now(); now - last < std::chrono::milliseconds(20)) return false;
    else last = now;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return false;
  };
  const Turn turn(organism);
  organism.run(time, most, stops);
}

template <class... Args>
std::unique_ptr<Organism> make(const Args&... args) {
  const Working counted;
  const py::gil_scoped_release released;
  const FloatingPointMode mode;
  return std::make_unique<Organism>(args...);
}

py::tuple sourceOf(const Organism& organism) {
  const ScenarioSource source = organism.source();
  py::list files;
  for (const NamedFile& f : source.files) files.append(py::make_tuple(f.role, f.path, py::bytes(f.content)));
  return py::make_tuple(py::bytes(source.bytes), source.name, source.sets, files);
}

std::unique_ptr<Organism> fromSource(const std::string& bytes, const std::string& name,
                                     const std::vector<std::string>& sets,
                                     const std::vector<std::array<std::string, 3>>& files, int threads) {
  ScenarioSource source{bytes, name, sets, {}};
  for (const auto& [role, path, content] : files) source.files.push_back({role, path, content});
  return make(source, threads);
}

/// Waits for threads that simulate: they must not ask an interpreter that is gone for its lock.
void endWork() {
  isEnding = true;
  const py::gil_scoped_release released;
  while (working > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Makes a kind of error one of Python's. Its text may hold the name of a file that is not UTF-8.
template <class Error>
void translate(py::module_& m, const char* name, PyObject* base) {
  static PyObject* const type = py::exception<Error>(m, name, base).release().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const std::string_view text = error.what();
      PyErr_SetObject(type, py::reinterpret_steal<py::object>(
                                PyUnicode_DecodeUTF8(text.data(), py::ssize_t(text.size()), "backslashreplace"))
                                .ptr());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_morula, m) {
  m.doc() = "The compiled part of morula; the package morula is for people.";
  translate<InputError>(m, "InputError", PyExc_ValueError);
  translate<NumericalError>(m, "NumericalError", PyExc_ArithmeticError);
  translate<FileError>(m, "FileError", PyExc_OSError);
  translate<BugError>(m, "BugError", PyExc_RuntimeError);
  py::module_::import("atexit").attr("register")(py::cpp_function(endWork));

  py::class_<Organism>(m, "Organism")
      .def(py::init(&make<std::string, std::vector<std::string>, int>), py::arg("scenario"), py::arg("sets"),
           py::arg("threads"))
      .def_static("from_source", &fromSource)
      .def("source", &sourceOf)
      .def("run", &run, py::arg("time") = std::numeric_limits<double>::infinity(), py::arg("most") = neverDue)
      .def("hash", alone(&Organism::hash))
      .def("save", [](Organism& o) { return py::bytes(alone(&Organism::save)(o)); })
      .def("restore",
           [](Organism& o, const std::string& state) {
             const Turn turn(o);
             o.restore(state);
           })
      .def("table", tableBy(&Organism::table), py::arg("name"))
      .def("table_now", tableBy(&Organism::tableNow), py::arg("name"))
      .def("measure",
           [](Organism& o, const std::string& name) -> py::object {
             MeasuredNow now = alone(&Organism::measure)(o, name);
             if (!now.ofCells) return py::float_(now.values[0]);
             return arrayOf(std::move(now.values));
           })
      .def("surfaces",
           [](Organism& o) {
             Surfaces s = alone(&Organism::surfaces)(o);
             const auto vertices = py::ssize_t(s.cell.size()), triangles = py::ssize_t(s.triangles.size() / 3);
             return py::make_tuple(arrayOf(std::move(s.vertices), {vertices, 3}),
                                   arrayOf(std::move(s.triangles), {triangles, 3}), arrayOf(std::move(s.cell)),
                                   arrayOf(std::move(s.start)));
           })
      .def("picture", [](Organism& o, const std::string& colour,
                         int size) { return py::bytes(alone(&Organism::picture)(o, colour, size)); })
      .def("clock",
           [](Organism& o) {
             const Turn turn(o);
             const World& world = o.world();
             return std::tuple(world.clock.time, world.clock.step, world.cells.path.size(), o.finished());
           })
      .def("measure_info",
           [](const Organism& o, const std::string& text) {  // its name in tables, its scope and its unit
             const AskedMeasure asked = o.measureNamed(text);
             return std::tuple(asked.name, name(asked.scope), asked.unit);
           })
      .def_property_readonly("name", [](const Organism& o) { return o.scenario().scene.name; })
      .def_property_readonly("seed", [](const Organism& o) { return o.scenario().scene.seed; })
      .def_property_readonly("threads", &Organism::threads)
      .def_property_readonly("warnings", [](const Organism& o) { return o.scenario().warnings; })
      .def_property_readonly("resolved", [](const Organism& o) { return o.scenario().resolved; });

  m.def("measures", [] {
    py::list all;
    for (const AskedMeasure& a : allMeasures()) all.append(py::make_tuple(a.name, a.unit, name(a.scope), a.onDemand));
    return all;
  });
  m.def("check_database", [](const std::string& file) {
    const py::gil_scoped_release released;
    Store::openForReading(file).requireAllIntact();
  });
  py::dict orders;
  for (const SqlTable* t : runTables())
    orders[t->info.name] = *t->info.order ? std::string("run_id, ") + t->info.order : std::string(t->info.key);
  m.attr("orders") = orders;
  m.attr("__version__") = buildInfo().version;
}
