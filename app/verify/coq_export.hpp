#pragma once
// `steadyslide verify --export-coq DIR`: writes the decisions of the symbolic layer for an independent proof checker
// (docs/proofs.md).

#include <string>

namespace steadyslide::app {

/// Writes a file for each family of statements into a folder that is new or empty; writes all files or none. Returns
/// the number of lemmas, and the equations that are not exported with the reason. Throws Failure.
std::string export_coq(const std::string& folder);

}  // namespace steadyslide::app
