#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"

#include <map>
#include <stdexcept>

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

bool contact_on_left(PointKind kind) { return kind != PointKind::left_edge && kind != PointKind::left_free; }
bool contact_on_right(PointKind kind) { return kind != PointKind::right_edge && kind != PointKind::right_free; }

AngleForm solve_exponent(PointKind kind) {
  const PhaseField field({GiNaC::symbol("s_l"), GiNaC::symbol("s_r")});
  std::vector<AngleForm> found;
  for (int halves = -2; halves <= 2; ++halves) {
    for (int l = -1; l <= 1; ++l) {
      for (int r = -1; r <= 1; ++r) {
        const AngleForm form(halves, {{0, l}, {1, r}});
        if (!is_admissible(kind, form)) continue;
        Comparison crossing(field);
        compare_crossing(crossing, field, kind, form);
        if (crossing.holds()) found.push_back(form);
      }
    }
  }
  if (found.size() != 1) throw std::logic_error("derived exponent: exactly one form fits");
  return found[0];
}

}  // namespace

JumpRelation jump_relation(const ex& s, const ex& h, const ex& d) {
  const GiNaC::symbol plus("Phi_plus");
  const GiNaC::symbol minus("Phi_minus");
  const ex action = (h * (plus + minus) + s * d * (plus - minus)).expand();
  return {-action.coeff(minus) / action.coeff(plus), 1 / action.coeff(plus)};
}

ex expression(const AngleForm& form, const std::vector<ex>& alphas) {
  ex sum = ex(form.halves()) / 2;
  for (const auto& [k, factor] : form.times()) sum += factor * alphas.at(k);
  return sum;
}

bool is_free(PointKind kind) { return kind == PointKind::left_free || kind == PointKind::right_free; }

bool is_admissible(PointKind kind, const AngleForm& form) {
  if (kind == PointKind::jump) {
    int sum = 0;
    for (const auto& [k, factor] : form.times()) sum += factor;
    return form.halves() == 0 && sum == 0;
  }
  const auto [low, high] = form.twice_bounds();
  return is_free(kind) ? low >= 0 && high <= 2 : low >= -2 && high <= 0;
}

void compare_crossing(Comparison& comparison, const PhaseField& field, PointKind kind, const AngleForm& form) {
  const auto quotient = [&](bool contact, std::size_t k) {
    return contact ? jump_relation(field.friction(k).s, field.i()).ratio : ex(1);
  };
  comparison.equal("Y+/Y- left of the point", field.phase(form, 2) * quotient(contact_on_right(kind), 1),
                   quotient(contact_on_left(kind), 0));
}

AngleForm derived_exponent(PointKind kind) {
  // Computed once. The forms contain no GiNaC objects.
  static std::map<PointKind, AngleForm> known;
  const auto place = known.find(kind);
  return place != known.end() ? place->second : known.emplace(kind, solve_exponent(kind)).first->second;
}

FundamentalSolution::FundamentalSolution(std::vector<Component> components) : components_(std::move(components)) {
  std::size_t panel = 0;
  const auto add = [&](PointKind kind, std::size_t left, std::size_t right) {
    points_.push_back({kind, derived_exponent(kind).renamed({left, right})});
  };
  for (const Component& c : components_) {
    if (c.panels == 0) throw std::domain_error("contact: a component has at least one panel");
    add(c.left == EndKind::edge ? PointKind::left_edge : PointKind::left_free, panel, panel);
    for (std::size_t k = 1; k < c.panels; ++k, ++panel) add(PointKind::jump, panel, panel + 1);
    add(c.right == EndKind::edge ? PointKind::right_edge : PointKind::right_free, panel, panel);
    ++panel;
  }
  if (components_.empty()) throw std::domain_error("contact: at least one component");
  make_regions();
}

FundamentalSolution FundamentalSolution::with_powers(const std::vector<AngleForm>& powers) const {
  FundamentalSolution other = *this;
  for (std::size_t j = 0; j < points_.size(); ++j) other.points_[j].power = powers.at(j);
  other.make_regions();
  return other;
}

void FundamentalSolution::make_regions() {
  regions_.assign(points_.size() + 1, {std::nullopt, components_.size(), AngleForm()});
  std::size_t panel = panels();
  std::size_t component = components_.size();
  for (std::size_t j = points_.size(); j-- > 0;) {
    if (!contact_on_right(points_[j].kind)) --component;
    Region& region = regions_[j];
    region.sigma = regions_[j + 1].sigma + points_[j].power;
    region.component = component;
    if (contact_on_left(points_[j].kind)) region.friction = --panel;
  }
}

std::size_t FundamentalSolution::panels() const {
  std::size_t sum = 0;
  for (const Component& c : components_) sum += c.panels;
  return sum;
}

int FundamentalSolution::free_ends() const {
  int count = 0;
  for (const Point& point : points_) count += is_free(point.kind);
  return count;
}

int FundamentalSolution::order() const {
  if (!power_sum().is_integer()) throw std::domain_error("fundamental solution: the exponents sum to an integer");
  return power_sum().halves() / 2;
}

int FundamentalSolution::sign_on(const PhaseField& field, const Region& region) const {
  const PhaseField::Friction& f = field.friction(region.friction.value());
  const ex value = (f.s + field.i()) * field.phase(region.sigma, 1) * f.cos;
  for (const int sign : {1, -1}) {
    if (field.are_equal(value, sign).holds) return sign;
  }
  throw std::domain_error("fundamental solution: (s+i) Y+ is real on the contact");
}

void FundamentalSolution::compare(Comparison& comparison, const PhaseField& field) const {
  for (std::size_t j = 0; j < regions_.size(); ++j) {
    const Region& region = regions_[j];
    const std::string name =
        region.friction ? "panel " + std::to_string(*region.friction) : "off contact " + std::to_string(j);
    comparison.equal(name + ": Y+/Y-", field.phase(region.sigma, 2),
                     region.friction ? jump_relation(field.friction(*region.friction).s, field.i()).ratio : ex(1));
  }
}

}  // namespace steadyslide::symbolic
