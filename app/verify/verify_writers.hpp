#pragma once
// The output formats of `steadyslide verify`.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/results/rows.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/output.hpp"
#include "proofs_checks/kit/run.hpp"
#include "proofs_checks/statements/reading_notes.hpp"

namespace steadyslide::app {

struct VerifyResult {
  proofs_checks::Context context;
  std::vector<proofs_checks::Report> reports;
  std::vector<proofs_checks::ReadingNote> notes;
  std::size_t notes_left_out = 0;  ///< those that belong to none of the claims asked for
  bool with_proofs = false;        ///< as trees; JSON has them always
};

/// Takes out the notes that belong to none of the claims reported, and counts them.
void leave_out_other_notes(VerifyResult& result);

/// The claims with their verdicts, then the reading notes.
void write_verify(Format format, const VerifyResult& result, Output& output);
/// The claims alone, unchecked.
void write_claims(Format format, std::span<const proofs_checks::Claim> claims, Output& output);

/// "12 of 12 controls refuted".
std::string controls_line(const VerifyResult& result);

/// Done only if nothing is refuted, and nothing undecided but what is beyond calculation.
ExitCode exit_code_of(std::span<const proofs_checks::Report> reports);

}  // namespace steadyslide::app
