#include "proofs_checks/kit/run.hpp"

#include <fnmatch.h>

#include <chrono>
#include <exception>
#include <optional>

#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct Outcome {
  std::vector<Evidence> evidence;
  std::string failure;  ///< an exception's message
};

Outcome examine(const Examination& examination, const Context& context) {
  try {
    return {examination(context), {}};
  } catch (const std::exception& e) {
    return {{}, std::string("the check failed: ") + e.what()};
  } catch (...) {
    return {{}, "the check failed: unknown exception"};
  }
}

std::optional<ControlReport> refuted(const Control& control, const Outcome& outcome) {
  for (const Evidence& e : outcome.evidence) {
    if (refutes(e)) return ControlReport{control.name, true, describe(e)};
  }
  return std::nullopt;
}

/// Examines a control. A quick run first examines it in double, where most wrong variants fail already: a variant that
/// a check refutes to 1e-12 needs no more digits.
ControlReport run(const Control& control, const Context& context) {
  if (context.quick && context.digits != numeric::Digits::sixteen) {
    const Context in_double{numeric::Digits::sixteen, context.seed, true};
    if (auto report = refuted(control, examine(control.examine, in_double))) return *report;
  }
  const Outcome outcome = examine(control.examine, context);
  if (auto report = refuted(control, outcome)) return *report;
  if (!outcome.failure.empty()) return {control.name, false, outcome.failure};
  return {control.name, false, outcome.evidence.empty() ? "no evidence" : describe(outcome.evidence.front())};
}

}  // namespace

std::size_t Report::controls_refuted() const {
  return static_cast<std::size_t>(std::ranges::count_if(controls, &ControlReport::refuted));
}

const CheckedProof* Report::proof() const {
  for (const Evidence& e : evidence) {
    if (const auto* proof = std::get_if<CheckedProof>(&e)) return proof;
  }
  return nullptr;
}

bool Report::beyond_calculation() const {
  return verdict == Verdict::undecided &&
         std::ranges::any_of(evidence, [](const Evidence& e) { return std::holds_alternative<BeyondCalculation>(e); });
}

Report run(const Claim& claim, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome = examine(claim.examine, context);
  Report report{claim, Verdict::undecided, std::move(outcome.evidence), std::move(outcome.failure), {}, 0};
  for (const Control& control : claim.controls) report.controls.push_back(run(control, context));

  const bool checked = !claim.controls.empty() && report.controls_refuted() == report.controls.size();
  report.verdict = weigh(report.evidence, checked);
  if (claim.controls.empty() && !report.beyond_calculation()) report.note += "not checked: the claim has no controls";
  for (const ControlReport& control : report.controls) {
    if (control.refuted) continue;
    report.note += (report.note.empty() ? "" : "; ") +
                   ("not checked: the control survives: " + symbolic::without_marks(control.name));
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

bool matches_glob(const std::string& text, const std::string& pattern) {
  return fnmatch(pattern.c_str(), text.c_str(), FNM_NOESCAPE) == 0;
}

std::vector<Report> run_all(std::span<const Claim> claims, const Context& context, const Progress& progress) {
  std::vector<Report> reports;
  for (const Claim& claim : claims) {
    if (progress) progress(reports.size(), claims.size(), claim);
    reports.push_back(run(claim, context));
  }
  return reports;
}

Claim words_alone(std::string_view id) { return {claim_text(id), {}, {}}; }

Claim beyond_calculation(std::string_view id) {
  Claim claim{claim_text(id), {}, {}};
  claim.examine = [why = BeyondCalculation{claim.beyond_calculation, claim.checked_in_its_place}](const Context&) {
    return std::vector<Evidence>{why};
  };
  return claim;
}

bool settled(std::span<const Report> reports) {
  return std::ranges::all_of(reports, [](const Report& r) {
    return r.verdict == Verdict::proved || r.verdict == Verdict::supported || r.beyond_calculation();
  });
}

std::vector<std::pair<std::string_view, std::size_t>> count(std::span<const Report> reports) {
  std::vector<std::pair<std::string_view, std::size_t>> counts;
  for (const Verdict verdict : {Verdict::proved, Verdict::supported, Verdict::undecided, Verdict::refuted}) {
    counts.emplace_back(name_of(verdict), std::ranges::count(reports, verdict, &Report::verdict));
  }
  return counts;
}

ProofRules rules_of(std::span<const Report> reports) {
  ProofRules rules;
  for (const Report& report : reports) {
    const CheckedProof* proof = report.proof();
    if (!proof) continue;
    rules.run.insert(proof->rules_run.begin(), proof->rules_run.end());
    rules.in_words.insert(proof->rules_in_words.begin(), proof->rules_in_words.end());
  }
  return rules;
}

std::string rules_line(std::span<const Report> reports) {
  const ProofRules rules = rules_of(reports);
  return std::to_string(rules.run.size()) + " run on instances, " + std::to_string(rules.in_words.size()) + " in words";
}

std::string counts_line(std::span<const Report> reports) {
  std::string line;
  for (const auto& [verdict, n] : count(reports)) {
    line += (line.empty() ? "" : ", ") + std::to_string(n) + " " + std::string(verdict);
  }
  return line;
}

}  // namespace steadyslide::proofs_checks
