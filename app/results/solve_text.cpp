#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/results/solve_writers.hpp"

namespace steadyslide::app {
namespace {

/// The text lists at most this many of a kind; other formats have all of them.
constexpr std::size_t most_listed = 10;

std::string and_more(std::size_t count) { return fmt::format("... and {} more (JSON has all)", count - most_listed); }

/// An unknown value is shown as "-", not as an empty text.
std::string shown(const std::string& text) { return text.empty() ? "-" : text; }
std::string shown(const NumberText& number) { return shown(number.shown); }
std::string shown(const LimitText& limits) {
  const std::string left = shown(limits.left);
  const std::string right = shown(limits.right);
  return left != right ? left + " | " + right : left;
}

void write_line(Output& output, const std::string& name, const std::string& value) {
  output.write(fmt::format("  {:<22}{}\n", name, shown(value)));
}

/// Writes load, direction and coupling constant.
void write_problem(const ContactProblem& problem, Output& output) {
  output.write(fmt::format("load {}, indenter sliding towards {}, gamma = {}\n", exact_text(problem.load()),
                           name_of(problem.sliding()), exact_text(problem.elasticity().gamma())));
}

/// Writes one line for each contact component.
void write_contact(const SolutionText& solution, Output& output) {
  const std::size_t zones = solution.contact.size();
  for (std::size_t k = 0; k < std::min(zones, most_listed); ++k) {
    const auto& [left, right] = solution.contact[k];
    if (left.kind == name_of(SingularKind::friction_jump)) {
      output.write("  everywhere, without a gap: " + shown(solution.width[k]) + " in each period\n");
      continue;
    }
    output.write(fmt::format("  from x = {} ({}) to x = {} ({}), width {}", shown(left.x), left.kind, shown(right.x),
                             right.kind, shown(solution.width[k])));
    const bool shares = zones > 1 && !solution.component_load[k].shown.empty();
    output.write(shares ? ", load " + solution.component_load[k].shown + "\n" : "\n");
  }
  if (zones > most_listed) output.write("  " + and_more(zones) + "\n");
}

void write_singular_points(const SolutionText& solution, Output& output) {
  std::string text = "singular points (";
  for (const LocalTerms& terms : all_local_terms()) {
    if (!terms.form.empty()) text += std::string(terms.form) + "; ";
  }
  text += "p ~ K (2 pi d)^exponent)\n";
  for (std::size_t from = 0; text.size() - from > 100;) {
    from = text.rfind("; ", from + 99) + 1;
    text[from] = '\n';
  }
  output.write("\n" + text);
  Rows rows({"x", "kind", "exponent", "intensity", "constant", "K", "exact"}, output);
  std::map<std::string, int> unknown;
  std::size_t known = 0;
  for (const SingularText& point : solution.singular_points) {
    if (point.intensity.shown.empty()) {
      ++unknown[point.kind];
      continue;
    }
    if (++known > most_listed) continue;
    rows.row({shown(point.x), point.kind, point.exponent.value, point.intensity, point.constant,
              shown(point.stress_intensity), point.exponent.symbolic});
  }
  if (unknown.empty() || known > 0) rows.end();
  if (known > most_listed) output.write("  " + and_more(known) + "\n");
  for (const auto& [kind, count] : unknown)
    output.write(fmt::format("  {} {}: their intensities are not known\n", count, kind));
}

/// A line of the text. If a quantity has several lines, `which` names each.
struct Line {
  std::string name;
  std::string value;
  std::string which{};
};

/// The lines of a quantity, by its type; none if it is absent.
class Lines {
 public:
  explicit Lines(const Problem& problem) : friction_(problem.contact.friction().values()) {}

  std::vector<Line> operator()(const std::string& name, const NumberText& number) const {
    return {{name, shown(number)}};
  }
  std::vector<Line> operator()(const std::string& name, std::size_t count) const {
    return {{name, std::to_string(count)}};
  }
  template <class Value>
  std::vector<Line> operator()(const std::string& name, const std::optional<Value>& value) const {
    return value ? (*this)(name, *value) : std::vector<Line>();
  }
  std::vector<Line> operator()(const std::string& name, const answer::IntervalOf<NumberText>& interval) const {
    return {{name, fmt::format("from {} to {}", shown(interval.left), shown(interval.right))}};
  }
  std::vector<Line> operator()(const std::string& name, const ResultantsText::Largest& largest) const {
    if (largest.value.shown.empty()) return {{name, "-"}};
    const std::string singular = largest.exponent == "log" ? "log d" : "d^" + largest.exponent;
    const std::string power = largest.exponent.empty() ? "" : ", like " + singular;
    return {{name, fmt::format("{} at x = {}{}", largest.value.shown, shown(largest.x), power)}};
  }
  /// One line for each friction value.
  std::vector<Line> operator()(const std::string& name, const std::vector<NumberText>& numbers) const {
    std::vector<Line> lines;
    for (std::size_t k = 0; k < std::min(numbers.size(), most_listed); ++k) {
      lines.push_back({name, shown(numbers[k]), "under f = " + exact_text(friction_[k])});
    }
    if (numbers.size() > most_listed) lines.push_back({name, "", and_more(numbers.size())});
    return lines;
  }

 private:
  const std::vector<Rational>& friction_;
};

/// Returns all quantities, in the order of their lines.
std::vector<Line> resultant_lines(const Problem& problem, const ResultantsText& resultants) {
  std::map<int, std::vector<Line>> ordered;
  answer::for_each_quantity(resultants, [&](const answer::Quantity& row, const auto& value) {
    ordered[row.line] = Lines(problem)(answer::words(row), value);
  });
  std::vector<Line> result;
  for (const auto& [place, lines] : ordered) result.insert(result.end(), lines.begin(), lines.end());
  return result;
}

void write_resultants(const Problem& problem, const SolutionText& solution, Output& output) {
  output.write("\nresultants (forces per unit thickness, lengths in the problem's units)\n");
  std::string before;
  for (const auto& [name, value, which] : resultant_lines(problem, solution.resultants)) {
    const std::string gap = value.empty() || which.empty() ? "" : " ";
    write_line(output, name == before ? "" : name, value + gap + which);
    before = name;
  }
}

void write_samples(const SolutionText& solution, Output& output) {
  if (solution.samples.empty()) return;
  output.write("\nsamples (left | right where the limits differ; traction and shear: force per area)\n");
  Rows rows({"x", "traction", "shear", "gap", "slope", "u", "u_t'", "load up to x"}, output);
  for (const SampleText& at : solution.samples) {
    rows.row({at.x, shown(at.traction), shown(at.shear), at.gap, shown(at.slope), at.displacement,
              shown(at.shear_slope), at.cumulative_load});
  }
  rows.end();
}

void write_field(const SolutionText& solution, Output& output) {
  for (const FieldTable& table : solution.field.tables) {
    output.write("\n" + table.heading + "\n");
    Rows rows(table.columns, output);
    for (const std::vector<Cell>& row : table.rows) rows.row(row);
    rows.end();
  }
  if (const auto& largest = solution.field.largest_stress) {
    output.write("\nlargest von Mises stress\n");
    const std::vector<NumberText>& unbounded = largest->unbounded_at;
    for (std::size_t k = 0; k < std::min(unbounded.size(), most_listed); ++k) {
      write_line(output, "inf", "next to x = " + shown(unbounded[k]));
    }
    if (unbounded.size() > most_listed) output.write("  " + and_more(unbounded.size()) + "\n");
    write_line(output, shown(largest->von_mises),
               fmt::format("at x = {}, z = {} (depths from {})", shown(largest->x), shown(largest->z), largest->depth));
    if (largest->proved) output.write("  proved of this place; that no other one has more is not\n");
    if (const auto& average = largest->average) {
      output.write(fmt::format("\nlargest von Mises stress of averages over {} along x\n", average->over));
      write_line(output, shown(average->von_mises),
                 fmt::format("at x = {}, z = {}", shown(average->x), shown(average->z)));
    }
  }
}

void write_sizes(const std::string& heading, const std::vector<NamedSize>& sizes, Output& output) {
  output.write("\n" + heading + "\n");
  for (const auto& [name, size] : sizes) write_line(output, name, size);
}

void write_unproved(const std::string& why_not, Output& output) {
  output.write(fmt::format("\nnot proved: {}\n", why_not));
}

void write_proof(const ProofText& proof, Output& output) {
  if (!proof.proved) return write_unproved(proof.why_not(), output);
  output.write(
      fmt::format("\nproved: there is a solution with this contact; all numbers above but the residuals are its own,\n"
                  "to the last digit (balls of {} bits, signs decided on {} intervals)\n",
                  proof.bits, proof.intervals));
}

void write_bound(const BoundText& bound, Output& output) {
  if (!bound.proved) return write_unproved(bound.reason, output);
  output.write(
      fmt::format("\nproved: load shares, friction and tangential force lie within the errors printed beside\n"
                  "them (energy of the error at most {} c P^2, gap under pressure at most {} c P)\n",
                  bound.energy, bound.largest_gap));
}

void write_tolerance(const Problem& problem, const ToleranceText& tolerance, Output& output) {
  output.write(
      fmt::format("\nwith any profile within {} and any friction within {} of these, under the same load,\n"
                  "in the same attitude or under the same line of action{}\n",
                  tolerance.profile, tolerance.friction, tolerance.proved ? " (proved)" : " (by estimates)"));
  const auto line = [&](const std::string& name, const IntervalText& interval, const std::string& which) {
    write_line(output, name, fmt::format("from {} to {}{}", interval.from, interval.to, which));
  };
  const std::vector<Rational>& friction = problem.contact.friction().values();
  for (std::size_t k = 0; k < std::min(tolerance.load_share.size(), most_listed); ++k) {
    line(k == 0 ? "load share" : "", tolerance.load_share[k], " under f = " + exact_text(friction[k]));
  }
  if (tolerance.load_share.size() > most_listed) write_line(output, "", and_more(tolerance.load_share.size()));
  line("friction force", tolerance.friction_force, "");
  line("effective friction", tolerance.effective_friction, "");
}

}  // namespace

void write_text(const Problem& problem, const SolutionText& solution, Output& output) {
  write_problem(problem.contact, output);
  const std::string& method = solution.instead.empty() ? "method " + solution.method : solution.instead;
  output.write(fmt::format("{}, {} digits", method, solution.digits));
  if (const auto& cells = solution.cells) {
    output.write(fmt::format(", {} cells on [{}, {}]", cells->count, cells->from.shown, cells->to.shown));
  }
  output.write("\n\ncontact\n");
  write_contact(solution, output);
  write_singular_points(solution, output);
  write_resultants(problem, solution, output);
  write_samples(solution, output);
  write_field(solution, output);
  const bool proved = solution.proof && solution.proof->proved;
  write_sizes(proved ? "relative errors, proved" : "estimated relative errors", solution.errors, output);
  write_sizes("relative residuals, by an unrelated rule", solution.residuals, output);
  if (solution.proof) write_proof(*solution.proof, output);
  if (solution.bound) write_bound(*solution.bound, output);
  if (solution.tolerance) write_tolerance(problem, *solution.tolerance, output);
  if (!solution.is_solved()) return;
  const bool decided = !solution.uniqueness.empty();
  output.write(decided ? fmt::format("\n{}, by the {}\n", only_solution, solution.uniqueness)
                       : fmt::format("\nnot decided whether it is {}: {}\n", only_solution, no_uniqueness));
}

void write_text(const Problem& problem, const BothText& both, Output& output) {
  write_text(problem, both.as_given, output);
  const Sliding sliding = problem.contact.sliding();
  output.write("\nboth directions\n");
  Rows rows({"sliding towards", name_of(sliding), name_of(opposite(sliding))}, output);
  const auto row = [&](const std::string& name, const auto& told) {
    rows.row({name, told(both.as_given), told(both.opposite)});
  };
  const auto ends = [](const SolutionText& solution) {
    if (solution.contact.empty()) return std::string();
    return fmt::format("{} to {}", shown(solution.contact.front().first.x), shown(solution.contact.back().second.x));
  };
  row("contact from", ends);
  const std::vector<Line> others = resultant_lines(problem, both.opposite.resultants);
  for (const Line& line : resultant_lines(problem, both.as_given.resultants)) {
    const auto other =
        std::ranges::find_if(others, [&](const Line& one) { return one.name == line.name && one.which == line.which; });
    const std::string gap = line.which.empty() ? "" : " ";
    rows.row({line.name + gap + line.which, line.value, other == others.end() ? "" : other->value});
  }
  row("solved", [](const SolutionText& solution) {
    return solution.is_solved() ? std::string("yes") : solution.reason + solution.failed_condition;
  });
  rows.end();
  if (!both.opposite.field.any()) return;
  output.write(fmt::format("\nsliding towards {}\n", name_of(opposite(sliding))));
  write_field(both.opposite, output);
}

}  // namespace steadyslide::app
