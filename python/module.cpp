#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <pliant/pliant.hpp>

// The module pliant._pliant: the public C++ interface for Python. python/pliant/ adds what is
// easier to write in Python.

namespace py = pybind11;

namespace {

using pliant::Simulation;

/// A read-only view of a component of a field in memory. `owner` lives as long as the array.
template <class Real>
py::array view_of(std::span<const Real> values, const py::object& owner) {
  py::array_t<Real> view(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

/// The components of a field, each an array indexed by slot.
py::tuple views_of(const py::object& self, int body, const std::string& name) {
  const auto field = self.cast<const Simulation&>().field(body, name);
  py::list views;
  for (const auto values : field.values) views.append(view_of(values, self));
  for (const auto values : field.single_values) views.append(view_of(values, self));
  return py::tuple(views);
}

/// Names and units of the fields of a body.
py::dict units_of(const Simulation& simulation, int body) {
  py::dict units;
  for (const auto& field : simulation.fields(body))
    units[py::str(std::string(field.name))] = std::string(field.unit);
  return units;
}

/// The slots that hold particles, in ascending order.
py::array_t<std::int64_t> slots_of(const Simulation& simulation, int body) {
  std::int64_t count = 0;
  const auto runs = simulation.particles(body);
  for (const auto& run : runs) count += run.last - run.first;
  py::array_t<std::int64_t> slots(count);
  std::int64_t* slot = slots.mutable_data();
  for (const auto& run : runs) {
    for (std::int64_t p = run.first; p < run.last; ++p) *slot++ = p;
  }
  return slots;
}

py::array_t<double> positions_of(const Simulation& simulation, int body) {
  const auto positions = simulation.positions(body);
  py::array_t<double> array({static_cast<py::ssize_t>(positions.size()), py::ssize_t{3}});
  if (!positions.empty())
    std::copy_n(positions.front().data(), 3 * positions.size(), array.mutable_data());
  return array;
}

py::dict totals_of(Simulation& simulation) {
  const pliant::Totals totals = simulation.totals();
  py::dict dict;
  dict["mass"] = totals.mass;
  dict["momentum"] = totals.momentum;
  dict["angular_momentum"] = totals.angular_momentum;
  dict["kinetic_energy"] = totals.kinetic_energy;
  dict["strain_energy"] = totals.strain_energy;
  return dict;
}

void add_case_file(py::module_& module) {
  py::class_<pliant::CaseFile>(module, "CaseFile", "The text of a case, with settings.")
      .def_static("read", &pliant::CaseFile::read, py::arg("path"),
                  "A TOML file, or a folder that holds a case.toml.")
      .def_static("parse", &pliant::CaseFile::parse, py::arg("toml"), py::arg("folder") = ".",
                  "TOML text; names of files in it are relative to `folder`.")
      .def(
          "set",
          [](pliant::CaseFile& self, const std::string& key, const std::string& value)
              -> pliant::CaseFile& { return self.set(key, std::string_view(value)); },
          py::arg("key"), py::arg("value"), py::return_value_policy::reference_internal,
          "Sets a key to a value of TOML, as --set does.")
      .def_property_readonly("text", &pliant::CaseFile::text);
}

void add_inputs(py::module_& module) {
  using pliant::Input;
  py::enum_<Input::Kind>(module, "InputKind")
      .value("advance", Input::Kind::advance)
      .value("pressure", Input::Kind::pressure)
      .value("wall_velocity", Input::Kind::wall_velocity)
      .value("blade", Input::Kind::blade)
      .value("lift", Input::Kind::lift);
  using Place = std::array<double, 3>;
  py::class_<Input>(module, "Input", "What a caller does to a simulation, and when.")
      .def(py::init([](Input::Kind kind, double time, std::string name, double until, double value,
                       const Place& first, const Place& second) {
             return Input{kind, time, std::move(name), until, value, first, second};
           }),
           py::arg("kind"), py::arg("time"), py::arg("name") = "", py::arg("until") = 0.0,
           py::arg("value") = 0.0, py::arg("first") = Place{}, py::arg("second") = Place{})
      .def_readonly("kind", &Input::kind)
      .def_readonly("time", &Input::time, "[s]")
      .def_readonly("name", &Input::name, "Of a boundary or a cut of the case.")
      .def_readonly("until", &Input::until, "Of an advance: the time that was asked for [s].")
      .def_readonly("value", &Input::value, "Of a pressure [Pa].")
      .def_readonly("first", &Input::first,
                    "A velocity [m/s], or an end of the edge of a blade [m].")
      .def_readonly("second", &Input::second, "The other end of the edge of a blade [m].");
  module.def("read_inputs", &pliant::read_inputs, py::arg("file"), "A session from a CSV file.");
  module.def("write_inputs", &pliant::write_inputs, py::arg("file"), py::arg("inputs"),
             "Writes a session that read_inputs reads, to the same bits.");
  py::class_<pliant::Progress>(module, "Progress", "How far an advance on a budget has come.")
      .def_readonly("steps", &pliant::Progress::steps)
      .def_readonly("lag", &pliant::Progress::lag, "Simulated time that was put off [s].")
      .def_readonly("wall_time", &pliant::Progress::wall_time, "[s]");
}

void add_simulation(py::module_& module) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<Simulation>(module, "Simulation", "A case that is being simulated.")
      .def(py::init([](const pliant::CaseFile& file, int threads, std::string isa) {
             return Simulation(file, {.threads = threads, .isa = std::move(isa)});
           }),
           py::arg("case"), py::arg("threads") = 0, py::arg("isa") = "", Release())
      .def("step", &Simulation::step, Release(), "One time step.")
      .def("advance", py::overload_cast<double>(&Simulation::advance), py::arg("until"), Release(),
           "Steps until this time [s] is reached.")
      .def("advance", py::overload_cast<double, double>(&Simulation::advance), py::arg("until"),
           py::arg("budget"), Release(),
           "The same within `budget` seconds of wall time; returns a Progress.")
      .def_property_readonly("time", &Simulation::time, "[s]")
      .def_property_readonly("time_step", &Simulation::time_step, "Length of the next step [s].")
      .def_property_readonly("step_count", &Simulation::step_count)
      .def_property_readonly("dimension", &Simulation::dimension)
      .def_property_readonly("bodies", &Simulation::bodies)
      .def_property_readonly("particle_count", &Simulation::particle_count)
      .def("slots", &slots_of, py::arg("body") = 0,
           "The slots of the arrays of a body that hold particles.")
      .def("fields", &units_of, py::arg("body") = 0, "Names of the fields of a body, with units.")
      .def(
          "components", &views_of, py::arg("body"), py::arg("name"),
          "The components of a field, each a read-only array indexed by slot, without a copy. Good "
          "until the next step.")
      .def("positions", &positions_of, py::arg("body") = 0,
           "Positions of the particles of a body, [particle][3] [m]: a copy.")
      .def("totals", &totals_of, "Conserved quantities of all bodies.")
      .def("measurement", &Simulation::measurement, py::arg("name"), Release(),
           "The present value of a measurement of the case.")
      .def("set_pressure", &Simulation::set_pressure, py::arg("boundary"), py::arg("pressure"),
           "From now on a boundary of kind \"pressure\" has this pressure [Pa].")
      .def("set_wall_velocity", &Simulation::set_wall_velocity, py::arg("boundary"),
           py::arg("velocity"), "From now on a wall moves with this velocity [m/s].")
      .def("move_blade", &Simulation::move_blade, py::arg("cut"), py::arg("start"), py::arg("end"),
           "The edge of the blade of a cut is between these places [m] from now on.")
      .def("lift_blade", &Simulation::lift_blade, py::arg("cut"),
           "Takes a blade out: where it is put next, a new cut begins.")
      .def("enter", &Simulation::enter, py::arg("input"), "Takes an input at its time.")
      .def("play", &Simulation::play, py::arg("session"), Release(),
           "Takes the inputs of a session, and advances to the time of each.")
      .def_property_readonly("session", &Simulation::session,
                             "All that has been done since it was made or restored.")
      .def("save", &Simulation::save, py::arg("file"), Release(),
           "Writes everything that the next step reads.")
      .def("restore", &Simulation::restore, py::arg("file"), Release(),
           "Continues from a file that a simulation of the same case has saved.");
}

}  // namespace

PYBIND11_MODULE(_pliant, module) {
  module.attr("__version__") = std::string(pliant::version);
  py::register_exception<pliant::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<pliant::RunError>(module, "RunError", PyExc_RuntimeError);
  add_case_file(module);
  add_inputs(module);
  add_simulation(module);
}
