#include "app/problem_file.hpp"

#include <fmt/format.h>

#include "app/document.hpp"
#include "app/input.hpp"
#include "app/polynomial_parser.hpp"
#include "app/problem_reader.hpp"

namespace steadyslide::app {
namespace {

Solid read_solid(const ProblemReader& reader, const std::string& table) {
  const Rational poisson =
      reader.number(table + ".poisson", reader.required(table + ".poisson", "Poisson's ratio is required"));
  const Value* young = reader.find(table + ".young");
  const Rational modulus = young != nullptr ? reader.number(table + ".young", *young) : Rational(1);
  try {
    return {poisson, modulus};
  } catch (const InvalidData& invalid) {
    throw reader.error(invalid, table + ".");
  }
}

Plane read_plane(const ProblemReader& reader) {
  const Value* value = reader.find("half_space.plane");
  if (value == nullptr) return Plane::strain;
  const std::string& text = reader.text("half_space.plane", *value);
  if (text == "strain") return Plane::strain;
  if (text == "stress") return Plane::stress;
  throw reader.error("half_space.plane", "unknown plane", "it is strain or stress", excerpt(text));
}

Elasticity read_elasticity(const ProblemReader& reader) {
  reader.check_table("half_space");
  reader.check_keys("half_space", {"poisson", "young", "plane", "gamma"});
  const bool elastic = reader.find("indenter.elastic") != nullptr;
  if (const Value* gamma = reader.find("half_space.gamma")) {
    for (const char* key : {"half_space.poisson", "half_space.young", "half_space.plane", "indenter.elastic"}) {
      if (reader.find(key) == nullptr) continue;
      throw reader.error(key, "conflicting key", "with half_space.gamma the data are reduced and this is left out",
                         "present");
    }
    try {
      return Elasticity::reduced(reader.number("half_space.gamma", *gamma));
    } catch (const InvalidData& invalid) {
      throw reader.error(invalid, "half_space.");
    }
  }
  reader.required("half_space.poisson", "half_space has poisson or gamma");
  const Plane plane = read_plane(reader);
  const Solid half_space = read_solid(reader, "half_space");
  if (!elastic) return Elasticity(half_space, plane);
  reader.check_table("indenter.elastic");
  reader.check_keys("indenter.elastic", {"poisson", "young"});
  reader.required("indenter.elastic.young", "an elastic indenter has its own Young's modulus");
  return {half_space, read_solid(reader, "indenter.elastic"), plane};
}

FrictionProfile read_friction(const ProblemReader& reader) {
  reader.check_table("friction");
  reader.check_keys("friction", {"values", "jumps"});
  std::vector<Rational> values =
      reader.numbers("friction.values", reader.required("friction.values", "friction has values"), max_friction_values);
  std::vector<Rational> jumps;
  if (const Value* list = reader.find("friction.jumps")) {
    jumps = reader.numbers("friction.jumps", *list, max_friction_values - 1);
  }
  try {
    return FrictionProfile(std::move(values), std::move(jumps));
  } catch (const InvalidData& invalid) {
    throw reader.error(invalid);
  }
}

class IndenterReader {
 public:
  explicit IndenterReader(const ProblemReader& reader) : reader_(reader) {}

  Indenter read() {
    reader_.check_table("indenter");
    reader_.check_keys("indenter", {"support", "profile", "pieces", "samples", "elastic"});
    check_one_shape();
    read_support();
    if (reader_.find("indenter.samples") != nullptr) {
      throw reader_.error("indenter.samples", "not available in this version");
    }
    if (const Value* profile = reader_.find("indenter.profile")) {
      return made({{right_, polynomial("indenter.profile", *profile)}});
    }
    return made(read_pieces(*reader_.find("indenter.pieces")));
  }

 private:
  void check_one_shape() const {
    const std::string rule = "an indenter has exactly one of profile, pieces, samples";
    std::string first;
    for (const std::string key : {"profile", "pieces", "samples"}) {
      if (reader_.find("indenter." + key) == nullptr) continue;
      if (!first.empty())
        throw reader_.error("indenter." + key, "conflicting key", rule, fmt::format("{} and {}", first, key));
      first = key;
    }
    if (first.empty()) throw reader_.error("indenter", "no profile", rule, "none");
  }

  void read_support() {
    const Value* support = reader_.find("indenter.support");
    if (support == nullptr) return;
    const std::vector<Rational> ends = reader_.numbers("indenter.support", *support, 2);
    if (ends.size() != 2) {
      throw reader_.error("indenter.support", "wrong number of ends", "a support is [left, right]",
                          fmt::format("{} entries", ends.size()));
    }
    if (ends[0] >= ends[1]) {
      throw reader_.error("indenter.support", "support of no length", "left is less than right",
                          to_string(ends[0]) + ", " + to_string(ends[1]));
    }
    left_ = ends[0];
    right_ = ends[1];
  }

  std::vector<Indenter::Piece> read_pieces(const Value& pieces) {
    std::vector<Indenter::Piece> result;
    for (const Value& piece : reader_.list("indenter.pieces", pieces, "tables {to, profile}", max_pieces)) {
      const std::string field = fmt::format("indenter.pieces[{}]", result.size());
      if (piece.kind != Value::Kind::table) {
        throw reader_.error(field, "wrong type", "a piece is a table {to, profile}", std::string(name_of(piece.kind)));
      }
      reader_.check_keys(field, {"to", "profile"});
      const Value& to = reader_.required(field + ".to", "a piece has its right end");
      const Value& profile = reader_.required(field + ".profile", "a piece has a profile");
      result.push_back({reader_.number(field + ".to", to), polynomial(field + ".profile", profile)});
      check_cost(field, result.back());
    }
    if (!result.empty() && result.back().to != right_) {
      throw reader_.error(fmt::format("indenter.pieces[{}].to", result.size() - 1), "pieces do not fill the support",
                          "the last piece ends at the support's right end",
                          fmt::format("{}, not {}", to_string(result.back().to), to_string(right_)));
    }
    return result;
  }

  /// Breaks are found exactly: values of the profile at the pieces' ends, with all their digits.
  void check_cost(const std::string& field, const Indenter::Piece& piece) {
    const std::size_t digits = exact_size(piece.to);
    for (const Rational& c : piece.profile.coefficients()) cost_ += digits + exact_size(c);
    if (cost_ <= max_cost) return;
    throw reader_.error(field, "pieces too complicated", "all pieces together are limited in degree and in digits",
                        "more");
  }

  static std::size_t exact_size(const Rational& value) {
    const auto bits = [](const Integer& part) { return part == 0 ? 1 : msb(Integer(abs(part))) + 1; };
    return bits(boost::multiprecision::numerator(value)) + bits(boost::multiprecision::denominator(value));
  }

  Polynomial polynomial(const std::string& field, const Value& value) {
    if (value.kind == Value::Kind::integer || value.kind == Value::Kind::decimal) {
      return Polynomial::constant(reader_.number(field, value));
    }
    try {
      return parse_polynomial(reader_.text(field, value), budget_);
    } catch (const InvalidData& invalid) {
      throw reader_.error(field, invalid.what());
    }
  }

  Indenter made(std::vector<Indenter::Piece> pieces) const {
    try {
      return {left_, std::move(pieces)};
    } catch (const InvalidData& invalid) {
      throw reader_.error(invalid);
    }
  }

  static constexpr std::size_t max_cost = 20000000;

  const ProblemReader& reader_;
  Rational left_ = -1;
  Rational right_ = 1;
  PolynomialBudget budget_;
  std::size_t cost_ = 0;
};

Sliding read_sliding(const ProblemReader& reader) {
  const Value* value = reader.find("sliding");
  if (value == nullptr) return Sliding::plus_x;
  const std::string& text = reader.text("sliding", *value);
  if (text == "+x") return Sliding::plus_x;
  if (text == "-x") return Sliding::minus_x;
  throw reader.error("sliding", "unknown direction", "it is +x or -x", excerpt(text));
}

}  // namespace

Problem parse_problem(std::string_view text, const std::string& name) {
  const Value root = parse_document(text, name);
  const ProblemReader reader(root, name);
  reader.check_keys("", {"load", "load_at", "sliding", "half_space", "friction", "indenter"});
  const Rational load = reader.number("load", reader.required("load", "a problem has a load"));
  std::optional<Rational> load_at;
  if (const Value* value = reader.find("load_at")) load_at = reader.number("load_at", *value);
  const Sliding sliding = read_sliding(reader);
  Elasticity elasticity = read_elasticity(reader);
  FrictionProfile friction = read_friction(reader);
  Indenter indenter = IndenterReader(reader).read();
  try {
    return {ContactProblem(std::move(elasticity), std::move(friction), std::move(indenter), load, sliding, load_at),
            name};
  } catch (const InvalidData& invalid) {
    throw reader.error(invalid);
  }
}

Problem read_problem(const std::string& name) { return parse_problem(read_input(name), name); }

}  // namespace steadyslide::app
