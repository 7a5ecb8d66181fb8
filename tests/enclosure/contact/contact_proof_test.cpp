// Proofs of contact solutions, and refusals of wrong ones, starting from the result of the Riemann-Hilbert solver.

#include <set>

#include "enclosure/contact/contact_proof.hpp"
#include "enclosure/contact/enclosed_solution.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"
#include "support/random_contact.hpp"

namespace {

using namespace steadyslide::enclosure;
using Kind = ContactTopology::Kind;

/// psi = -|x|/5 on [-1, 1], nu = 0.2, f = 0.1 | 0.5: a notch whose corner is where friction rises.
ContactProblem notch(const Rational& load) {
  return {Elasticity(Solid(0.2_r, 1)), FrictionProfile({0.1_r, 0.5_r}, {0}), roof(0.2_r, -0.2_r), load};
}
/// From this load on there is full contact: the amplitude of the traction's power at the corner is 0. Found by two
/// independent computations; the compliance of these data is 1.92.
const Rational full_contact_from = 8.308222888593932767_r / 1.92_r;

const ApproximateContact everywhere{{{-1}, {1}}};

/// Checks that the two agree within the error of double.
void agrees(const Ball& enclosed, const Estimate<double>& estimate, double scale = 0) {
  REQUIRE(enclosed.is_finite());
  CHECK(enclosed.to_double() ==
        doctest::Approx(estimate.value).epsilon(1e-7).scale(scale + std::abs(estimate.value) + 1e-12));
}

void agrees_in_the_limit(const Ball& enclosed, const Estimate<double>& estimate, double scale) {
  if (!std::isinf(estimate.value)) return agrees(enclosed, estimate, scale);
  CHECK(enclosed.is_infinity());
  CHECK((enclosed.to_double() > 0) == (estimate.value > 0));
}

/// Compares tractions, slopes and gaps inside the support, beside it and at places of the data.
void agrees_at_places(const ContactProblem& problem, const EnclosedSolution& enclosed,
                      const ContactSolution<double>& solution) {
  const auto found = solution.contact();
  const double length = found.back().right.x.value - found.front().left.x.value;
  const double mean = static_cast<double>(problem.load()) / length;
  const Rational left = problem.indenter().left(), width = problem.indenter().right() - left;
  std::vector<Rational> places{left, left + width};
  for (int i = -3; i < 42; i += 2) places.push_back(left + width * Rational(i, 38));
  for (const Rational& jump : problem.friction().jumps()) places.push_back(jump);
  for (const Indenter::Piece& piece : problem.indenter().pieces()) places.push_back(piece.to);
  for (const Rational& x : places) {
    CAPTURE(to_string(x));
    const Sample<double> sample = solution.at(x);
    agrees_in_the_limit(enclosed.traction(x).left, sample.traction.left, mean);
    agrees_in_the_limit(enclosed.traction(x).right, sample.traction.right, mean);
    agrees_in_the_limit(enclosed.slope(x).left, sample.slope.left, 1);
    agrees_in_the_limit(enclosed.slope(x).right, sample.slope.right, 1);
    const std::optional<Ball> gap = enclosed.gap(x);
    REQUIRE(gap.has_value() == sample.gap.has_value());
    if (gap) agrees(*gap, *sample.gap, length);
  }
}

/// Returns the proof, and compares its numbers with those in double.
ContactProof proved_beside(const ContactProblem& problem, const ContactSolution<double>& solution, int digits) {
  const ContactProof proof = prove_contact(problem, solution.approximate_contact(), digits);
  if (!proof.proved) return proof;
  const EnclosedSolution enclosed(problem, proof);
  const auto resultants = enclosed.resultants();
  const auto estimated = solution.resultants();
  CHECK(resultants.normal.contains(problem.load()));
  CHECK(resultants.normal.radius() < Ball(problem.load(), 64) * power(Ball(10, 64), -digits + 8));
  agrees(resultants.effective_friction, estimated.effective_friction);
  const auto zones = enclosed.contact();
  const auto found = solution.contact();
  REQUIRE(zones.size() == found.size());
  const double length = found.back().right.x.value - found.front().left.x.value;
  agrees(resultants.centre_of_pressure, estimated.centre_of_pressure, length);
  const auto ends_agree = [&](const auto& end, const auto& estimate) {
    CHECK(end.kind == estimate.kind);
    CHECK(end.exponent == estimate.exponent);
    agrees(end.x, estimate.x, length);
    agrees(end.intensity, estimate.intensity);
  };
  for (std::size_t k = 0; k < zones.size(); ++k) {
    ends_agree(zones[k].left, found[k].left);
    ends_agree(zones[k].right, found[k].right);
  }
  const std::vector<SolvedSingularPoint<double>> singular = solution.singular_points();
  const auto points = enclosed.singular_points();
  REQUIRE(points.size() == singular.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    CHECK(points[k].kind == singular[k].kind);
    CHECK(points[k].exponent == singular[k].exponent);
    agrees(points[k].x, singular[k].x, length);
    agrees(points[k].intensity, singular[k].intensity);
    agrees(points[k].constant, singular[k].constant, std::abs(singular[k].intensity.value));
  }
  REQUIRE(enclosed.tilt().has_value() == solution.tilt().has_value());
  if (solution.tilt()) agrees(*enclosed.tilt(), *solution.tilt());
  return proof;
}

void proves_notches(std::initializer_list<const char*> parts) {
  std::vector<double> laws;
  for (const char* part : parts) {
    CAPTURE(part);
    const ContactProblem problem = notch(full_contact_from * parse_rational(part));
    const ContactProof full = prove_contact(problem, everywhere, 30);
    CHECK_FALSE(full.proved);
    CHECK(full.refuted);
    CHECK(full.reason == "the traction's leading term pulls");
    CHECK(full.where == 0);

    const auto solution = riemann_hilbert<double>(problem).solution;
    REQUIRE(solution);
    const ContactProof proof = prove_contact(problem, solution->approximate_contact(), 30);
    CHECK_MESSAGE(proof.proved, proof.reason);
    REQUIRE(proof.box.log_offsets.size() == 2);
    // The gap is (C (1 - P/P_c))^(-1/beta) near P_c.
    const Ball beta(jump_exponent(problem.coupled_friction(0), problem.coupled_friction(1)), 64);
    laws.push_back((-beta * proof.box.log_offsets[0]).to_double() - std::log(1 - std::stod(part)));
  }
  CHECK(laws.back() == doctest::Approx(laws[laws.size() - 2]).epsilon(1e-3));
  const ContactProof above = prove_contact(notch(full_contact_from * 1.000001_r), everywhere, 30);
  CHECK_MESSAGE(above.proved, above.reason);
}

}  // namespace

TEST_CASE("a notch over a rising jump: below the threshold a gap is proved, and full contact refuted") {
  proves_notches({"0.5", "0.7", "0.9"});
}

TEST_CASE("slow: a notch whose gap is 1e-43 to 1e-127 of the contact" * doctest::skip()) {
  proves_notches({"0.6", "0.99", "0.999", "0.999999"});
}

TEST_CASE("an unbounded term decides a sign only from where it exceeds the rest") {
  const auto sign = [](int regular, const Ball& coefficient, int least) {
    return LocalValue{Ball(regular, 64), coefficient, Ball::unknown(64), Ball(least, 64), true}.sign();
  };
  CHECK(sign(-5, Ball(1, 64), 6) == 1);
  CHECK(sign(-5, Ball(1, 64), 2) == 0);
  CHECK(sign(5, Ball(-1, 64), 6) == -1);
  CHECK(sign(5, Ball(-1, 64), 5) == 0);
  CHECK(sign(5, Ball::plus_or_minus(Ball(0, 64), Ball(1, 64)), 6) == 0);
}

namespace {

/// A wedge over a jump of friction from 0.1.
ContactProblem hardly_jumping(const Rational& friction) {
  return {Elasticity(Solid(0.3_r, 1)), FrictionProfile({0.1_r, friction}, {0}), roof(-0.2_r, 0.2_r), 0.5_r,
          Sliding::minus_x};
}

}  // namespace

TEST_CASE("friction that hardly jumps under a wedge: proved, and quickly") {
  for (const char* friction : {"0.10000000000001", "0.099999999999", "0.09999999999999",
                               "0.1000000000000000000000000000001", "0.0999999999999999999999999999999"}) {
    CAPTURE(friction);
    const ContactProblem problem = hardly_jumping(parse_rational(friction));
    const ContactProof proof = prove_contact(problem, everywhere, 16);
    CHECK_MESSAGE(proof.proved, proof.reason);
    CHECK(proof.intervals < 100);
    if (!proof.proved) continue;
    const auto shares = EnclosedSolution(problem, proof).resultants().load_share;
    CHECK(shares[0].to_double() == doctest::Approx(0.484738159279393).epsilon(1e-12));
    CHECK(shares[0].radius() < power(Ball(10, 64), -16));
  }
}

TEST_CASE("a proof ends where its budget is spent, and says where") {
  const ContactProblem problem = reduced({0.1_r, 0.6_r}, {0}, two_wells(), 4);
  const auto solution = riemann_hilbert<double>(problem).solution;
  REQUIRE(solution);
  const ApproximateContact contact = solution->approximate_contact();
  WorkBudget enough;
  CHECK(prove_contact(problem, contact, 16, enough).proved);
  const std::int64_t needed = WorkBudget::usual - enough.left();
  CHECK(needed < WorkBudget::usual / 20);
  std::set<std::string> reasons;
  for (const int percent : {1, 5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 95, 99}) {
    WorkBudget work(needed * percent / 100);
    const ContactProof proof = prove_contact(problem, contact, 16, work);
    if (proof.proved) continue;
    CHECK_FALSE(proof.refuted);
    CHECK(work.is_spent());
    CHECK(holds(proof.reason, "budget of work"));
    if (holds(proof.reason, "sign")) CHECK(proof.where.has_value());
    reasons.insert(proof.reason);
  }
  CHECK(reasons.size() > 1);
  // The signs are also close: p = (1 + pi a (2 x^2 - 1))/(pi sqrt(1 - x^2)) is only just positive at 0.
  const ContactProblem hollow = reduced({0}, {}, one_piece(-1, 1, {0, 0, -0.318309567_r}), 1);
  WorkBudget room;
  CHECK(prove_contact(hollow, everywhere, 16, room).proved);
  WorkBudget half((WorkBudget::usual - room.left()) / 2);
  const ContactProof proof = prove_contact(hollow, everywhere, 16, half);
  CHECK_FALSE(proof.proved);
  CHECK(proof.reason == "the traction's sign is not decided within the budget of work");
  CHECK(std::abs(proof.where.value()) < 0.5);
}

TEST_CASE("the many panels beside a very short piece of contact are counted in the budget") {
  // The solver fails for this contact, which ends 1e-170 beyond a notch.
  const ContactProblem problem = random_contact(21060008, ContactFamily::notches);
  const ApproximateContact contact = riemann_hilbert<double>(problem).solution->approximate_contact();
  WorkBudget work(WorkBudget::usual / 50);
  const ContactProof proof = prove_contact(problem, contact, 16, work);
  CHECK_FALSE(proof.proved);
  CHECK(proof.reason == "the budget of work is spent before Newton's method has converged");
}

TEST_CASE("slow: twenty bowls under two frictions are proved with 50 digits" * doctest::skip()) {
  std::vector<Indenter::Piece> bowls;
  for (int k = 0; k < 20; ++k) {
    const Rational centre = Rational(2 * k - 19) / 20;
    bowls.push_back({centre + 0.05_r, Polynomial({centre * centre, -2 * centre, 1})});
  }
  const ContactProblem problem(Elasticity(Solid(0.3_r, 1)), FrictionProfile({0.2_r, 0.5_r}, {0.01_r}),
                               Indenter(-1, bowls), 0.001_r);
  const auto solution = riemann_hilbert<Real50>(problem).solution;
  REQUIRE(solution->contact().size() == 20);
  // The proof takes 105 million units.
  WorkBudget work(150'000'000);
  const ContactProof proof = prove_contact(problem, solution->approximate_contact(), 50, work);
  CHECK_MESSAGE(proof.proved, proof.reason);
}

TEST_CASE("a gap that almost closes is decided with little work, where it is lowest in between and where it falls") {
  // Under 0.188034223129743829393...  the second bowl touches, under 0.302786423542875... the end of the lifted face.
  const Indenter bowls(-1, {{0.5_r, Polynomial({0, 0, 1})}, {2, Polynomial({1.6_r, -2.4_r, 1})}});
  const Indenter foot(-1, {{0, Polynomial()}, {1, Polynomial({0.3_r})}});
  const Elasticity body(Solid(0.2_r, 1));
  // The budget is too small if cells use the range of the slope instead of its change.
  for (const auto& [problem, enough] :
       {std::pair(reduced({0.3_r}, {}, bowls, 0.188034223129_r), 200'000),
        {reduced({0.3_r}, {}, bowls, 0.188034223129743829_r), 200'000},
        {ContactProblem(body, FrictionProfile({0.3_r}), foot, 0.302786423542_r), 20'000},
        {ContactProblem(body, FrictionProfile({0.3_r}), foot, 0.302786423542875_r), 20'000}}) {
    const auto solution = riemann_hilbert<Real50>(problem).solution;
    REQUIRE(solution->contact().size() == 1);
    WorkBudget work(enough);
    const ContactProof proof = prove_contact(problem, solution->approximate_contact(), 16, work);
    CHECK_MESSAGE(proof.proved, proof.reason);
  }
}

TEST_CASE("a gap that grows from the contact's end on is not positive beyond a step towards the body") {
  const auto profile = [](const Rational& height) {
    return Indenter(-1, {{0.5_r, Polynomial({0, 0, 2.5_r})}, {1, Polynomial({height, 0, 2.5_r})}});
  };
  const ContactProblem whole = reduced({0.1_r, 0.3_r}, {0}, profile(0), 0.2_r);
  const auto solution = riemann_hilbert<double>(whole).solution;
  REQUIRE(solution);
  // A step slightly larger than the gap, and a profile that rises again beyond it: the surfaces penetrate on a short
  // stretch.
  const Rational gap(solution->at(0.5_r).gap.value().value);
  for (const auto& [height, proved] :
       {std::pair(0_r, true), {5_r, true}, {-5_r, false}, {-gap * 0.98_r, true}, {-gap * 1.02_r, false}}) {
    const ContactProblem problem = reduced({0.1_r, 0.3_r}, {0}, profile(height), 0.2_r);
    ApproximateContact contact;
    const auto zone = solution->contact().front();
    for (const double x : {zone.left.x.value, zone.right.x.value}) {
      contact.ends.push_back(ApproximateContact::free_end(problem, Rational(x)));
    }
    const ContactProof proof = prove_contact(problem, contact, 16);
    CHECK_MESSAGE(proof.proved == proved, proof.reason);
    if (!proved) CHECK(proof.reason == "the surfaces penetrate");
  }
}

TEST_CASE("no contact over a step of the profile is proved") {
  // A flat profile with a step, beside which friction jumps. The slopes and tractions of full contact do not show the
  // step.
  const auto punch = [](const Rational& step) {
    const Indenter indenter(-1, {{0.25_r, Polynomial({0})}, {1, Polynomial({step})}});
    return reduced({0.1_r, 0.3_r}, {0.2500001_r}, indenter, 1);
  };
  CHECK(prove_contact(punch(0), everywhere, 16).proved);
  for (const Rational& step : {1e-9_r, -1e-9_r}) {
    const ContactProof proof = prove_contact(punch(step), everywhere, 16);
    CHECK_FALSE(proof.proved);
    CHECK(proof.reason == "contact over a step of the profile");
  }
}

TEST_CASE("closed forms are proved: punches with jumps, parabolas over jumps") {
  for (const ContactProblem& problem : {reduced({0.1_r, 0.5_r, 0.2_r}, {-0.3_r, 0.4_r}, one_piece(-1, 1, {}), 1),
                                        reduced({0.1_r, 0.6_r}, {0}, one_piece(-1, 1, {0, 0, 2.5_r}), 1)}) {
    const auto solution = closed_form<double>(problem).solution;
    REQUIRE(solution);
    const ContactProof proof = proved_beside(problem, *solution, 50);
    REQUIRE_MESSAGE(proof.proved, proof.reason);
    agrees_at_places(problem, EnclosedSolution(problem, proof), *solution);
  }
}

namespace {

/// Random problems from `first` to before `last`: all of those solved in double are proved, except a few.
void proves_random_problems(int first, int last) {
  int solved = 0, proved = 0;
  for (int i = first; i < last; ++i) {
    CAPTURE(i);
    const ContactProblem problem = random_contact(first_listed_seed + static_cast<std::uint64_t>(i));
    const auto solution = riemann_hilbert<double>(problem).solution;
    if (!solution || !solution->failed_condition().empty()) continue;
    ++solved;
    const ContactProof proof = proved_beside(problem, *solution, 50);
    proved += proof.proved;
    if (proof.proved && i % 4 == 0) agrees_at_places(problem, EnclosedSolution(problem, proof), *solution);
    if (!proof.proved) MESSAGE(i << ": " << proof.reason);
  }
  CHECK(10 * solved >= 9 * (last - first));
  CHECK(100 * proved >= 97 * solved);
}

}  // namespace

TEST_CASE("random problems that the solver solves are proved, and their numbers are its numbers") {
  proves_random_problems(0, 8);
}

// A thousand problems, in parts that run in parallel.
TEST_CASE("slow: random problems 0 to 249" * doctest::skip()) { proves_random_problems(0, 250); }
TEST_CASE("slow: random problems 250 to 499" * doctest::skip()) { proves_random_problems(250, 500); }
TEST_CASE("slow: random problems 500 to 749" * doctest::skip()) { proves_random_problems(500, 750); }
TEST_CASE("slow: random problems 750 to 999" * doctest::skip()) { proves_random_problems(750, 1000); }

namespace {

void refuses_perturbed_boxes(int perturbations) {
  int tried = 0;
  for (int i = 0; tried < perturbations; ++i) {
    const ContactProblem problem = random_contact(first_listed_seed + static_cast<std::uint64_t>(i));
    if (problem.indenter().pieces().size() > 1) continue;  // these take milliseconds each
    const auto solution = riemann_hilbert<double>(problem).solution;
    if (!solution || !solution->failed_condition().empty()) continue;
    const ContactProof proof = prove_contact(problem, solution->approximate_contact(), 50);
    if (!proof.proved || proof.box.log_offsets.empty()) continue;
    CAPTURE(i);
    const Bits bits = proof.bits;
    const auto refused = [&](const ContactBox& box) {
      ++tried;
      CHECK_FALSE(prove_box(proof.problem, box, bits).proved);
    };
    // The box itself, slightly widened, is proved: the others are not refused for lack of a Newton step.
    ContactBox wider = proof.box;
    const auto widen = [&](Ball& x) { x = Ball::around(x, power(Ball(10, bits), -50)); };
    for (Ball& x : wider.log_offsets) widen(x);
    for (Ball& x : wider.q) widen(x);
    if (problem.load_at()) widen(wider.tilt);
    CHECK(prove_box(proof.problem, wider, bits).proved);
    // One end of the box is exactly at the zero: Krawczyk's image reaches beyond it.
    ContactBox halved = wider;
    halved.log_offsets[0] += wider.log_offsets[0].radius();
    refused(halved);
    for (std::size_t f = 0; f < wider.log_offsets.size(); ++f) {
      for (const int sign : {-1, 1}) {
        ContactBox moved = wider;
        moved.log_offsets[f] += Ball(sign, bits) * power(Ball(10, bits), -20);
        refused(moved);
      }
    }
    for (std::size_t j = 0; j < wider.topology.points.size(); ++j) {
      ContactBox other = wider;
      ContactTopology::Point& point = other.topology.points[j];
      if (point.kind == Kind::interior) continue;
      point.vanishes = !point.vanishes;
      if (!point.beside) refused(other);
      // One component less.
      if (point.kind == Kind::begins && wider.topology.movable().size() > 2 && point.beside &&
          wider.topology.points[j + 1].beside) {
        ContactBox dropped = wider;
        const auto first = dropped.topology.points.begin() + static_cast<std::ptrdiff_t>(j);
        dropped.topology.points.erase(first, first + 2);
        refused(dropped);
      }
    }
  }
}

}  // namespace

TEST_CASE("no perturbed box is proved") { refuses_perturbed_boxes(50); }

TEST_CASE("slow: no perturbed box is proved" * doctest::skip()) { refuses_perturbed_boxes(1000); }
