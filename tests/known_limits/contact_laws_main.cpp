// contact_laws FIRST COUNT: examines the laws of instruments/solutions/contact_laws.hpp on COUNT random problems
// with falling friction from number FIRST on, by the Riemann-Hilbert method and on cells. Each problem has two loads,
// two attitudes, two frictions, another parabola, and a line of action with two loads and two frictions. Prints a line
// for every law that fails and every unsolved problem, with the seed for `random_contact falling-frictions`, then the
// smallest margin of each law. Exit code 1 if a law fails.

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>

#include "model/most_components.hpp"
#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "support/random_contact.hpp"

namespace {

using namespace steadyslide;
using namespace steadyslide::proofs_checks;

struct Tally {
  std::size_t compared = 0, failed = 0, unsolved = 0;
  double margin = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 0;
};

class Study {
 public:
  void examine(std::uint64_t seed) {
    for (const Method method : {Method::riemann_hilbert, Method::cells}) {
      try {
        examine(seed, method);
      } catch (const std::exception& error) {
        add("solution", seed, method, {{std::string("throws: ") + error.what(), 1}});
      }
    }
  }
  bool print() const;

 private:
  void examine(std::uint64_t seed, Method method);
  void add(const std::string& law, std::uint64_t seed, Method method, const Shortfalls& shortfalls);
  void add_unsolved(const std::string& law, std::uint64_t seed, Method method);

  std::map<std::pair<std::string, Method>, Tally> tallies_;
};

void Study::add(const std::string& law, std::uint64_t seed, Method method, const Shortfalls& shortfalls) {
  for (const auto& [name, value] : shortfalls) {
    Tally& tally = tallies_[{law + ": " + name, method}];
    ++tally.compared;
    if (!(value <= 0)) {
      ++tally.failed;
      std::cout << seed << ", " << name_of(method) << ": " << law << ": " << name << ' ' << value << std::endl;
    }
    if (!(0 - value >= tally.margin)) {
      tally.margin = 0 - value;
      tally.seed = seed;
    }
  }
}

void Study::add_unsolved(const std::string& law, std::uint64_t seed, Method method) {
  ++tallies_[{law, method}].unsolved;
  std::cout << seed << ", " << name_of(method) << ": " << law << ": not solved" << std::endl;
}

void Study::examine(std::uint64_t seed, Method method) {
  Random random(seed, "contact_laws");
  const ContactProblem base =
      with_load_at(testing::random_contact(seed, testing::ContactFamily::falling_frictions), std::nullopt);
  const Rational growth = 1 + random.between(Rational(1, 50), 2);
  const Rational slope = usual_slope(base) * random.between(Rational(1, 100), 1);
  const Rational length = base.indenter().right() - base.indenter().left();
  const Rational curve =
      (random.below(2) == 0 ? 4 : -4) * usual_slope(base) / length * random.between(Rational(1, 10), 1);
  const Rational part = random.between(Rational(-1, 2), Rational(1, 2));
  std::vector<Rational> values = base.friction().values();
  for (Rational& f : values) f += random.below(3) == 0 ? Rational(0) : random.between(Rational(1, 50), 1);

  const auto contact = solved_contact(base, method);
  if (!contact) return add_unsolved("solution", seed, method);
  const auto compare = [&](const std::string& law, const std::optional<SolvedContact>& one,
                           const std::optional<SolvedContact>& other, const auto& of) {
    if (!one || !other) return add_unsolved(law, seed, method);
    add(law, seed, method, of(*one, *other));
  };
  const auto most = [](int m) {
    return [m](const SolvedContact& one, const SolvedContact& other) { return crossing_law(one, other, m); };
  };
  const auto frictions = [&](const ContactProblem& problem, const std::optional<SolvedContact>& less) {
    const auto more = solved_contact(problem.with_friction(FrictionProfile(values, base.friction().jumps())), method);
    const bool s_grows = base.sliding() == Sliding::plus_x;
    const std::string law = problem.load_at() ? "friction, tilting" : "friction";
    compare(law, s_grows ? more : less, s_grows ? less : more, friction_law);
  };

  add("components", seed, method, {{"above bound", components_of(*contact) - static_cast<int>(most_components(base))}});
  const auto pressed = solved_contact(base.with_load(base.load() * growth), method);
  compare("load", pressed, contact, load_law);
  const auto turned = solved_contact(with_profile_plus(base, Polynomial({0, slope})), method);
  compare("attitude", turned, contact, attitude_law);
  compare("attitude and load", turned, pressed, most(1));
  compare("parabola and load", solved_contact(with_profile_plus(base, Polynomial({0, slope, curve})), method), pressed,
          most(2));
  frictions(base, contact);

  // A line of action between the centre of pressure and half the way to an end of contact.
  const auto zones = contact->solution->contact();
  const double centre = contact->solution->resultants().centre_of_pressure.value;
  const double end = part < 0 ? zones.front().left.x.value : zones.back().right.x.value;
  const ContactProblem tilting =
      with_load_at(base, Rational(centre + std::abs(part.convert_to<double>()) * (end - centre)));
  const auto tilted = solved_contact(tilting, method);
  if (!tilted) return add_unsolved("solution that tilts", seed, method);
  compare("load, tilting", solved_contact(tilting.with_load(base.load() * growth), method), tilted, most(1));
  frictions(tilting, tilted);
  const auto tilt = tilt_by_bracketing(tilting, method);
  if (!tilt) return add_unsolved("tilt by bracketing", seed, method);
  const Estimate<double> expected = *tilted->solution->tilt();
  const double difference = std::abs(*tilt - expected.value) - 4 * expected.error;
  add("tilt by bracketing", seed, method, {{"difference", difference / to_real<double>(usual_slope(base)) - 1e-6}});
}

bool Study::print() const {
  std::cout << std::left << std::setw(36) << "law" << std::setw(17) << "method" << std::right << std::setw(9)
            << "compared" << std::setw(9) << "unsolved" << std::setw(8) << "failed" << std::setw(17)
            << "smallest margin"
            << "  seed\n";
  bool good = !tallies_.empty();
  for (const auto& [key, t] : tallies_) {
    std::cout << std::left << std::setw(36) << key.first << std::setw(17) << name_of(key.second) << std::right
              << std::setw(9) << t.compared << std::setw(9) << t.unsolved << std::setw(8) << t.failed;
    if (t.compared > 0) std::cout << std::setw(17) << std::setprecision(3) << t.margin << "  " << t.seed;
    std::cout << '\n';
    good = good && t.failed == 0;
  }
  return good;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: contact_laws FIRST COUNT\n";
    return 2;
  }
  const std::uint64_t first = testing::first_listed_seed + std::strtoull(arguments[1], nullptr, 10);
  const std::uint64_t last = first + std::strtoull(arguments[2], nullptr, 10);
  Study study;
  for (std::uint64_t seed = first; seed < last; ++seed) study.examine(seed);
  return study.print() ? 0 : 1;
}
