// The part of the Python module that calls the library; python/steadyslide/__init__.py is what a user sees. All work is
// done with the interpreter's lock released.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <steadyslide/steadyslide.hpp>

namespace py = pybind11;
namespace ss = steadyslide;

namespace pybind11::detail {

/// (value, error, digits).
template <>
struct type_caster<ss::Number> {
  PYBIND11_TYPE_CASTER(ss::Number, const_name("tuple[float, float, str]"));
  static handle cast(const ss::Number& number, return_value_policy, handle) {
    return py::make_tuple(number.value, number.error, number.digits).release();
  }
};

/// (value, x, exponent).
template <>
struct type_caster<ss::LargestPressure> {
  PYBIND11_TYPE_CASTER(ss::LargestPressure, const_name("tuple"));
  static handle cast(const ss::LargestPressure& largest, return_value_policy, handle) {
    return py::make_tuple(largest.value, largest.x, largest.exponent).release();
  }
};

/// (left, right).
template <>
struct type_caster<ss::Interval> {
  PYBIND11_TYPE_CASTER(ss::Interval, const_name("tuple"));
  static handle cast(const ss::Interval& interval, return_value_policy, handle) {
    return py::make_tuple(interval.left, interval.right).release();
  }
};

}  // namespace pybind11::detail

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Many = std::vector<double> (ss::Solution::*)(std::span<const double>) const;
using One = ss::Number (ss::Solution::*)(const ss::Exact&) const;

template <class Work>
auto released(Work work) {
  const py::gil_scoped_release release;
  return work();
}

std::span<const double> span_of(const Array& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }

Array array_of(const std::vector<double>& values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

Array many(const ss::Solution& solution, const Array& x, Many ask) {
  const std::span<const double> places = span_of(x);
  return array_of(released([&] { return (solution.*ask)(places); }));
}

std::vector<ss::Number> each(const ss::Solution& solution, const std::vector<std::string>& x, One ask) {
  return released([&] {
    std::vector<ss::Number> values;
    values.reserve(x.size());
    for (const std::string& place : x) values.push_back((solution.*ask)(place));
    return values;
  });
}

py::tuple end_tuple(const ss::ContactEnd& end) { return py::make_tuple(end.x, end.kind, end.exponent, end.intensity); }

py::list contact(const ss::Solution& solution) {
  py::list list;
  for (const auto& [left, right, width, load] : released([&] { return solution.contact(); })) {
    list.append(py::make_tuple(end_tuple(left), end_tuple(right), width, load));
  }
  return list;
}

py::list singular_points(const ss::Solution& solution) {
  py::list list;
  for (const ss::SolvedPoint& p : released([&] { return solution.singular_points(); })) {
    list.append(py::make_tuple(p.x, p.kind, p.exponent, p.symbolic, p.intensity, p.constant, p.stress_intensity_left,
                               p.stress_intensity_right));
  }
  return list;
}

py::list gap_tuples(const std::vector<ss::UnresolvedGap>& gaps) {
  py::list list;
  for (const auto& [x, log10_length] : gaps) list.append(py::make_tuple(x, log10_length));
  return list;
}

/// Type, key, unit and meaning of each quantity of the table.
py::list quantities() {
  py::list list;
  for (const auto& [type, key, unit, line, meaning] : ss::answer::quantities) {
    list.append(py::make_tuple(type, key, unit, meaning));
  }
  return list;
}

/// Their values, in the same order.
py::list resultants(const ss::Solution& solution) {
  py::list list;
  const ss::Resultants found = released([&] { return solution.resultants(); });
  ss::answer::for_each_quantity(found, [&](const auto&, const auto& value) { list.append(value); });
  return list;
}

py::tuple sample(const ss::Solution& solution, const std::string& x) {
  const ss::SurfaceSample s = released([&] { return solution.at(x); });
  const auto limits = [](const ss::Limits& both) { return py::make_tuple(both.left, both.right); };
  return py::make_tuple(limits(s.traction), limits(s.shear), s.gap, limits(s.slope), s.displacement,
                        limits(s.shear_slope), s.cumulative_load);
}

using Component = std::optional<ss::Number> (*)(const ss::Stress&);
constexpr Component stress_components[] = {
    [](const ss::Stress& s) { return std::optional(s.xx); },
    [](const ss::Stress& s) { return std::optional(s.zz); },
    [](const ss::Stress& s) { return std::optional(s.xz); },
    [](const ss::Stress& s) { return s.yy; },
    [](const ss::Stress& s) { return s.mean; },
    [](const ss::Stress& s) { return s.von_mises; },
    [](const ss::Stress& s) { return std::optional(s.largest_shear); },
    [](const ss::Stress& s) { return s.ux_x; },
    [](const ss::Stress& s) { return s.ux_z; },
    [](const ss::Stress& s) { return s.uz_x; },
    [](const ss::Stress& s) { return s.uz_z; },
};

/// Values and errors of each component; None where there is none.
py::list stresses(const ss::Solution& solution, const Array& x, const Array& z) {
  const auto [places, depths] = std::pair(span_of(x), span_of(z));
  const std::vector<ss::Stress> states = released([&] { return solution.stress(places, depths); });
  py::list list;
  for (const Component component : stress_components) {
    if (!states.empty() && !component(states.front())) {
      list.append(py::none());
      continue;
    }
    std::vector<double> values;
    std::vector<double> errors;
    for (const ss::Stress& state : states) {
      const ss::Number number = *component(state);
      values.push_back(number.value);
      errors.push_back(number.error);
    }
    list.append(py::make_tuple(array_of(values), array_of(errors)));
  }
  return list;
}

py::list stress(const ss::Solution& solution, const std::string& x, const std::string& z) {
  const ss::Stress state = released([&] { return solution.stress(ss::Exact(x), ss::Exact(z)); });
  py::list list;
  for (const Component component : stress_components) list.append(component(state));
  return list;
}

py::list nodal_forces(const ss::Solution& solution, const std::vector<std::string>& nodes, int order) {
  py::list list;
  const ss::Mesh mesh{{nodes.begin(), nodes.end()}, order};
  for (const auto& [normal, tangential] : released([&] { return solution.nodal_forces(mesh); })) {
    list.append(py::make_tuple(normal, tangential));
  }
  return list;
}

py::list exponents(const ss::Problem& problem, int digits) {
  py::list list;
  for (const auto& [x, kind, side, exponent, symbolic] : ss::exponents(problem, digits)) {
    list.append(py::make_tuple(x, kind, side, exponent, symbolic));
  }
  return list;
}

ss::Problem read_file(const std::string& file) {
  try {
    return released([&] { return ss::read_problem(file); });
  } catch (const std::system_error& error) {
    // As Python's own open() does it: a FileNotFoundError, PermissionError, ... with errno, strerror and filename.
    errno = error.code().value();
    PyErr_SetFromErrnoWithFilename(PyExc_OSError, file.c_str());
    throw py::error_already_set();
  }
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.attr("__version__") = ss::version();
  m.attr("quantities") = quantities();
  py::register_exception<ss::InvalidData>(m, "InvalidData", PyExc_ValueError);

  py::class_<ss::Problem>(m, "Problem")
      .def_static("read", &read_file)
      .def_static("from_text",
                  [](const std::string& text, const std::string& name) {
                    return released([&] { return ss::Problem::from_text(text, name); });
                  })
      .def_property_readonly("text", &ss::Problem::text)
      .def_property_readonly("name", &ss::Problem::name);
  m.def("exponents", &exponents);
  m.def("derivation", [](const ss::Problem& problem) { return released([&] { return ss::derivation(problem); }); });
  m.def("solve", [](const ss::Problem& problem, int digits, const std::string& method, std::optional<int> cells) {
    return released([&] { return ss::solve(problem, {digits, method, cells}); });
  });

  py::class_<ss::Proof>(m, "Proof")
      .def_readonly("proved", &ss::Proof::proved)
      .def_readonly("reason", &ss::Proof::reason)
      .def_readonly("certificate", &ss::Proof::certificate)
      .def("unresolved_gaps", [](const ss::Proof& proof) { return gap_tuples(proof.unresolved_gaps); });

  py::class_<ss::Solution>(m, "Solution")
      .def_property_readonly("failed_condition", &ss::Solution::failed_condition)
      .def_property_readonly("method", &ss::Solution::method)
      .def("warnings", [](const ss::Solution& s) { return released([&] { return s.warnings(); }); })
      .def("contact", &contact)
      .def("singular_points", &singular_points)
      .def("unresolved_gaps",
           [](const ss::Solution& s) { return gap_tuples(released([&] { return s.unresolved_gaps(); })); })
      .def("resultants", &resultants)
      .def("at", &sample)
      .def("traction", [](const ss::Solution& s, const Array& x) { return many(s, x, &ss::Solution::traction); })
      .def("shear", [](const ss::Solution& s, const Array& x) { return many(s, x, &ss::Solution::shear); })
      .def("gap", [](const ss::Solution& s, const Array& x) { return many(s, x, &ss::Solution::gap); })
      .def("slope", [](const ss::Solution& s, const Array& x) { return many(s, x, &ss::Solution::slope); })
      .def("each_traction",
           [](const ss::Solution& s, const std::vector<std::string>& x) { return each(s, x, &ss::Solution::traction); })
      .def("each_shear",
           [](const ss::Solution& s, const std::vector<std::string>& x) { return each(s, x, &ss::Solution::shear); })
      .def("each_gap",
           [](const ss::Solution& s, const std::vector<std::string>& x) { return each(s, x, &ss::Solution::gap); })
      .def("each_slope",
           [](const ss::Solution& s, const std::vector<std::string>& x) { return each(s, x, &ss::Solution::slope); })
      .def("stresses", &stresses)
      .def("stress", &stress)
      .def("nodal_forces", &nodal_forces)
      .def("certify", [](const ss::Solution& s) { return released([&] { return s.certify(); }); });
}
