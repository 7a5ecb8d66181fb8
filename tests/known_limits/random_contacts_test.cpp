// How much the Riemann-Hilbert solver can do: a fixed list of random problems, in double. What it cannot do stands in
// unsolved.txt, seed by seed.

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/random_contact.hpp"

namespace {

constexpr double tolerance = 1e-10;

using Contact = std::vector<ContactComponent<double>>;

std::map<std::uint64_t, std::string> listed_unsolved() {
  std::map<std::uint64_t, std::string> list;
  std::ifstream file(STEADYSLIDE_UNSOLVED);
  REQUIRE(file);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::uint64_t seed = 0;
    std::string reason;
    words >> seed >> std::ws;
    std::getline(words, reason);
    REQUIRE_MESSAGE(!words.fail(), line);
    REQUIRE(list.emplace(seed, reason).second);
    REQUIRE(seed - first_listed_seed < static_cast<std::uint64_t>(listed_problems));
  }
  return list;
}

/// Empty where all is as it should be, else what is not, in one line. A residual that is no number is one that fails.
std::string failure(const Attempt<double>& attempt) {
  if (!attempt.solution) return "no solution: " + attempt.why_not;
  std::string text = attempt.solution->shortcoming();
  const Residuals<double> r = attempt.solution->residuals();
  for (const auto& [name, value] :
       {std::pair("equation", r.equation), {"load", r.load}, {"penetration", r.penetration}, {"tension", r.tension}}) {
    if (value <= tolerance) continue;
    std::ostringstream number;
    number << value;
    text += (text.empty() ? "" : "; ") + std::string(name) + ' ' + number.str();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
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
  return std::any_of(contact.begin(), contact.end(), [&](const ContactComponent<double>& zone) {
    return zone.left.x.value < value && value < zone.right.x.value;
  });
}

bool has_free_end(const Contact& contact) {
  return std::any_of(contact.begin(), contact.end(), [](const ContactComponent<double>& zone) {
    return zone.left.kind == SingularKind::free || zone.right.kind == SingularKind::free;
  });
}

bool has_wedge_inside(const ContactProblem& problem, const Contact& contact) {
  const std::vector<Indenter::Break> breaks = problem.indenter().breaks();
  return std::any_of(breaks.begin(), breaks.end(),
                     [&](const Indenter::Break& b) { return b.wedge != 0 && b.step == 0 && inside(b.x, contact); });
}

bool has_decreasing_jump_inside(const ContactProblem& problem, const Contact& contact) {
  const std::vector<Rational>& jumps = problem.friction().jumps();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    if (problem.coupled_friction(k + 1) < problem.coupled_friction(k) && inside(jumps[k], contact)) return true;
  }
  return false;
}

bool has_step(const ContactProblem& problem) {
  const std::vector<Indenter::Break> breaks = problem.indenter().breaks();
  return std::any_of(breaks.begin(), breaks.end(), [](const Indenter::Break& b) { return b.step != 0; });
}

/// The decade of load/(height/c), from the heights at a few places: which force is a large one.
int decade(const ContactProblem& problem) {
  double low = infinity<double>();
  double high = -low;
  Rational from = problem.indenter().left();
  for (const Indenter::Piece& piece : problem.indenter().pieces()) {
    for (int k = 0; k <= 16; ++k) {
      const auto height = piece.profile(from + (piece.to - from) * k / 16).convert_to<double>();
      low = std::min(low, height);
      high = std::max(high, height);
    }
    from = piece.to;
  }
  const double size = high > low ? high - low : 1;
  return static_cast<int>(
      std::floor(std::log10(Rational(problem.load() * problem.elasticity().compliance()).convert_to<double>() / size)));
}

struct Tally {
  int all = 0;
  int solved = 0;
  int free_end = 0;
  int zones = 0;  ///< two or more
  int wedge = 0;
  int decreasing = 0;
  int steps = 0;
  int tilting = 0;
  std::map<std::size_t, int> by_zones;
  std::map<int, int> by_decade;
  Residuals<double> worst{0, 0, 0, 0};

  void add(const ContactProblem& problem, const ContactSolution<double>& solution) {
    const Contact contact = solution.contact();
    ++solved;
    free_end += has_free_end(contact) ? 1 : 0;
    zones += contact.size() > 1 ? 1 : 0;
    wedge += has_wedge_inside(problem, contact) ? 1 : 0;
    decreasing += has_decreasing_jump_inside(problem, contact) ? 1 : 0;
    steps += has_step(problem) ? 1 : 0;
    tilting += problem.load_at() ? 1 : 0;
    ++by_zones[contact.size()];
    ++by_decade[decade(problem)];
    const Residuals<double> r = solution.residuals();
    worst = {std::max(worst.equation, r.equation), std::max(worst.load, r.load),
             std::max(worst.penetration, r.penetration), std::max(worst.tension, r.tension)};
  }

  std::string text() const {
    std::ostringstream out;
    out << "solved " << solved << ", failed " << all - solved << "\nof those solved: free end " << free_end
        << ", two zones or more " << zones << ", wedge in contact " << wedge << ", decreasing jump in contact "
        << decreasing << ", steps " << steps << ", tilting " << tilting << "\nzones:";
    for (const auto& [count, problems] : by_zones) out << "  " << count << ": " << problems;
    out << "\nload/(height/c), by powers of ten:";
    for (const auto& [power, problems] : by_decade) out << "  " << power << ": " << problems;
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
  CHECK(5 * tally.free_end >= count);
  CHECK(5 * tally.zones >= count);
  CHECK(5 * tally.wedge >= count);
  CHECK(5 * tally.decreasing >= count);
}

}  // namespace

TEST_CASE("the first 300") { solve_the_first(300); }

TEST_CASE("slow: all 2000" * doctest::skip()) { solve_the_first(listed_problems); }

TEST_CASE("control: a residual that is no number fails") {
  class Spoilt : public ContactSolution<double> {
   public:
    explicit Spoilt(double equation) : equation_(equation) {}
    std::string method() const override { return "spoilt"; }
    Contact contact() const override { return {}; }
    std::vector<SolvedSingularPoint<double>> singular_points() const override { return {}; }
    Resultants<double> resultants() const override { return {}; }
    EstimatedError<double> estimated_error() const override { return {}; }
    Residuals<double> residuals() const override { return {equation_, 0, 0, 0}; }
    Sample<double> at(const Rational&) const override { return {}; }
    std::vector<Sample<double>> samples(int) const override { return {}; }

   private:
    double equation_;
  };
  CHECK(failure({std::make_shared<Spoilt>(1e-11), ""}).empty());
  CHECK(failure({std::make_shared<Spoilt>(std::nan("")), ""}) == "equation nan");
  CHECK(failure({std::make_shared<Spoilt>(1e-9), ""}) == "equation 1e-09");
}
