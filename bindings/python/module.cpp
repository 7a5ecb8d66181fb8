// The part of the Python module that calls the library. Users see bindings/python/steadyslide/__init__.py. All work is
// done with the interpreter's lock released.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <steadyslide/steadyslide.hpp>
#include <tuple>

#include "bindings/python/picture.hpp"
#include "library/steadyslide/solution_state.hpp"

namespace py = pybind11;
namespace ss = steadyslide;

namespace steadyslide {

// The fields of each result, in the order of its tuple in Python.
inline auto fields(const Number& n) { return std::tie(n.value, n.error, n.digits); }
inline auto fields(const Limits& l) { return std::tie(l.left, l.right); }
inline auto fields(const LargestPressure& p) { return std::tie(p.value, p.x, p.exponent); }
inline auto fields(const Interval& i) { return std::tie(i.left, i.right); }
inline auto fields(const ContactEnd& e) { return std::tie(e.x, e.kind, e.exponent, e.intensity); }
inline auto fields(const ContactComponent& c) { return std::tie(c.left, c.right, c.width, c.load); }
inline auto fields(const SolvedPoint& p) {
  return std::tie(p.x, p.kind, p.exponent, p.symbolic, p.intensity, p.constant, p.stress_intensity_left,
                  p.stress_intensity_right);
}
inline auto fields(const UnresolvedGap& g) { return std::tie(g.x, g.log10_length); }
inline auto fields(const PossiblePoint& p) { return std::tie(p.x, p.kind, p.side, p.exponent, p.symbolic); }
inline auto fields(const SurfaceSample& s) {
  return std::tie(s.traction, s.shear, s.gap, s.slope, s.displacement, s.shear_slope, s.cumulative_load);
}
inline auto fields(const Residuals& r) { return std::tie(r.equation, r.load, r.penetration, r.tension); }
inline auto fields(const EstimatedError& e) { return std::tie(e.ends, e.traction, e.resultants); }
inline auto fields(const Displacement& d) { return std::tie(d.x, d.z); }
inline auto fields(const InterfaceStress& s) { return std::tie(s.depth, s.shear, s.shear_x, s.tension, s.tension_x); }
inline auto fields(const LargestStress& s) { return std::tie(s.depth, s.von_mises, s.x, s.z, s.unbounded_at); }
inline auto fields(const NodalForce& f) { return std::tie(f.normal, f.tangential); }
inline auto fields(const Proof& p) { return std::tie(p.proved, p.reason, p.certificate, p.unresolved_gaps); }
namespace answer {
inline auto fields(const Quantity& q) { return std::tie(q.type, q.key, q.unit, q.meaning); }
}  // namespace answer

}  // namespace steadyslide

namespace pybind11::detail {

template <class Result>
requires requires(const Result& result) { fields(result); }
struct type_caster<Result> {
  PYBIND11_TYPE_CASTER(Result, const_name("tuple"));
  static handle cast(const Result& result, return_value_policy, handle) {
    return std::apply([](const auto&... field) { return py::make_tuple(field...); }, fields(result)).release();
  }
};

}  // namespace pybind11::detail

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Released = py::call_guard<py::gil_scoped_release>;

template <class Work>
auto released(Work work) {
  const py::gil_scoped_release release;
  return work();
}

std::span<const double> span_of(const Array& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }

Array array_of(const std::vector<double>& values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Defines the function `name`, for many places in double, and "each_NAME", for exact places.
struct OfPlaces {
  const char* name;
  std::vector<double> (ss::Solution::*many)(std::span<const double>) const;
  ss::Number (ss::Solution::*one)(const ss::Exact&) const;
};
constexpr OfPlaces of_places[] = {{"traction", &ss::Solution::traction, &ss::Solution::traction},
                                  {"shear", &ss::Solution::shear, &ss::Solution::shear},
                                  {"gap", &ss::Solution::gap, &ss::Solution::gap},
                                  {"slope", &ss::Solution::slope, &ss::Solution::slope}};

void define(py::class_<ss::Solution>& solution, const OfPlaces& of) {
  solution.def(of.name, [many = of.many](const ss::Solution& s, const Array& x) {
    const std::span<const double> places = span_of(x);
    return array_of(released([&] { return (s.*many)(places); }));
  });
  const auto each = [one = of.one](const ss::Solution& s, const std::vector<std::string>& x) {
    std::vector<ss::Number> values;
    values.reserve(x.size());
    for (const std::string& place : x) values.push_back((s.*one)(place));
    return values;
  };
  solution.def(("each_" + std::string(of.name)).c_str(), each, Released());
}

/// Returns the values of the quantities, in the order of their table.
py::list resultants(const ss::Solution& solution) {
  py::list list;
  const ss::Resultants found = released([&] { return solution.resultants(); });
  ss::answer::for_each_quantity(found, [&](const auto&, const auto& value) { list.append(value); });
  return list;
}

std::array<std::optional<ss::Number>, 11> components(const ss::Stress& s) {
  return {s.xx, s.zz, s.xz, s.yy, s.mean, s.von_mises, s.largest_shear, s.ux_x, s.ux_z, s.uz_x, s.uz_z};
}

/// Returns values and errors of each stress component; None if there is none.
py::list stresses(const ss::Solution& solution, const Array& x, const Array& z) {
  const auto places = span_of(x), depths = span_of(z);
  const std::vector<ss::Stress> states = released([&] { return solution.stress(places, depths); });
  py::list list;
  for (std::size_t k = 0; k < components({}).size(); ++k) {
    if (!states.empty() && !components(states.front())[k]) {
      list.append(py::none());
      continue;
    }
    std::vector<double> values;
    std::vector<double> errors;
    for (const ss::Stress& state : states) {
      const ss::Number number = *components(state)[k];
      values.push_back(number.value);
      errors.push_back(number.error);
    }
    list.append(py::make_tuple(array_of(values), array_of(errors)));
  }
  return list;
}

std::vector<std::string> texts_of(const std::vector<ss::Exact>& numbers) {
  std::vector<std::string> texts;
  for (const ss::Exact& number : numbers) texts.push_back(number.text());
  return texts;
}

using RowAndProfiles = std::function<void(const ss::WearRow&, const std::vector<double>&, const std::vector<double>&)>;

py::tuple row_of(const ss::WearRow& r) {
  return py::make_tuple(r.distance, r.left, r.right, r.zones, r.effective_friction, r.centre_of_pressure, r.tilt,
                        r.largest_pressure, r.wear_rate, r.wear_volume, r.from_run_in, r.step_error);
}

/// Returns the rows and the arrays of a run of wear. `callback` is None, or called after each step.
py::tuple wear(const ss::Problem& problem, const std::string& distance, std::optional<int> steps,
               std::optional<double> accuracy, std::optional<double> until, std::optional<int> cells,
               const py::object& callback) {
  RowAndProfiles after_step;
  if (!callback.is_none()) {
    after_step = [&](const ss::WearRow& row, const std::vector<double>& pressure, const std::vector<double>& depth) {
      const py::gil_scoped_acquire held;
      callback(row_of(row), array_of(pressure), array_of(depth));
    };
  }
  const ss::WearHistory history = released([&] {
    return ss::wear(problem, {distance, steps, accuracy, until, cells}, after_step);
  });
  py::list rows;
  for (const ss::WearRow& row : history.rows) rows.append(row_of(row));
  return py::make_tuple(rows, array_of(history.edges), array_of(history.pressure), array_of(history.depth),
                        array_of(history.run_in_pressure), history.failed_condition);
}

py::bytes picture_of(const ss::Solution& solution, const std::string& kind) {
  const ss::Solution::State& state = data_of(solution);
  return released([&] {
    return ss::picture(data_of(solution.problem()).problem, state.solution(), state.digits, state.failed_condition,
                       kind);
  });
}

ss::Problem read_file(const std::string& file) {
  try {
    return released([&] { return ss::read_problem(file); });
  } catch (const std::system_error& error) {
    // Raises the error of Python's own open(): a FileNotFoundError, PermissionError, ... with errno, strerror and
    // filename.
    errno = error.code().value();
    PyErr_SetFromErrnoWithFilename(PyExc_OSError, file.c_str());
    throw py::error_already_set();
  }
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.attr("__version__") = ss::version();
  m.attr("quantities") = std::vector(std::begin(ss::answer::quantities), std::end(ss::answer::quantities));
  py::register_exception<ss::InvalidData>(m, "InvalidData", PyExc_ValueError);

  py::class_<ss::Problem>(m, "Problem")
      .def_static("read", &read_file)
      .def_static("from_text", &ss::Problem::from_text, Released())
      .def_property_readonly("text", &ss::Problem::text)
      .def_property_readonly("name", &ss::Problem::name)
      .def_property_readonly("load", [](const ss::Problem& p) { return p.load().text(); })
      .def_property_readonly("friction", [](const ss::Problem& p) { return texts_of(p.friction()); })
      .def_property_readonly("jumps", [](const ss::Problem& p) { return texts_of(p.jumps()); })
      .def_property_readonly("support", [](const ss::Problem& p) {
        const auto [left, right] = p.support();
        return texts_of({left, right});
      });
  m.def("exponents", &ss::exponents, Released());
  m.def("derivation", &ss::derivation, Released());
  const auto solve = [](const ss::Problem& problem, int digits, const std::string& method, std::optional<int> cells,
                        std::optional<int> iterations, std::optional<double> accuracy,
                        const std::optional<std::string>& over, const ss::Solution* start) {
    const auto window = over ? std::optional<ss::Exact>(*over) : std::nullopt;
    return ss::solve(problem, {digits, method, cells, iterations, accuracy, window}, start);
  };

  py::class_<ss::Solution> solution(m, "Solution");
  solution.def_property_readonly("failed_condition", &ss::Solution::failed_condition)
      .def_property_readonly("method", &ss::Solution::method)
      .def("warnings", &ss::Solution::warnings, Released())
      .def("contact", &ss::Solution::contact, Released())
      .def("singular_points", &ss::Solution::singular_points, Released())
      .def("unresolved_gaps", &ss::Solution::unresolved_gaps, Released())
      .def("residuals", &ss::Solution::residuals, Released())
      .def("estimated_error", &ss::Solution::estimated_error, Released())
      .def("resultants", &resultants)
      .def(
          "at", [](const ss::Solution& s, const std::string& x) { return s.at(x); }, Released())
      .def("stresses", &stresses)
      .def(
          "stress",
          [](const ss::Solution& s, const std::string& x, const std::string& z) {
            return components(s.stress(ss::Exact(x), ss::Exact(z)));
          },
          Released())
      .def(
          "displacement",
          [](const ss::Solution& s, const std::string& x, const std::string& z) { return s.displacement(x, z); },
          Released())
      .def(
          "max_stress",
          [](const ss::Solution& s, const std::optional<std::string>& depth, const std::optional<std::string>& over) {
            const auto exact = [](const auto& text) { return text ? std::optional<ss::Exact>(*text) : std::nullopt; };
            return s.max_stress(exact(depth), exact(over));
          },
          Released())
      .def("interface_stress", &ss::Solution::interface_stress, Released())
      .def("picture", &picture_of)
      .def(
          "nodal_forces",
          [](const ss::Solution& s, const std::vector<std::string>& nodes, int order) {
            return s.nodal_forces({{nodes.begin(), nodes.end()}, order});
          },
          Released())
      .def("certify", &ss::Solution::certify, Released());
  for (const OfPlaces& of : of_places) define(solution, of);
  m.def("solve", solve, Released());
  m.def("wear", &wear);
}
