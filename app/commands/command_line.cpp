#include "app/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "app/commands/help_text.hpp"
#include "app/figures/figures.hpp"
#include "app/problem_file/list_parser.hpp"
#include "app/terminal/failure.hpp"
#include "app/version.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::app {
namespace {

constexpr std::array<std::pair<std::string_view, Format>, 5> all_formats{{{"text", Format::text},
                                                                          {"json", Format::json},
                                                                          {"csv", Format::csv},
                                                                          {"markdown", Format::markdown},
                                                                          {"latex", Format::latex}}};

/// The texts behind the options, as CLI11 leaves them.
struct Raw {
  std::string problem, method = "auto", digits, format = "text", output, at, samples, cells, iterations, load_steps,
                       search_solutions, poisson, rear, front, seed, report, group;
  std::vector<std::string> claims, figures;
  bool derivation = false, list = false, quick = false;
};

class CommandLine {
 public:
  CommandLine() : app_(help::program, "steadyslide") {
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.set_version_flag("--version", std::string("steadyslide ") + version);
    app_.require_subcommand(0, 1);
    app_.footer(help::program_footer);
    app_.get_formatter()->column_width(28);
    add_verify();
    add_exponents();
    add_table();
    add_solve();
    add_figures();
    add_report();
  }

  Command parse(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      return Message{app_.help()};
    } catch (const CLI::CallForVersion& call) {
      return Message{std::string(call.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
      throw unexpected(app_.remaining(true).front());
    } catch (const CLI::ParseError& error) {
      throw bad_command_line(error.what());
    }
    if (app_.get_subcommands().empty()) throw no_command();
    if (*figures_) return figures();
    if (*report_) return report();
    if (*verify_) return verify();
    if (*exponents_) return exponents();
    if (*table_) return table();
    return solve();
  }

 private:
  static constexpr const char* commands_rule = "it is one of verify, exponents, table, solve, figures, report";

  static Failure no_command() { return bad_command_line(std::string("no command; ") + commands_rule + "; see --help"); }

  Failure unexpected(const std::string& argument) const {
    const bool option = !argument.empty() && argument.front() == '-';
    const std::vector<CLI::App*> commands = app_.get_subcommands();
    if (commands.empty() && !option) return bad_command_line("unknown command", commands_rule, argument);
    const std::string help = commands.empty() ? "--help" : commands.front()->get_name() + " --help";
    return bad_command_line(option ? "unknown option" : "one argument too many", help + " lists them", argument);
  }

  void add_common(CLI::App* command, const char* digits, const char* formats) {
    command->add_option("--digits", raw_.digits, digits)->type_name("N");
    command->add_option("--format", raw_.format, formats)->type_name("FORMAT");
    command->add_option("-o,--output", raw_.output, "Write to FILE, whole or not at all; default: standard output")
        ->type_name("FILE");
  }

  void add_verify() {
    verify_ = app_.add_subcommand("verify", help::verify);
    verify_->add_flag("--list", raw_.list, "List the claims, check nothing");
    verify_->add_option("--claim", raw_.claims, "Only claims whose id matches, * and ? being wildcards; repeatable")
        ->type_name("GLOB")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verify_->add_option("--group", raw_.group, "Only claims of one place in the paper, theorem-2; --list names them")
        ->type_name("NAME");
    verify_->add_flag("--quick", raw_.quick, "Fewer parameters");
    verify_->add_option("--seed", raw_.seed, "Seed of the random parameters, a whole number")->type_name("N");
    verify_->add_option("--report", raw_.report, "Write the report on this run as well: DIR/report.html")
        ->type_name("DIR");
    add_common(verify_, "Digits to work with, 1 to 100; default 50", "text, json or markdown");
    verify_->footer(help::verify_footer);
  }

  void add_exponents() {
    exponents_ = app_.add_subcommand("exponents", help::exponents);
    exponents_->add_option("PROBLEM", raw_.problem, "Problem file, or -")->required()->type_name("");
    exponents_->add_flag("--derivation", raw_.derivation, "How they are derived, step by step: text or latex");
    add_common(exponents_, "Significant digits, 1 to 100; default 16", "text, json, csv, markdown or latex");
    exponents_->footer(std::string(help::exponents_footer) + "\n" + help::problem);
  }

  void add_table() {
    table_ = app_.add_subcommand("table", help::table);
    table_->add_option("--poisson", raw_.poisson, "Poisson's ratios")->type_name("LIST")->required();
    table_->add_option("--rear", raw_.rear, "Friction coefficients at the rear")->type_name("LIST")->required();
    table_->add_option("--front", raw_.front, "Friction coefficients at the front")->type_name("LIST")->required();
    add_common(table_, "Significant digits, 1 to 100; default 16", "text, json, csv, markdown or latex");
    table_->footer(help::table_footer);
  }

  void add_solve() {
    solve_ = app_.add_subcommand("solve", help::solve);
    solve_->add_option("PROBLEM", raw_.problem, "Problem file, or -")->required()->type_name("");
    solve_->add_option("--method", raw_.method, "auto, closed-form, riemann-hilbert or variational")
        ->type_name("METHOD");
    solve_->add_option("--at", raw_.at, "Results at these x, in your units; may lie outside the support")
        ->type_name("LIST");
    solve_->add_option("--samples", raw_.samples, "Results at N places in each contact component and gap, 1 to 100000")
        ->type_name("N");
    solve_
        ->add_option("--cells", raw_.cells, "Equal cells on the support, 16 to 4194304; default 4096: variational only")
        ->type_name("N");
    solve_
        ->add_option("--iterations", raw_.iterations,
                     "Most steps of the active sets on each mesh, 1 to 10000; default 100: variational only")
        ->type_name("N");
    solve_
        ->add_option("--load-steps", raw_.load_steps,
                     "The contact under each of these loads, one row for each component")
        ->type_name("LIST");
    solve_
        ->add_option("--search-solutions", raw_.search_solutions,
                     "Start from N contact sets, 1 to 1000: do all lead to one solution? By the variational method")
        ->type_name("N");
    add_common(solve_, "Significant digits, 1 to 100; default 16", "text, json or csv");
    solve_->footer(std::string(help::solve_footer) + "\n" + help::problem);
  }

  void add_figures() {
    figures_ = app_.add_subcommand("figures", help::figures);
    figures_
        ->add_option("--figure", raw_.figures, "Only figures whose name matches, * and ? being wildcards; repeatable")
        ->type_name("GLOB")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_folder(figures_);
    std::string names = "Figures:";
    for (const FigureMaker& figure : app::figures()) names += "\n  " + figure.name;
    figures_->footer(std::string(help::figures_footer) + "\n" + names);
  }

  void add_report() {
    report_ = app_.add_subcommand("report", help::report);
    report_->add_flag("--quick", raw_.quick, "Fewer parameters");
    report_->add_option("--seed", raw_.seed, "Seed of the random parameters, a whole number")->type_name("N");
    report_->add_option("--digits", raw_.digits, "Digits to work with, 1 to 100; default 50")->type_name("N");
    add_folder(report_);
    report_->footer(help::report_footer);
  }

  void add_folder(CLI::App* command) {
    command->add_option("-o,--output", raw_.output, "Write into DIR, which is made if need be; default: here")
        ->type_name("DIR");
  }

  static bool given(const CLI::App* command, const char* option) { return command->get_option(option)->count() > 0; }

  CommonOptions common(const CLI::App* command, int digits, std::initializer_list<Format> formats) const {
    CommonOptions result;
    result.digits = given(command, "--digits") ? parse_count("--digits", raw_.digits, 1, 100) : digits;
    std::string names;
    bool found = false;
    for (const auto& [name, format] : all_formats) {
      if (std::find(formats.begin(), formats.end(), format) == formats.end()) continue;
      names += (names.empty() ? "" : ", ") + std::string(name);
      if (raw_.format != name) continue;
      result.format = format;
      found = true;
    }
    if (!found) throw bad_command_line("--format: unknown format", "it is one of " + names, raw_.format);
    if (given(command, "--output")) {
      if (raw_.output.empty()) throw bad_command_line("--output: no file", "it has a name", raw_.output);
      result.output = raw_.output;
    }
    return result;
  }

  VerifyOptions verify() const {
    VerifyOptions options{common(verify_, 50, {Format::text, Format::json, Format::markdown}),
                          raw_.list,
                          raw_.quick,
                          raw_.claims,
                          raw_.group,
                          std::nullopt};
    options.seed = seed(verify_);
    if (!given(verify_, "--report")) return options;
    if (raw_.report.empty()) throw bad_command_line("--report: no folder", "it has a name", raw_.report);
    if (raw_.list) throw bad_command_line("--list: conflicting option", "it checks nothing to report", "--report");
    options.report = raw_.report;
    return options;
  }

  std::optional<unsigned long long> seed(const CLI::App* command) const {
    if (!given(command, "--seed")) return std::nullopt;
    unsigned long long seed = 0;
    const char* const end = raw_.seed.data() + raw_.seed.size();
    const auto [after, error] = std::from_chars(raw_.seed.data(), end, seed);
    if (error != std::errc() || after != end) {
      throw bad_command_line("--seed: out of range", "it is a whole number from 0 to 2^64-1", raw_.seed);
    }
    return seed;
  }

  std::string folder(const CLI::App* command) const {
    if (!given(command, "--output")) return ".";
    if (raw_.output.empty()) throw bad_command_line("--output: no folder", "it has a name", raw_.output);
    return raw_.output;
  }

  FiguresOptions figures() const { return {folder(figures_), raw_.figures}; }

  ReportOptions report() const {
    ReportOptions options;
    options.folder = folder(report_);
    options.verify.quick = raw_.quick;
    options.verify.seed = seed(report_);
    options.verify.common.digits = given(report_, "--digits") ? parse_count("--digits", raw_.digits, 1, 100) : 50;
    return options;
  }

  ExponentsOptions exponents() const {
    ExponentsOptions options{
        common(exponents_, 16, {Format::text, Format::json, Format::csv, Format::markdown, Format::latex}),
        raw_.problem, raw_.derivation};
    if (options.derivation && options.common.format != Format::text && options.common.format != Format::latex) {
      throw bad_command_line("--derivation: wrong format", "a derivation is text or latex", raw_.format);
    }
    return options;
  }

  TableOptions table() const {
    return {common(table_, 16, {Format::text, Format::json, Format::csv, Format::markdown, Format::latex}),
            raw_.poisson, raw_.rear, raw_.front};
  }

  SolveOptions solve() const {
    SolveOptions options;
    options.common = common(solve_, 16, {Format::text, Format::json, Format::csv});
    options.problem = raw_.problem;
    options.method = method();
    options.at = raw_.at;
    options.load_steps = raw_.load_steps;
    for (const auto& [option, list] : {std::pair("--at", raw_.at), {"--load-steps", raw_.load_steps}}) {
      if (!given(solve_, option)) continue;
      if (list.empty()) throw bad_command_line(std::string(option) + ": no value", "it is a list", list);
    }
    if (given(solve_, "--samples")) options.samples = parse_count("--samples", raw_.samples, 1, 100000);
    if (given(solve_, "--cells")) {
      options.cells = parse_count("--cells", raw_.cells, numeric::fewest_cells, numeric::most_cells);
    }
    if (given(solve_, "--iterations")) options.iterations = parse_count("--iterations", raw_.iterations, 1, 10000);
    if (given(solve_, "--search-solutions")) {
      options.search_starts = parse_count("--search-solutions", raw_.search_solutions, 1, 1000);
    }
    refuse_conflicts(options.method);
    return options;
  }

  void refuse_conflicts(Method method) const {
    for (const char* option : {"--at", "--samples"}) {
      if (!given(solve_, "--load-steps") || !given(solve_, option)) continue;
      throw bad_command_line("--load-steps: conflicting option", "samples are those of one load", option);
    }
    if (!given(solve_, "--search-solutions")) return;
    for (const char* option : {"--at", "--samples", "--load-steps"}) {
      if (!given(solve_, option)) continue;
      throw bad_command_line("--search-solutions: conflicting option",
                             "it compares contact zones and resultants under the file's load", option);
    }
    if (method == Method::closed_form || method == Method::riemann_hilbert) {
      throw bad_command_line("--search-solutions: conflicting option", "it searches by the variational method",
                             "--method " + raw_.method);
    }
  }

  Method method() const {
    if (raw_.method == "auto") return Method::automatic;
    if (raw_.method == "closed-form") return Method::closed_form;
    if (raw_.method == "riemann-hilbert") return Method::riemann_hilbert;
    if (raw_.method == "variational") return Method::variational;
    throw bad_command_line("--method: unknown method", "it is one of auto, closed-form, riemann-hilbert, variational",
                           raw_.method);
  }

  Raw raw_;
  CLI::App app_;
  CLI::App* verify_ = nullptr;
  CLI::App* exponents_ = nullptr;
  CLI::App* table_ = nullptr;
  CLI::App* solve_ = nullptr;
  CLI::App* figures_ = nullptr;
  CLI::App* report_ = nullptr;
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

}  // namespace steadyslide::app
