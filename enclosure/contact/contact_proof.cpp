#include "enclosure/contact/contact_proof.hpp"

#include <algorithm>

#include "model/singular_point.hpp"

namespace steadyslide::enclosure {
namespace {

/// Decides the signs. They need few digits, except close to a threshold.
SignsDecided decide(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work) {
  SignsDecided signs;
  const int rounds = problem.load_radius > 0 ? 14 : 40;
  for (const Bits few : {Bits(96), Bits(192), Bits(384)}) {
    const Bits used = std::min(few, rules.bits());
    JacobiRules own(used);
    JacobiRules& chosen = used == rules.bits() ? rules : own;
    const int count = std::min(count_for(used), 16 * static_cast<int>(few / 96));
    signs = decide_signs(box.form(problem, count, chosen), work, rounds);
    if (signs.proved || signs.refuted || work.is_spent() || used == rules.bits()) break;
  }
  return signs;
}

void judge(ContactProof& proof, KrawczykResult zero, JacobiRules& rules, WorkBudget& work) {
  proof.box = std::move(zero.box);
  proof.reason = std::move(zero.reason);
  if (!zero.proved) return;
  const SignsDecided signs = decide(proof.problem, proof.box, rules, work);
  proof.proved = signs.proved;
  proof.refuted = signs.refuted;
  proof.reason = signs.reason;
  proof.intervals = signs.intervals;
  if (!signs.proved) {
    const Frame& frame = proof.problem.frame;
    proof.where = (Ball(frame.origin, 64) + Ball(frame.unit, 64) * signs.x).to_double();
  }
}

/// Returns the number of bits that loads lose beside a friction jump with a power beta near 0, where they are
/// differences of terms of size 1/beta. The spare bits of the digits cover some of them.
Bits lost_bits(const ReducedProblem& problem) {
  constexpr double spare = 24;
  double lost = 0;
  for (std::size_t k = 1; k < problem.intervals.size(); ++k) {
    const Exponent beta = jump_exponent(problem.intervals[k - 1].s, problem.intervals[k].s);
    if (beta.sign() != 0) lost = std::max(lost, -rough_log2(Ball(beta, 64)) - spare);
  }
  return static_cast<Bits>(lost);
}

}  // namespace

Frame frame_of(const ContactProblem& problem, const ApproximateContact& contact) {
  const auto place = [](const ApproximateContact::End& end) -> Rational {
    if (!end.beside) return end.anchor;
    return *end.beside == Side::left ? end.anchor - end.offset : end.anchor + end.offset;
  };
  const Indenter& indenter = problem.indenter();
  const Rational from = contact.ends.empty() ? indenter.left() : place(contact.ends.front());
  const Rational to = contact.ends.empty() ? indenter.right() : place(contact.ends.back());
  Rational unit = 1;
  while (unit < to - from) unit *= 2;
  while (unit > to - from && to > from) unit /= 2;
  // Use a short number near the middle, so that the data stay short.
  const Rational eighths = (from + to) / 2 / unit * 8;
  const Integer whole = numerator(eighths) / denominator(eighths);
  return {Rational(whole) * unit / 8, unit};
}

ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits) {
  WorkBudget work;
  return prove_contact(problem, contact, digits, work);
}

ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits,
                           WorkBudget& work) {
  const ReducedProblem reduced(problem, frame_of(problem, contact));
  const Bits least = bits_for(digits) + lost_bits(reduced);
  ContactProof proof{false, false, {}, {}, reduced, {{}, {}, {}, Ball(0)}, least};
  const ContactStart start(proof.problem, contact);
  if (std::string fault = start.topology.fault(proof.problem); !fault.empty()) {
    proof.reason = std::move(fault);
    return proof;
  }
  for (const int factor : {1, 2, 4}) {
    proof.bits = factor * least;
    JacobiRules rules(proof.bits);
    judge(proof, enclose_zero(proof.problem, start.box(proof.bits), rules, work), rules, work);
    if (proof.proved || proof.refuted || work.is_spent()) break;
  }
  return proof;
}

ContactProof prove_signs(const ReducedProblem& problem, KrawczykResult zero, JacobiRules& rules, WorkBudget& work) {
  ContactProof proof{false, false, {}, {}, problem, {{}, {}, {}, Ball(0)}, rules.bits()};
  judge(proof, std::move(zero), rules, work);
  return proof;
}

ContactProof prove_box(const ReducedProblem& problem, const ContactBox& box, Bits bits) {
  ContactProof proof{false, false, {}, {}, problem, box, bits};
  if (std::string fault = box.topology.fault(problem); !fault.empty()) {
    proof.reason = std::move(fault);
    return proof;
  }
  JacobiRules rules(bits);
  WorkBudget work;
  judge(proof, prove_zero(proof.problem, box, rules, work), rules, work);
  return proof;
}

}  // namespace steadyslide::enclosure
