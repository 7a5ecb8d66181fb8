#pragma once
// The ledger: every claim with its verdict, to be opened.

#include "app/report/html.hpp"
#include "app/results/verify_writers.hpp"

namespace steadyslide::app {

Section ledger_section(const VerifyResult& result);

/// "3 proved, 2 supported, 0 undecided, 0 refuted".
std::string counts_line(const VerifyResult& result);

/// "12 of 12 controls refuted".
std::string controls_line(const VerifyResult& result);

}  // namespace steadyslide::app
