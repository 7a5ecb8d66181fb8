#include "symbolic/statements/statements.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/coupling.hpp"
#include "symbolic/statements/written_statements.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view elasticity_txt, equation_txt, hilbert_txt;
}

std::vector<DecidedStatement> elasticity_statements() {
  using Arguments = std::vector<GiNaC::ex>;
  WrittenFunctions functions{
      {"mu", [](const Arguments& a) { return kolosov_solid(a[0], a[1], Plane::strain).mu; }},
      {"compliance",
       [](const Arguments& a) {
         return compliance(KolosovSolid{a[0], a[1]});
       }},
      {"dundurs",
       [](const Arguments& a) {
         return dundurs_constant({a[0], a[1]}, {a[2], a[3]});
       }},
      {"limit", [](const Arguments& a) { return limit_at_infinity(a[0], GiNaC::ex_to<GiNaC::symbol>(a[1])); }}};
  for (const auto& [name, plane] : {std::pair("_strain", Plane::strain), {"_stress", Plane::stress}}) {
    functions["gamma" + std::string(name)] = [=](const Arguments& a) { return coupling_constant(a[0], plane); };
    functions["kappa" + std::string(name)] = [=](const Arguments& a) { return kolosov_solid(a[0], 1, plane).kappa; };
    functions["compliance" + std::string(name)] = [=](const Arguments& a) { return compliance(a[0], a[1], plane); };
  }
  return written_statements(embedded::elasticity_txt, {}, functions);
}

std::vector<DecidedStatement> equation_statements() { return written_statements(embedded::equation_txt); }

std::vector<DecidedStatement> hilbert_statements() { return written_statements(embedded::hilbert_txt); }

}  // namespace steadyslide::symbolic
