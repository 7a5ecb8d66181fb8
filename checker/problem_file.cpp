// The checker's own reader of problem files. It follows docs/problem-file.md.

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "checker/problem.hpp"
#include "checker/reader.hpp"

namespace steadyslide::checker {
namespace {

/// A polynomial in x with + - * / ^ and parentheses.
class PolynomialText {
 public:
  explicit PolynomialText(const Reader& at) : text_(at.string()), place_(at.place()) {}

  Polynomial read() {
    if (text_.size() > 10000) fail("too long");
    Polynomial result = sum();
    if (next() != '\0') fail("unexpected character");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Malformed(place_, what + " at character " + std::to_string(at_ + 1), "a profile is a polynomial in x", text_);
  }
  char next() {
    at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char symbol) {
    const bool there = next() == symbol;
    at_ += there ? 1 : 0;
    return there;
  }
  std::string match(const char* pattern) {
    next();
    std::smatch found;
    const auto from = text_.cbegin() + static_cast<std::ptrdiff_t>(at_);
    std::regex_search(from, text_.cend(), found, std::regex(pattern), std::regex_constants::match_continuous);
    at_ += found.str().size();
    return found.str();
  }
  const Polynomial& limited(const Polynomial& p) const {
    if (p.size() > 65) fail("degree above 64");
    return p;
  }
  Polynomial sum() {
    Polynomial result = product();
    while (next() == '+' || next() == '-') {
      const Polynomial sign{accept('+') ? 1 : -1};
      at_ += sign[0].sign() < 0 ? 1 : 0;
      result = result + sign * product();
    }
    return result;
  }
  Polynomial product() {
    Polynomial result = factor();
    while (true) {
      if (accept('*')) {
        result = limited(result * factor());
      } else if (accept('/')) {
        const Polynomial divisor = factor();
        if (divisor.size() != 1) fail("division by what is no number but 0");
        result = result * Polynomial{Rational(1) / divisor[0]};
      } else {
        return result;
      }
    }
  }
  Polynomial factor() {
    const bool negative = accept('-');
    if (!negative) accept('+');
    Polynomial result = atom();
    if (accept('^')) {
      const std::string exponent = match("[0-9]{1,3}");
      if (exponent.empty()) fail("no exponent from 0 to 999");
      const Polynomial base = result;
      result = {1};
      for (int k = std::stoi(exponent); k > 0; --k) result = limited(result * base);
    }
    return negative ? result * Polynomial{-1} : result;
  }
  Polynomial atom() {
    if (accept('x')) return {0, 1};
    if (accept('(')) {
      if (++nesting_ > 100) fail("too many parentheses");
      Polynomial inside = sum();
      if (!accept(')')) fail("missing )");
      --nesting_;
      return inside;
    }
    const std::string number = match("[0-9.]+([eE][-+]?[0-9]+)?");
    if (number.empty()) fail("expected a number, x or (");
    return trimmed({Rational::parse(number, place_)});
  }

  std::string text_;
  std::string place_;
  std::size_t at_ = 0;
  int nesting_ = 0;
};

/// Reads a measured trace: straight lines between the points x, psi, one point on each line, restricted to the support.
void read_trace(const std::string& name, const std::vector<Rational>& support, Problem& p) {
  std::istringstream text(read_file(name));
  const std::regex point("(?:\xef\xbb\xbf)?\\s*([-+.0-9eE/]+)(?:\\s*[;,]\\s*|\\s+)([-+.0-9eE/]+)\\s*(?:#.*)?");
  const std::regex empty("(?:\xef\xbb\xbf)?\\s*(?:#.*)?");
  const std::regex header("(?:\xef\xbb\xbf)?\\s*[^-+.0-9\\s].*");
  std::vector<std::pair<Rational, Rational>> points;
  std::size_t number = 0;
  bool first = true;
  for (std::string line; std::getline(text, line);) {
    const std::string place = name + ":" + std::to_string(++number);
    std::smatch found;
    if (line.size() > 1000) throw Malformed(place, "line too long", "it has at most 1000 characters", line);
    if (std::regex_match(line, empty) || (std::exchange(first, false) && std::regex_match(line, header))) continue;
    if (!std::regex_match(line, found, point)) throw Malformed(place, "not a point", "a line has x and psi", line);
    points.emplace_back(Rational::parse(found[1], place), Rational::parse(found[2], place));
    if (points.size() > 1 && points.back().first <= points[points.size() - 2].first) {
      throw Malformed(place, "points not in order", "x increases from line to line", line);
    }
  }
  if (points.size() < 2) throw Malformed(name, "too few points", "a trace has at least two", "fewer");
  p.left = support.empty() ? points.front().first : support[0];
  const Rational right = support.empty() ? points.back().first : support[1];
  if (p.left < points.front().first || right > points.back().first) {
    throw Malformed(name, "support beyond the samples", "they reach over all of it", p.left.text());
  }
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto& [x, height] = points[k];
    const auto& [before, height_before] = points[k - 1];
    if (x <= p.left || before >= right) continue;
    const Rational slope = (height - height_before) / (x - before);
    p.pieces.push_back({std::min(x, right), trimmed({height - slope * x, slope})});
  }
}

void read_indenter(const Reader& indenter, const std::string& name, Problem& p) {
  indenter.check_keys({}, {"support", "profile", "pieces", "samples", "harmonics", "elastic"});
  std::vector<Rational> support;
  if (indenter.has("support")) support = indenter["support"].rationals();
  if (!support.empty() && support.size() != 2) indenter["support"].fail("wrong number of ends", "it is [left, right]");
  if (int(indenter.has("profile")) + int(indenter.has("pieces")) + int(indenter.has("samples")) +
          int(indenter.has("harmonics")) !=
      1) {
    indenter.fail("no profile, or several", "it has exactly one of profile, pieces, samples, harmonics");
  }
  p.left = support.empty() ? Rational(-1) : support[0];
  const Rational right = support.empty() ? Rational(1) : support[1];
  if (indenter.has("samples")) {
    const std::filesystem::path beside = std::filesystem::path(name).parent_path();
    read_trace((beside / indenter["samples"].string()).string(), support, p);
  } else if (indenter.has("harmonics")) {
    if (p.period.sign() == 0) indenter.fail("harmonics without a period", "half_space has it");
    p.pieces.push_back({right, {}});
    p.read_harmonics(indenter["harmonics"]);
  } else if (indenter.has("profile")) {
    p.pieces.push_back({right, PolynomialText(indenter["profile"]).read()});
  } else {
    for (const Reader& piece : indenter["pieces"].list()) {
      piece.check_keys({"to", "profile"});
      p.pieces.push_back({piece["to"].rational(), PolynomialText(piece["profile"]).read()});
    }
    if (p.pieces.empty() || p.pieces.back().to != right) {
      indenter["pieces"].fail("pieces that do not fill the support", "the last one ends at its right end");
    }
  }
}

/// Reads both bodies and computes gamma and c: kappa = 3 - 4 nu or (3 - nu)/(1 + nu), mu = E/(2 (1 + nu)). A rigid
/// indenter is the limit of a large mu.
void read_bodies(const Reader& file, Problem& p) {
  const Reader body = file["half_space"];
  const bool elastic = file["indenter"].has("elastic");
  if (body.has("period")) p.period = body["period"].rational();
  if (body.has("period") && p.period.sign() <= 0) body["period"].fail("out of range", "it is positive");
  if (body.has("gamma")) {
    body.check_keys({"gamma"}, {"period"});
    if (elastic) body.fail("conflicting keys", "with gamma the data are reduced, and the indenter has no others");
    p.gamma = body["gamma"].rational();
    p.compliance = 1;
    return;
  }
  body.check_keys({"poisson"}, {"young", "plane", "period"});
  const bool strain = !body.has("plane") || body["plane"].choice({"strain", "stress"}) == 0;
  const auto constants = [&](const Reader& table) {
    const Rational nu = table["poisson"].rational();
    const Rational young = table.has("young") ? table["young"].rational() : Rational(1);
    if (nu <= -1 || nu + nu >= 1 || young.sign() <= 0) table.fail("out of range", "-1 < poisson < 1/2, young > 0");
    const Rational kappa = strain ? Rational(3) - Rational(4) * nu : (Rational(3) - nu) / (nu + 1);
    return std::pair(kappa, young / (Rational(2) * (nu + 1)));
  };
  const auto [kappa, mu] = constants(body);
  p.gamma = (kappa - 1) / (kappa + 1);
  p.compliance = (kappa + 1) / (Rational(4) * mu);
  if (!elastic) return;
  file["indenter"]["elastic"].check_keys({"poisson", "young"});
  const auto [kappa_2, mu_2] = constants(file["indenter"]["elastic"]);
  p.gamma = (mu_2 * (kappa - 1) - mu * (kappa_2 - 1)) / (mu_2 * (kappa + 1) + mu * (kappa_2 + 1));
  p.compliance = p.compliance + (kappa_2 + 1) / (Rational(4) * mu_2);
}

}  // namespace

Problem Problem::of_file(const std::string& name) {
  const Reader file = Reader::of_toml(read_file(name), name);
  file.check_keys({"load", "half_space", "friction", "indenter"}, {"load_at", "sliding", "units"});
  Problem p;
  p.loads = {file["load"].rational(), file["load"].rational()};
  if (file.has("load_at")) p.load_at = file["load_at"].rational();
  p.slides_to_plus_x = !file.has("sliding") || file["sliding"].choice({"+x", "-x"}) == 0;
  file["friction"].check_keys({"values"}, {"jumps"});
  p.friction = file["friction"]["values"].rationals();
  if (file["friction"].has("jumps")) p.jumps = file["friction"]["jumps"].rationals();
  read_bodies(file, p);
  read_indenter(file["indenter"], name, p);
  p.check(name);
  return p;
}

}  // namespace steadyslide::checker
