#include "proofs_checks/kit/transport.hpp"

#include "proofs_checks/kit/archive.hpp"

namespace steadyslide::proofs_checks {

// What a report consists of.

template <class Archive>
static void pass(Archive& archive, ExactIdentity& e) {
  archive(e.detail, e.identities);
}
template <class Archive>
static void pass(Archive& archive, Agreement& e) {
  archive(e.what, e.routes, e.worst, e.tolerance, e.cases, e.effective, e.required, e.detail);
}
template <class Archive>
static void pass(Archive& archive, ConvergenceRate& e) {
  archive(e.what, e.measured, e.error_bar, e.expected, e.tolerance, e.detail);
}
template <class Archive>
static void pass(Archive& archive, Counterexample& e) {
  archive(e.where, e.detail);
}
template <class Archive>
static void pass(Archive& archive, BeyondCalculation& e) {
  archive(e.reason, e.consequences);
}
template <class Archive>
static void pass(Archive& archive, ProofNode& node) {
  archive(node.fact.word, node.fact.things, node.by, node.words, node.from);
}
/// The text of the proof is the claim's.
template <class Archive>
static void pass(Archive& archive, CheckedProof& e) {
  archive(e.nodes, e.gap);
}
template <class Archive>
static void pass(Archive& archive, ControlReport& control) {
  archive(control.name, control.refuted, control.detail);
}
template <class Archive>
static void pass(Archive& archive, Report& report) {
  archive(report.verdict, report.evidence, report.note, report.controls, report.seconds);
}

std::string to_bytes(const Report& report) { return archived(report); }

Report report_from(std::string_view bytes, const Claim& claim) {
  Report report{claim, Verdict::undecided, {}, {}, {}, 0};
  unarchive(bytes, report);
  for (Evidence& e : report.evidence) {
    if (auto* proof = std::get_if<CheckedProof>(&e)) proof->text = claim.proof;
  }
  return report;
}

}  // namespace steadyslide::proofs_checks
