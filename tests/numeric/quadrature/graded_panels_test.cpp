#include "numeric/quadrature/graded_panels.hpp"
#include "support/numeric_test.hpp"

namespace {

template <Real R>
R random_decades(int low, int high) {
  using std::pow;
  return pow(R(10), R(uniform(low * 8, high * 8)) / 8);
}

template <Real R>
struct Case {
  R length;
  Surroundings<R> around;
};

template <Real R>
Case<R> random_case() {
  const auto beyond = [] { return uniform(0, 4) == 0 ? infinity<R>() : random_decades<R>(-100, 3); };
  return {random_decades<R>(-30, 30), {uniform(0, 1) == 1, uniform(0, 1) == 1, beyond(), beyond()}};
}

/// Returns the fault of these panels; empty if there is none.
template <Real R>
std::string fault(const std::vector<GradedPanel<R>>& panels, const Case<R>& c) {
  if (panels.empty() || panels.front().from_left != 0 || panels.back().from_right != 0) return "ends";
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const GradedPanel<R>& p = panels[k];
    // Distances from both ends are exact up to rounding, even very short ones.
    if (!close(R(p.from_left + p.length + p.from_right), c.length, 4)) return "length";
    if (k + 1 < panels.size()) {
      const GradedPanel<R>& next = panels[k + 1];
      if (!close(R(p.from_left + p.length), next.from_left, 4)) return "left cover";
      if (!close(R(next.from_right + next.length), p.from_right, 4)) return "right cover";
    }
    const bool own_left = c.around.left_singular && k == 0;
    const bool own_right = c.around.right_singular && k + 1 == panels.size();
    if (own_left && own_right) return "two powers";
    if (own_left != (p.singular_end == Side::left) || own_right != (p.singular_end == Side::right)) return "power";
    if (c.around.left_singular && !own_left && p.length > p.from_left) return "left end too near";
    if (c.around.right_singular && !own_right && p.length > p.from_right) return "right end too near";
    if (p.length > p.from_left + c.around.beyond_left) return "left place too near";
    if (p.length > p.from_right + c.around.beyond_right) return "right place too near";
  }
  return "";
}

template <Real R>
double log_ratio(const R& length, const R& distance) {
  using std::log;
  return static_cast<double>(R(log(1 + length / distance))) / std::log(2);
}

}  // namespace

TEST_CASE_TEMPLATE("graded panels keep their distances from singular points, and are few", R, double, Real50) {
  CHECK(rc::check("random surroundings", [] {
    const Case<R> c = random_case<R>();
    const auto panels = graded_panels(c.length, c.around);
    RC_ASSERT(fault(panels, c) == "");
    const double logs = log_ratio(c.length, c.around.beyond_left) + log_ratio(c.length, c.around.beyond_right);
    RC_ASSERT(static_cast<double>(panels.size()) <= logs + 4);
  }));
}

TEST_CASE("control: panels that are too long, too short or without their power are refuted") {
  const Case<double> c{1, {true, false, 1, 1e-3}};
  const auto good = graded_panels(c.length, c.around);
  CHECK(fault(good, c) == "");
  CHECK(fault({{0, 0, 1, Side::left}}, c) != "");
  auto bad = good;
  bad.front().singular_end = std::nullopt;
  CHECK(fault(bad, c) == "power");
  bad = good;
  bad[1].from_left *= 1.0001;
  CHECK(fault(bad, c) != "");
  CHECK(fault(graded_panels(1., {true, false, 1, 1e-2}), c) == "right place too near");
}
