#include "app/verify/coq_export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "app/terminal/failure.hpp"
#include "app/terminal/interrupt.hpp"
#include "app/terminal/output.hpp"
#include "symbolic/coq/coq_lemmas.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::app {
namespace {

namespace fs = std::filesystem;

struct LeftOut {
  std::map<std::string, std::map<std::string, std::size_t>> equations;  ///< reason -> statement -> number of equations
  std::vector<std::string> statements;                                  ///< statements of which nothing is exported
};

std::vector<symbolic::CoqLemma> lemmas_of(const symbolic::StatementFamily& family, LeftOut& left_out) {
  std::vector<symbolic::CoqLemma> lemmas;
  for (const symbolic::DecidedStatement& statement : family.decide()) {
    symbolic::CoqLemmas found = symbolic::coq_lemmas(statement.id, statement.identity);
    for (symbolic::CoqLemma& lemma : found.lemmas) {
      if (!lemma.proved) throw Failure(ExitCode::refuted, lemma.name + ": the cofactors leave a remainder");
      lemmas.push_back(std::move(lemma));
    }
    for (const symbolic::NotExported& e : found.not_exported) ++left_out.equations[e.reason][e.id];
    if (found.lemmas.empty()) left_out.statements.push_back(statement.id);
  }
  return lemmas;
}

std::string text_of(const LeftOut& left_out) {
  std::size_t total = 0;
  std::string reasons;
  for (const auto& [reason, statements] : left_out.equations) {
    std::size_t count = 0;
    std::string where;
    for (const auto& [id, equations] : statements) {
      count += equations;
      where += fmt::format("    {} {}\n", equations, id);
    }
    total += count;
    reasons += fmt::format("  {}: {}\n{}", count, reason, where);
  }
  return fmt::format("{} equations not exported\n{}statements without a lemma: {}\n", total, reasons,
                     fmt::join(left_out.statements, ", "));
}

void require_new_or_empty(const std::string& folder) {
  std::error_code error;
  const bool exists = fs::exists(folder, error);
  if (exists && !(fs::is_directory(folder, error) && fs::is_empty(folder, error))) {
    throw bad_command_line("--export-coq: not an empty folder", "it is one that is new or empty", folder);
  }
}

/// Writes all files, or none.
void write_all(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files) {
  const bool is_new = make_folder(folder);
  const SignalsHeld held;
  try {
    for (const auto& [file, text] : files) write_whole(file, text);
  } catch (...) {
    std::error_code error;
    for (const auto& [file, text] : files) fs::remove(file, error);
    if (is_new) fs::remove(folder, error);
    throw;
  }
}

}  // namespace

std::string export_coq(const std::string& folder) {
  require_new_or_empty(folder);
  std::vector<std::pair<std::string, std::string>> files;
  LeftOut left_out;
  std::string text;
  std::size_t total = 0;
  for (const symbolic::StatementFamily& family : symbolic::statement_families) {
    const std::vector<symbolic::CoqLemma> lemmas = lemmas_of(family, left_out);
    const std::string file = (fs::path(folder) / family.name).string() + ".v";
    files.emplace_back(file, symbolic::coq_file(lemmas));
    text += fmt::format("  {} {}\n", lemmas.size(), file);
    total += lemmas.size();
  }
  write_all(folder, files);
  return fmt::format("{} lemmas exported; coqc compiles each file\n{}{}", total, text, text_of(left_out));
}

}  // namespace steadyslide::app
