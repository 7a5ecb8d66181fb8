// Limits of the Riemann-Hilbert solver: a fixed list of random problems, in double. unsolved.txt lists the unsolved
// ones by seed.

#include "support/made_up_solution.hpp"
#include "support/random_contact.hpp"
#include "support/solved_contact.hpp"

namespace {

using Contact = std::vector<ContactComponent<double>>;

std::map<std::uint64_t, std::string> listed_unsolved() {
  std::map<std::uint64_t, std::string> list;
  for (const std::string& line : lines(file_text(STEADYSLIDE_UNSOLVED))) {
    if (line.empty() || line[0] == '#') continue;
    const std::uint64_t seed = std::stoull(line);
    REQUIRE(holds(line, " "));
    REQUIRE(list.emplace(seed, line.substr(line.find(' ') + 1)).second);
    REQUIRE(seed - first_listed_seed < static_cast<std::uint64_t>(listed_problems));
  }
  return list;
}

/// Returns an empty text if all is correct, otherwise the fault in one line.
std::string failure(const Attempt<double>& attempt) {
  if (!attempt.solution) return "no solution: " + attempt.reason;
  std::string text = attempt.solution->failed_condition();
  const std::string residuals = large_residuals(*attempt.solution, 1e-10);
  if (!residuals.empty()) text += (text.empty() ? "" : "; ") + residuals;
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string failure_of(const ContactProblem& problem, Attempt<double>& attempt) {
  try {
    attempt = riemann_hilbert<double>(problem);
    return failure(attempt);
  } catch (const std::exception& error) {
    return std::string("throws: ") + error.what();
  }
}

bool inside(const Rational& x, const Contact& contact) {
  const auto value = x.convert_to<double>();
  return std::ranges::any_of(contact, [&](const ContactComponent<double>& zone) {
    return zone.left.x.value < value && value < zone.right.x.value;
  });
}

bool has_free_end(const ContactProblem&, const Contact& contact) {
  return std::ranges::any_of(contact, [](const ContactComponent<double>& zone) {
    return zone.left.kind == SingularKind::free || zone.right.kind == SingularKind::free;
  });
}

bool has_wedge_inside(const ContactProblem& problem, const Contact& contact) {
  return std::ranges::any_of(problem.indenter().breaks(), [&](const Indenter::Break& b) {
    return b.wedge != 0 && b.step == 0 && inside(b.x, contact);
  });
}

bool has_decreasing_jump_inside(const ContactProblem& problem, const Contact& contact) {
  const std::vector<Rational>& jumps = problem.friction().jumps();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    if (problem.coupled_friction(k + 1) < problem.coupled_friction(k) && inside(jumps[k], contact)) return true;
  }
  return false;
}

/// A feature of solved problems. The list has enough problems with each.
struct Feature {
  const char* name;
  bool (*has)(const ContactProblem&, const Contact&);
};
constexpr Feature features[] = {
    {"free end", has_free_end},
    {"two zones or more", [](const ContactProblem&, const Contact& c) { return c.size() > 1; }},
    {"wedge in contact", has_wedge_inside},
    {"decreasing jump in contact", has_decreasing_jump_inside}};

struct Tally {
  int all = 0, solved = 0;
  std::array<int, std::size(features)> with{};
  Residuals<double> worst{0, 0, 0, 0};

  void add(const ContactProblem& problem, const ContactSolution<double>& solution) {
    const Contact contact = solution.contact();
    ++solved;
    for (std::size_t k = 0; k < with.size(); ++k) with[k] += features[k].has(problem, contact) ? 1 : 0;
    const Residuals<double> r = solution.residuals();
    worst = {std::max(worst.equation, r.equation), std::max(worst.load, r.load),
             std::max(worst.penetration, r.penetration), std::max(worst.tension, r.tension)};
  }

  std::string text() const {
    std::ostringstream out;
    out << "solved " << solved << ", failed " << all - solved << "\nof those solved:";
    for (std::size_t k = 0; k < with.size(); ++k) out << "  " << features[k].name << ' ' << with[k];
    out << "\nworst residuals: equation " << worst.equation << ", load " << worst.load << ", penetration "
        << worst.penetration << ", tension " << worst.tension;
    return out.str();
  }
};

void solve_the_first(int count) {
  const std::map<std::uint64_t, std::string> unsolved = listed_unsolved();
  CHECK(static_cast<int>(unsolved.size()) * 200 <= listed_problems);
  Tally tally;
  for (tally.all = 0; tally.all < count; ++tally.all) {
    const std::uint64_t seed = first_listed_seed + static_cast<std::uint64_t>(tally.all);
    const ContactProblem problem = random_contact(seed);
    Attempt<double> attempt;
    const std::string reason = failure_of(problem, attempt);
    const std::string line = std::to_string(seed) + ' ' + reason;
    if (reason.empty()) {
      tally.add(problem, *attempt.solution);
      if (unsolved.count(seed) != 0) FAIL_CHECK((line + "is solved: take it off the list"));
    } else if (unsolved.count(seed) == 0) {
      FAIL_CHECK(line);
    } else {
      MESSAGE((line + " (listed: " + unsolved.at(seed) + ')'));
    }
  }
  MESSAGE(tally.text());
  for (const int problems : tally.with) CHECK(5 * problems >= count);
}

}  // namespace

TEST_CASE("the first 300") { solve_the_first(300); }

TEST_CASE("slow: all 2000" * doctest::skip()) { solve_the_first(listed_problems); }

TEST_CASE("control: a residual that is no number fails") {
  struct Spoilt : MadeUp {
    explicit Spoilt(double equation) { shown_residuals = {equation, 0, 0, 0}; }
  };
  CHECK(failure({std::make_shared<Spoilt>(1e-11), ""}).empty());
  CHECK(failure({std::make_shared<Spoilt>(std::nan("")), ""}) == "equation nan");
  CHECK(failure({std::make_shared<Spoilt>(1e-9), ""}) == "equation 1e-09");
}
