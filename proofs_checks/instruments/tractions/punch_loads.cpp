#include "proofs_checks/instruments/tractions/punch_loads.hpp"

#include <stdexcept>

#include "numeric/closed_form/closed_form.hpp"

namespace steadyslide::proofs_checks {

template <Real R>
PunchLoads<R> punch_loads(const ContactProblem& punch) {
  const auto data = numeric::closed_form_data<R>(punch);
  const auto* form = std::get_if<numeric::ClosedFormData<R>>(&data);
  if (!form || form->ends != SingularKind::edge) throw std::logic_error("no flat punch in full contact");
  PunchLoads<R> loads{{}, 0, 0};
  R total = 0;
  for (PanelDensity<R> panel : form->traction.density()) {
    loads.share.push_back(-tanh_sinh::panel_integral(panel).value);
    total += loads.share.back();
    panel.smooth = [smooth = panel.smooth](const Node<R>& node) { return R(node.x * smooth(node)); };
    loads.centre -= tanh_sinh::panel_integral(panel).value;
  }
  loads.centre = to_real<R>(form->origin) + loads.centre / total;
  for (std::size_t k = 0; k < loads.share.size(); ++k) {
    loads.share[k] /= total;
    loads.friction += to_real<R>(punch.friction().values()[k]) * loads.share[k];
  }
  return loads;
}

template PunchLoads<double> punch_loads(const ContactProblem&);
template PunchLoads<Real50> punch_loads(const ContactProblem&);
template PunchLoads<Real100> punch_loads(const ContactProblem&);

}  // namespace steadyslide::proofs_checks
