// make_certificate PROBLEM [DIGITS | everywhere | cells N | FROM TO BOXES] > CERTIFICATE: a certificate for tests, from what the
// Riemann-Hilbert solver finds and enclosure/ proves, to 50 digits or these. With "everywhere" it claims contact all over
// the support. With loads from FROM to TO each box is as wide as the solution moves over its part of them. What is
// written is no proof; that is what steadyslide-check is asked for. PROBLEM is a problem file, or random:N for the N-th
// random problem; the certifier's time goes to the standard error.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "enclosure/contact/contact_proof.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/proof/certificate.hpp"
#include "model/uniqueness.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"
#include "support/random_contact.hpp"

namespace {

using namespace steadyslide;
using namespace steadyslide::enclosure;
using nlohmann::json;
using Kind = ContactTopology::Kind;

json texts(const std::vector<Rational>& numbers) {
  json result = json::array();
  for (const Rational& number : numbers) result.push_back(to_string(number));
  return result;
}

json problem_json(const ContactProblem& problem) {
  json pieces = json::array();
  for (const Indenter::Piece& piece : problem.indenter().pieces()) {
    pieces.push_back({{"to", to_string(piece.to)}, {"profile", texts(piece.profile.coefficients())}});
  }
  return {{"load", to_string(problem.load())},
          {"load_at", problem.load_at() ? json(to_string(*problem.load_at())) : json(nullptr)},
          {"sliding", problem.sliding() == Sliding::plus_x ? "+x" : "-x"},
          {"gamma", to_string(problem.elasticity().gamma())},
          {"compliance", to_string(problem.elasticity().compliance())},
          {"friction", {{"values", texts(problem.friction().values())}, {"jumps", texts(problem.friction().jumps())}}},
          {"indenter", {{"left", to_string(problem.indenter().left())}, {"pieces", pieces}}}};
}

/// The points, and the balls of the box.
json box_json(const ContactBox& box, bool tilts) {
  json result{{"points", json::array()}, {"segments", json::array()}, {"q", json::array()}};
  std::size_t free = 0;
  bool contact = false;
  for (const ContactTopology::Point& point : box.topology.points) {
    if (!result["points"].empty()) result["segments"].push_back(contact);
    json written{{"anchor", point.anchor}};
    written["contact"] = point.kind == Kind::begins ? "begins"
                         : point.kind == Kind::ends ? "ends"
                         : contact                  ? "interior"
                                                    : "outside";
    if (point.is_end()) written["free"] = point.vanishes;
    if (point.beside) {
      written["side"] = *point.beside == Side::left ? "left" : "right";
      written["log_offset"] = box.log_offsets[free++].dump();
    }
    if (point.is_end()) contact = point.kind == Kind::begins;
    result["points"].push_back(written);
  }
  for (const Ball& coefficient : box.q) result["q"].push_back(coefficient.dump());
  if (tilts) result["tilt"] = box.tilt.dump();
  return result;
}

/// A certificate but for its boxes; the frame and the bits are the proof's.
json document(const ContactProblem& problem, const ContactProof& proof) {
  return {{"certificate", 1},
          {"kind", "solution"},
          {"generator", "make-certificate 1.0.0"},
          {"problem", problem_json(problem)},
          {"frame", {{"origin", to_string(proof.problem.frame.origin)}, {"unit", to_string(proof.problem.frame.unit)}}},
          {"bits", proof.bits},
          {"claims", {{"exists", true}, {"unique_by_theorem_1", uniqueness(problem).proved}}}};
}

ContactProof proof_of(const ContactProblem& problem, int digits) {
  const auto solution = numeric::riemann_hilbert<double>(problem).solution;
  if (!solution) throw std::runtime_error("not solved");
  const std::clock_t start = std::clock();
  const ContactProof proof = prove_contact(problem, solution->approximate_contact(), digits);
  std::fprintf(stderr, "certifier: %.3f s\n", static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  if (!proof.proved) throw std::runtime_error("not proved: " + proof.reason);
  return proof;
}

/// 10^-digits of the unknown, or of 1, wider: as docs/certificate.md has it.
ContactBox widened(ContactBox box, int digits) {
  const auto widen = [&](Ball& x) {
    const Ball unit = power(Ball(10, x.bits()), -digits);
    x = Ball::plus_or_minus(x, unit * max(abs(x), Ball(1)));
  };
  std::ranges::for_each(box.log_offsets, widen);
  std::ranges::for_each(box.q, widen);
  widen(box.tilt);
  return box;
}

/// Around the solution at the middle load: twice as wide as it moves over the loads, and as the square of what moves most,
/// for the conditions are not linear.
ContactBox around(const ContactProof& middle, const ContactProof& a, const ContactProof& b) {
  ContactBox box = middle.box;
  Ball most(0, middle.bits);
  const auto moved = [&](const Ball& x, const Ball& y, const Ball& z) { return max(abs(y - x), abs(z - x)).upper(); };
  const auto each = [&](const auto& visit) {
    for (std::size_t k = 0; k < box.log_offsets.size(); ++k) {
      visit(box.log_offsets[k], a.box.log_offsets[k], b.box.log_offsets[k]);
    }
    for (std::size_t k = 0; k < box.q.size(); ++k) visit(box.q[k], a.box.q[k], b.box.q[k]);
    visit(box.tilt, a.box.tilt, b.box.tilt);
  };
  each([&](const Ball& x, const Ball& y, const Ball& z) { most = max(most, moved(x, y, z)); });
  each([&](Ball& x, const Ball& y, const Ball& z) {
    x = Ball::around(x, Ball(2, middle.bits) * moved(x, y, z) + most * most);
  });
  return box;
}

json loads_certificate(const ContactProblem& problem, const Rational& from, const Rational& to, int boxes) {
  json result = document(problem, proof_of(problem.with_load((from + to) / 2), 20));
  result["kind"] = "loads";
  result["problem"].erase("load");
  result["problem"]["loads"] = texts({from, to});
  for (int i = 0; i < boxes; ++i) {
    const Rational a = from + (to - from) * i / boxes;
    const Rational b = from + (to - from) * (i + 1) / boxes;
    std::vector<ContactProof> proofs;
    for (const Rational& load : {Rational((a + b) / 2), a, b}) {
      proofs.push_back(proof_of(problem.with_load(load), 20));
      if (proofs.back().box.topology != proofs.front().box.topology) throw std::runtime_error("an event in between");
    }
    const ContactBox box = around(proofs[0], proofs[1], proofs[2]);
    json written = box_json(box, problem.load_at().has_value());
    written["loads"] = texts({a, b});
    result["boxes"].push_back(written);
  }
  return result;
}

json cells_certificate(const ContactProblem& problem, std::size_t cells) {
  const auto found = numeric::variational_inequality(problem, {.cells = cells});
  if (!found.solution) throw std::runtime_error(found.reason);
  const auto& on_cells = dynamic_cast<const numeric::VariationalSolution&>(*found.solution);
  const CellBound bound = bound_cells(problem, on_cells.touching_pressures());
  if (!bound.proved) throw std::runtime_error(bound.reason);
  return json::parse(library::certificate(problem, bound));
}

json make(const std::vector<std::string>& words) {
  const bool random = words.at(0).starts_with("random:");
  const ContactProblem problem =
      random ? testing::random_contact(testing::first_listed_seed + std::stoul(words[0].substr(7)))
             : library::read_problem(words[0]).contact;
  if (words.size() == 4) {
    return loads_certificate(problem, parse_rational(words[1]), parse_rational(words[2]), std::stoi(words[3]));
  }
  if (words.size() == 3 && words[1] == "cells") return cells_certificate(problem, std::stoul(words[2]));
  const bool everywhere = words.size() == 2 && words[1] == "everywhere";
  const int digits = words.size() == 2 && !everywhere ? std::stoi(words[1]) : 50;
  const ApproximateContact full{{{problem.indenter().left()}, {problem.indenter().right()}}};
  const ContactProof proof = everywhere ? prove_contact(problem, full, digits) : proof_of(problem, digits);
  json result = document(problem, proof);
  result.update(box_json(widened(proof.box, digits), problem.load_at().has_value()));
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    std::puts(make({arguments + 1, arguments + count}).dump(1).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_certificate: %s\n", error.what());
    return 2;
  }
}
