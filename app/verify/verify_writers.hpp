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
  std::size_t notes_left_out = 0;  ///< number of notes that belong to none of the requested claims
  bool with_proofs = false;        ///< true: write proofs as trees; JSON always has them
};

/// Removes the notes that belong to none of the reported claims, and counts them.
void leave_out_other_notes(VerifyResult& result);

/// Writes the claims with their verdicts, then the reading notes.
void write_verify(Format format, const VerifyResult& result, Output& output);
/// Writes the claims without verdicts.
void write_claims(Format format, std::span<const proofs_checks::Claim> claims, Output& output);

/// Returns "12 of 12 controls refuted".
std::string controls_line(const VerifyResult& result);

/// ExitCode::done only if no claim is refuted, and only claims beyond calculation are undecided.
ExitCode exit_code_of(std::span<const proofs_checks::Report> reports);

}  // namespace steadyslide::app
