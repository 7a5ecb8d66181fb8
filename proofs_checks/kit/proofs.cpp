#include "proofs_checks/kit/proofs.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "proofs_checks/proof/decided_statements.hpp"
#include "proofs_checks/proof/enclosures.hpp"
#include "proofs_checks/proof/meaning.hpp"
#include "symbolic/field/polynomial_sign.hpp"

namespace steadyslide::proofs_checks {
namespace {

Decision decide_identity(const std::string& id) {
  Decision decision{Truth::yes};
  for (const symbolic::DecidedStatement& statement : decided_statements({id})) {
    const symbolic::ExactIdentity& identity = statement.identity;
    decision.words.push_back(identity.statement);
    decision.decides = parse_facts(statement.decides);
    if (!identity.identical)
      decision = {Truth::no, {identity.statement + ": " + identity.lhs + " and " + identity.rhs}};
    for (const std::string& divisor : identity.nonvanishing) {
      if (!never_vanishes(divisor)) decision.divisors.push_back(divisor);
    }
  }
  return decision;
}

Truth decide_sign(const std::string& polynomial, const Box& box) {
  std::map<std::string, symbolic::ParameterRange> ranges;
  for (const auto& [name, i] : box) ranges[name] = {i.from, i.to, i.with_from, i.with_to};
  return symbolic::is_positive(polynomial, ranges);
}

Decision decide_enclosure(const std::string& id, const Box& box) {
  static std::map<std::pair<std::string, std::string>, Decision> decided;
  const std::pair key(id, text_of(box));
  const auto found = decided.find(key);
  return found != decided.end() ? found->second : decided.emplace(key, enclosure(id).decide(box)).first->second;
}

const Decisions& decisions() {
  static const Decisions all{decide_identity, decide_sign, decide_enclosure,
                             [](const std::string& id) { return proof_of(id); }, &meaning()};
  return all;
}

CheckedProof checked(const ProofText& text) { return check_proof(text, theory(), decisions()); }

using Evidences = std::vector<Evidence>;

/// Returns the control that leaves out one step of the proof. A gap in the shorter proof refutes it.
Control without_step(const ProofText& text, std::size_t k) {
  return {"without the step " + text_of(text.steps[k].fact), [text, k](const Context&) -> Evidences {
            ProofText shorter = text;
            shorter.steps.erase(shorter.steps.begin() + static_cast<std::ptrdiff_t>(k));
            CheckedProof proof = checked(shorter);
            if (proof.complete()) return {std::move(proof)};
            return {Counterexample{"the proof as a whole", proof.gap}};
          }};
}

Control wrong_identity(const std::string& id, const symbolic::ExactIdentity& wrong) {
  return {id + ": " + wrong.statement, [wrong](const Context&) -> Evidences {
            if (wrong.identical) return {ExactIdentity{"not refuted", {wrong.statement}}};
            return {Counterexample{"generic parameters",
                                   "the two sides are different functions, " + wrong.lhs + " and " + wrong.rhs}};
          }};
}

Control wrong_enclosure(const Enclosure::Variant& wrong, const Box& box, const std::string& id) {
  return {id + " for " + text_of(box) + ": " + wrong.name, [wrong, box](const Context&) -> Evidences {
            const Decision decision = wrong.decide(box);
            if (decision.holds != Truth::no) return {ExactIdentity{"not refuted", {wrong.name}}};
            return {Counterexample{text_of(box), wrong.name}};
          }};
}

/// Adds the wrong variants of the identities and enclosures that decide the proof's facts. The wrong variants of the
/// claim's own decided statements are controls already and are not added again.
void add_wrong_decisions(std::vector<Control>& controls, const ClaimText& claim) {
  std::set<std::string> seen;
  for (const Family& family : claim.decided) {
    for (const auto& statement : decided_statements(family.ids)) seen.insert(statement.id);
  }
  for (const ProofStep& step : claim.proof.steps) {
    for (const DecidedFact& decided : theory().decided) {
      if (decided.fact != step.fact) continue;
      if (decided.by == DecidedFact::By::identity && step.kind == ProofStep::Kind::identity) {
        for (const auto& statement : decided_statements(decided.ids)) {
          if (!seen.insert(statement.id).second) continue;
          for (const auto& wrong : statement.controls) controls.push_back(wrong_identity(statement.id, wrong));
        }
      } else if (decided.by == DecidedFact::By::enclosure && step.kind == ProofStep::Kind::enclosure) {
        for (const std::string& id : decided.ids) {
          for (const auto& wrong : enclosure(id).wrong) controls.push_back(wrong_enclosure(wrong, decided.box, id));
        }
      }
    }
  }
}

}  // namespace

const CheckedProof* proof_of(std::string_view id) {
  static std::map<std::string, std::optional<CheckedProof>, std::less<>> proofs;
  static std::set<std::string, std::less<>> under_way;
  if (const auto found = proofs.find(id); found != proofs.end()) return found->second ? &*found->second : nullptr;
  if (!under_way.emplace(id).second) {
    static CheckedProof cycle;
    cycle = {{}, {}, "it rests on itself"};
    return &cycle;
  }
  const ProofText text = claim_text(id).proof;
  std::optional<CheckedProof> proof;
  if (!text.empty()) proof = checked(text);
  under_way.erase(under_way.find(id));
  const auto& kept = proofs.emplace(id, std::move(proof)).first->second;
  return kept ? &*kept : nullptr;
}

Claim with_proof(Claim claim) {
  if (claim.proof.empty()) return claim;
  claim.examine = [id = claim.id, others = std::move(claim.examine)](const Context& context) {
    const CheckedProof& proof = *proof_of(id);
    Evidences all{proof};
    if (!proof.counterexample.empty()) all.push_back(Counterexample{"the proof", proof.counterexample});
    if (others) std::ranges::move(others(context), std::back_inserter(all));
    return all;
  };
  for (std::size_t k = 0; k < claim.proof.steps.size(); ++k) claim.controls.push_back(without_step(claim.proof, k));
  add_wrong_decisions(claim.controls, claim);
  return claim;
}

}  // namespace steadyslide::proofs_checks
