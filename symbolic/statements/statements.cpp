#include "symbolic/statements/statements.hpp"

#include "symbolic/cln/layer_formulas.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/coupling.hpp"
#include "symbolic/statements/written_statements.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view elasticity_txt, energy_txt, equation_txt, hilbert_txt, uniqueness_txt;
}

std::vector<DecidedStatement> elasticity_statements() {
  using Arguments = std::vector<GiNaC::ex>;
  WrittenFunctions functions{
      {"mu", {2, [](const Arguments& a) { return kolosov_solid(a[0], a[1], Plane::strain).mu; }}},
      {"compliance",
       {2,
        [](const Arguments& a) {
          return compliance(KolosovSolid{a[0], a[1]});
        }}},
      {"dundurs",
       {4,
        [](const Arguments& a) {
          return dundurs_constant({a[0], a[1]}, {a[2], a[3]});
        }}},
      {"limit", {2, [](const Arguments& a) { return limit_at_infinity(a[0], GiNaC::ex_to<GiNaC::symbol>(a[1])); }}}};
  const auto add = [&](const std::string& name, std::size_t arguments, const auto& value) {
    functions.emplace(name, WrittenFunction{arguments, value});
  };
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const std::string name = plane == Plane::strain ? "_strain" : "_stress";
    add("gamma" + name, 1, [=](const Arguments& a) { return coupling_constant(a[0], plane); });
    add("kappa" + name, 1, [=](const Arguments& a) { return kolosov_solid(a[0], 1, plane).kappa; });
    add("compliance" + name, 2, [=](const Arguments& a) { return compliance(a[0], a[1], plane); });
  }
  return written_statements(embedded::elasticity_txt, {}, functions);
}

std::vector<DecidedStatement> equation_statements() {
  using Arguments = std::vector<GiNaC::ex>;
  const auto bonded = [](const Arguments& a) { return bonded_layer(a[0], a[1], a[2], a[3]); };
  const auto slipping = [](const Arguments& a) { return slipping_layer(a[0], a[1], a[2]); };
  return written_statements(embedded::equation_txt, {},
                            {{"bonded_W", {4, [=](const Arguments& a) { return bonded(a).normal; }}},
                             {"bonded_defect", {4, [=](const Arguments& a) { return bonded(a).coupling_defect; }}},
                             {"slip_W", {3, [=](const Arguments& a) { return slipping(a).normal; }}},
                             {"slip_defect", {3, [=](const Arguments& a) { return slipping(a).coupling_defect; }}}});
}

std::vector<DecidedStatement> energy_statements() { return written_statements(embedded::energy_txt); }

std::vector<DecidedStatement> uniqueness_statements() { return written_statements(embedded::uniqueness_txt); }

std::vector<DecidedStatement> hilbert_statements() { return written_statements(embedded::hilbert_txt); }

}  // namespace steadyslide::symbolic
