// verify-<group> [--claim GLOB]... [--digits N] [--seed N] [--jobs N] [--quick]: runs the claims of one place in the
// paper and prints a table. The exit code is 0 if every claim is proved, supported or beyond calculation, 1 if a claim
// is not, and 2 if the command line is wrong.

#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "proofs_checks/kit/processes.hpp"
#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/kit/run.hpp"

namespace {

using namespace steadyslide;

template <class Number>
Number number(std::string_view option, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument(std::string(option) + ": not a number: " + std::string(text));
  }
  return value;
}

struct Options {
  proofs_checks::Context context;
  std::vector<std::string> claims;  ///< patterns of ids; if empty, all claims
  unsigned processes = proofs_checks::available_processes();
};

Options options_from(int argc, char** argv) {
  Options options;
  proofs_checks::Context& context = options.context;
  for (int k = 1; k < argc; ++k) {
    const std::string_view option = argv[k];
    const bool has_value = k + 1 < argc;
    if (option == "--quick") {
      context.quick = true;
    } else if (option == "--claim" && has_value) {
      options.claims.emplace_back(argv[++k]);
    } else if (option == "--seed" && has_value) {
      context.seed = number<std::uint64_t>(option, argv[++k]);
    } else if (option == "--digits" && has_value) {
      const int digits = number<int>(option, argv[++k]);
      if (digits < 1 || digits > 100) throw std::invalid_argument("--digits: 1 to 100");
      context.digits = numeric::precision_for(digits);
    } else if (option == "--jobs" && has_value) {
      options.processes = number<unsigned>(option, argv[++k]);
      if (options.processes < 1 || options.processes > 1000) throw std::invalid_argument("--jobs: 1 to 1000");
    } else {
      throw std::invalid_argument(
          "usage: [--claim GLOB]... [--digits N] [--seed N] [--jobs N] [--quick]; not understood: " +
          std::string(option));
    }
  }
  return options;
}

void print(const proofs_checks::Report& report) {
  std::printf("%-24s %-10s %2zu of %2zu controls refuted  %7.2f s\n", report.claim.id.c_str(),
              std::string(name_of(report.verdict)).c_str(), report.controls_refuted(), report.controls.size(),
              report.seconds);
  for (const proofs_checks::Evidence& e : report.evidence) {
    std::printf("    %s: %s\n", std::string(kind_of(e)).c_str(), describe(e).c_str());
  }
  if (!report.note.empty()) std::printf("    note: %s\n", report.note.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto [context, patterns, processes] = options_from(argc, argv);
    std::printf("%d digits, seed %llu%s\n", static_cast<int>(context.digits),
                static_cast<unsigned long long>(context.seed), context.quick ? ", quick" : "");
    const std::vector<proofs_checks::Report> reports =
        run_in_processes(select(proofs_checks::claims_of_group(STEADYSLIDE_GROUP), patterns), context, processes);
    for (const proofs_checks::Report& report : reports) print(report);
    if (reports.empty()) throw std::invalid_argument("--claim: no such claim here");
    std::printf("%s\n", counts_line(reports).c_str());
    return settled(reports) ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 2;
  }
}
