#include "library/proof/certificate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "library/text/number_format.hpp"
#include "library/text/version.hpp"
#include "numeric/periodic/periodic_solution.hpp"

namespace steadyslide::library {
namespace {

using enclosure::Ball;
using Json = nlohmann::ordered_json;

Json exact_numbers(const std::vector<Rational>& values) {
  Json json = Json::array();
  for (const Rational& value : values) json.push_back(exact_text(value));
  return json;
}

Json problem_json(const ContactProblem& problem) {
  Json pieces = Json::array();
  for (const Indenter::Piece& piece : problem.indenter().pieces()) {
    pieces.push_back({{"to", exact_text(piece.to)}, {"profile", exact_numbers(piece.profile.coefficients())}});
  }
  Json json{
      {"load_at", problem.load_at() ? Json(exact_text(*problem.load_at())) : Json()},
      {"sliding", problem.sliding() == Sliding::plus_x ? "+x" : "-x"},
      {"gamma", exact_text(problem.elasticity().gamma())},
      {"compliance", exact_text(problem.elasticity().compliance())},
      {"friction",
       {{"values", exact_numbers(problem.friction().values())}, {"jumps", exact_numbers(problem.friction().jumps())}}},
      {"indenter", {{"left", exact_text(problem.indenter().left())}, {"pieces", std::move(pieces)}}}};
  if (const std::optional<Rational> period = problem.body().period()) {
    json["period"] = exact_text(*period);
    json["harmonics"] = Json::array();
    for (const auto& [n, cosine, sine] : problem.indenter().harmonics())
      json["harmonics"].push_back({{"n", std::to_string(n)}, {"cos", exact_text(cosine)}, {"sin", exact_text(sine)}});
  }
  return json;
}

/// A function that writes a ball.
using WrittenBall = std::function<std::string(const Ball&)>;

/// Adds the contact and the box of its unknowns.
void add_box(Json& json, const enclosure::ContactBox& box, bool tilts, const WrittenBall& written) {
  Json points = Json::array();
  Json segments = Json::array();  // true: contact on the right of the point
  std::size_t unknown = 0;
  bool in_contact = false;
  for (const ContactTopology::Point& point : box.topology.points) {
    Json one{{"anchor", point.anchor}};
    if (point.beside) {
      one["side"] = *point.beside == Side::left ? "left" : "right";
      one["log_offset"] = written(box.log_offsets[unknown++]);
    }
    if (point.is_end()) {
      in_contact = point.kind == ContactTopology::Kind::begins;
      one["contact"] = in_contact ? "begins" : "ends";
      one["free"] = point.vanishes;
    } else {
      one["contact"] = in_contact ? "interior" : "outside";
    }
    points.push_back(std::move(one));
    segments.push_back(in_contact);
  }
  segments.erase(segments.size() - 1);
  json["points"] = std::move(points);
  json["segments"] = std::move(segments);
  json["q"] = Json::array();
  for (const Ball& coefficient : box.q) json["q"].push_back(written(coefficient));
  if (tilts) json["tilt"] = written(box.tilt);
}

Json heading(const char* kind, const ContactProblem& problem) {
  return {{"certificate", 1},
          {"kind", kind},
          {"generator", std::string("steadyslide ") + version},
          {"problem", problem_json(problem)}};
}

Json heading(const char* kind, const ContactProblem& problem, const Frame& frame, enclosure::Bits bits) {
  Json json = heading(kind, problem);
  json["frame"] = {{"origin", exact_text(frame.origin)}, {"unit", exact_text(frame.unit)}};
  json["bits"] = bits;
  return json;
}

/// Return a number near x that is above it (below it) and has few digits. The radius of x is far smaller than the last
/// bit of a double.
std::string above(const Ball& x) { return fmt::format("{}", std::nextafter(x.to_double(), 1e300)); }
std::string below(const Ball& x) { return fmt::format("{}", std::nextafter(x.to_double(), -1e300)); }

/// Returns the interval. Its bounds leave room for another rounding.
Json interval_json(const Ball& ball) {
  const Ball room = ball.radius() / Ball(1000000);
  return {below((ball.lower() - room).lower()), above((ball.upper() + room).upper())};
}

std::string finished(Json json) {
  json["claims"] = {{"exists", true}};
  return json.dump(2) + "\n";
}

/// The digits that the box has beyond those of the claims.
constexpr int guard_digits = 6;

template <numeric::Real R>
PeriodicCertificate certificate_in(const ContactProblem& problem, int digits) {
  const auto found = numeric::periodic_contact<R>(problem);
  if (const auto* reason = std::get_if<std::string>(&found))
    return {"", std::string(no_periodic_certificate) + "; " + *reason};
  const auto& contact = std::get<numeric::PeriodicContact<R>>(found);
  const auto text = [&](const R& value) { return value == 0 ? "0" : full_number(value, digits + guard_digits + 4); };
  const auto interval = [&](const R& value, const Rational& unit) {
    const R width = numeric::to_real<R>(unit) * pow(R(10), -digits);
    return Json{text(value - width), text(value + width)};
  };
  Json traction = Json::array();
  for (std::size_t i = 0; i < contact.traction.tau.size(); ++i) {
    traction.push_back(text(contact.traction.tau[i].re));
    if (contact.traction.parity > 0 || i > 0) traction.push_back(text(contact.traction.tau[i].im));
  }
  const auto end = [&](const Rational& x, bool is_free) {
    return is_free ? text(numeric::to_real<R>(x)) : exact_text(x);
  };
  const Rational period = *problem.body().period();
  const numeric::Resultants<R> resultants = numeric::PeriodicSolution<R>(problem, contact).resultants();
  Json json = heading("periodic", problem);
  json["problem"]["load"] = exact_text(problem.load());
  json["origin"] = exact_text(contact.origin);
  json["ends"] = {end(contact.points.front(), contact.left_is_free), end(contact.points.back(), contact.right_is_free)};
  json["free"] = {contact.left_is_free, contact.right_is_free};
  json["traction"] = std::move(traction);
  json["radius"] = "1e-" + std::to_string(digits + guard_digits);
  json["claims"] = {{"exists", true},
                    {"effective_friction", interval(resultants.effective_friction.value, 1)},
                    {"centre_of_pressure", interval(resultants.centre_of_pressure.value, period)}};
  return {json.dump(2) + "\n", ""};
}

}  // namespace

std::string certificate(const ContactProblem& problem, const enclosure::ContactProof& proof, int digits) {
  Json json = heading("solution", problem, proof.problem.frame, proof.bits);
  json["problem"]["load"] = exact_text(problem.load());
  // The box is wide enough that a checker with other numbers sees it contract, and narrow enough to decide every sign.
  const Ball unit = power(Ball(10, proof.bits), -digits);
  add_box(json, proof.box, problem.load_at().has_value(), [&](const Ball& proved) {
    const Ball width = unit * max(Ball(1), abs(proved));
    return Ball::plus_or_minus(proved, width.upper()).dump();
  });
  return finished(std::move(json));
}

std::string certificate(const ContactProblem& problem, const enclosure::CellBound& bound) {
  Json json = heading("cells", problem);
  json["problem"]["load"] = exact_text(problem.load());
  json["pressures"] = bound.weights;
  json["energy"] = above(bound.energy);
  json["reaches"] = Json::array();
  for (const auto& [left, right] : bound.reaches) json["reaches"].push_back(exact_numbers({left, right}));
  Json shares = Json::array();
  for (const Ball& share : bound.load_share) shares.push_back(interval_json(share));
  json["claims"] = {{"load_share", std::move(shares)}, {"effective_friction", interval_json(bound.effective_friction)}};
  return json.dump() + "\n";
}

std::string certificate(const ContactProblem& problem, const std::vector<enclosure::LoadInterval>& intervals) {
  enclosure::Bits bits = 64;
  const auto written = [&](const Ball& ball) {
    bits = std::max(bits, static_cast<enclosure::Bits>(arb_bits(ball.get())));
    return ball.dump();
  };
  Json boxes = Json::array();
  for (const enclosure::LoadInterval& interval : intervals) {
    Json box{{"loads", exact_numbers({interval.from, interval.to})}};
    add_box(box, interval.box, problem.load_at().has_value(), written);
    boxes.push_back(std::move(box));
  }
  Json json = heading("loads", problem, intervals.front().proof.problem.frame, bits);
  json["problem"]["loads"] = exact_numbers({intervals.front().from, intervals.back().to});
  json["boxes"] = std::move(boxes);
  return finished(std::move(json));
}

PeriodicCertificate periodic_certificate(const ContactProblem& problem, int digits) {
  if (problem.indenter().origin_of_harmonics() != 0) return {"", "the harmonics have another origin than x = 0"};
  digits = std::min(digits, most_periodic_digits);
  return digits <= 30 ? certificate_in<numeric::Real50>(problem, digits)
                      : certificate_in<numeric::Real100>(problem, digits);
}

}  // namespace steadyslide::library
