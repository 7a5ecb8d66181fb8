#include "library/problem_file/problem_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "library/problem_file/input_file.hpp"
#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/problem_reader.hpp"
#include "library/problem_file/profile_trace.hpp"

namespace steadyslide::library {
namespace {

Solid read_solid(const ProblemReader& reader, const std::string& table) {
  const Rational poisson = reader.number(table + ".poisson", "Poisson's ratio is required");
  const Rational young = reader.number_if_any(table + ".young").value_or(1);
  return reader.accepted(table + ".", [&] { return Solid(poisson, young); });
}

Elasticity read_elasticity(const ProblemReader& reader) {
  reader.check_table("half_space", {"poisson", "young", "plane", "gamma"});
  if (const Value* gamma = reader.find("half_space.gamma")) {
    for (const char* key : {"half_space.poisson", "half_space.young", "half_space.plane", "indenter.elastic"}) {
      if (reader.find(key) == nullptr) continue;
      throw reader.error(key, "conflicting key", "with half_space.gamma the data are reduced and this is left out",
                         "present");
    }
    return reader.accepted("half_space.",
                           [&] { return Elasticity::reduced(reader.number("half_space.gamma", *gamma)); });
  }
  reader.required("half_space.poisson", "half_space has poisson or gamma");
  const auto plane =
      reader.choice<Plane>("half_space.plane", "unknown plane", {"strain", Plane::strain}, {"stress", Plane::stress});
  const Solid half_space = read_solid(reader, "half_space");
  if (reader.find("indenter.elastic") == nullptr) return Elasticity(half_space, plane);
  reader.check_table("indenter.elastic", {"poisson", "young"});
  reader.required("indenter.elastic.young", "an elastic indenter has its own Young's modulus");
  return {half_space, read_solid(reader, "indenter.elastic"), plane};
}

FrictionProfile read_friction(const ProblemReader& reader) {
  reader.check_table("friction", {"values", "jumps"});
  reader.required("friction.values", "friction has values");
  std::vector<Rational> values = reader.numbers("friction.values", max_friction_values);
  std::vector<Rational> jumps = reader.numbers("friction.jumps", max_friction_values - 1);
  return reader.accepted("", [&] { return FrictionProfile(std::move(values), std::move(jumps)); });
}

struct ReadIndenter {
  Indenter shape;
  std::optional<MeasuredProfile> measured;
};

/// The table [indenter]: the support, and the profile as a polynomial, as pieces or as a measured trace.
class IndenterReader {
 public:
  /// `file`: the problem file's name. A trace is looked for in its folder.
  IndenterReader(const ProblemReader& reader, const std::string& file) : reader_(reader), file_(file) {}

  ReadIndenter read() {
    reader_.check_table("indenter", {"support", "profile", "pieces", "samples", "elastic"});
    check_one_shape();
    read_support();
    if (const Value* samples = reader_.find("indenter.samples")) return read_samples(*samples);
    if (const Value* profile = reader_.find("indenter.profile")) {
      return {made({{support().right, polynomial("indenter.profile", *profile)}}), std::nullopt};
    }
    return {made(read_pieces(*reader_.find("indenter.pieces"))), std::nullopt};
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
    if (reader_.find("indenter.support") == nullptr) return;
    const std::vector<Rational> ends = reader_.numbers("indenter.support", 2);
    if (ends.size() != 2) {
      throw reader_.error("indenter.support", "wrong number of ends", "a support is [left, right]",
                          fmt::format("{} entries", ends.size()));
    }
    support_ = {ends[0], ends[1]};
    if (ends[0] >= ends[1]) throw bad_support("support of no length", "left is less than right");
  }

  InvalidFile bad_support(const std::string& what, const std::string& rule) const {
    return reader_.error("indenter.support", what, rule, to_string(support_->left) + ", " + to_string(support_->right));
  }

  /// The support for a profile and for pieces.
  Support support() const { return support_.value_or(Support{-1, 1}); }

  ReadIndenter read_samples(const Value& value) {
    if (value.kind == Value::Kind::text) return read_trace("indenter.samples", {value.text, 0}, {});
    const std::string field = "indenter.samples";
    if (value.kind != Value::Kind::table) {
      throw reader_.error(field, "wrong type", "it is a string or a table {file, x_unit, height_unit, flip, detrend}",
                          name_of(value.kind));
    }
    reader_.check_keys(field, {"file", "x_unit", "height_unit", "flip", "detrend"});
    MeasuredProfile measured{reader_.text(field + ".file", reader_.required(field + ".file", "samples have a file")),
                             0};
    measured.x_unit = word(field + ".x_unit", "unknown unit", length_units, "");
    measured.height_unit = word(field + ".height_unit", "unknown unit", length_units, "");
    if (measured.x_unit.empty() && !measured.height_unit.empty()) {
      throw reader_.error(field + ".height_unit", "no unit of x", "heights are brought into the unit that x_unit names",
                          measured.height_unit);
    }
    Heights heights;
    if (!measured.height_unit.empty()) {
      heights.factor =
          parse_rational(fmt::format("1e{}", exponent_of(measured.height_unit) - exponent_of(measured.x_unit)));
    }
    if (const Value* flip = reader_.find(field + ".flip")) {
      if (flip->kind != Value::Kind::boolean) {
        throw reader_.error(field + ".flip", "wrong type", "it is true or false", name_of(flip->kind));
      }
      measured.flip = flip->text == "true";
      if (measured.flip) heights.factor = -heights.factor;
    }
    const std::string detrend = word(field + ".detrend", "unknown trend", {"none", "mean", "line"}, "none");
    heights.detrend = detrend == "none" ? Detrend::none : detrend == "mean" ? Detrend::mean : Detrend::line;
    return read_trace(field + ".file", std::move(measured), heights);
  }

  /// `field` names the file.
  ReadIndenter read_trace(const std::string& field, MeasuredProfile measured, const Heights& heights) {
    const std::string path = path_of(measured.file);
    ProfileTrace trace = parse_trace(contents(field, path), path, support_, heights);
    const auto& [first, last] = trace.range;
    if (support_ && (support_->left < first || support_->right > last)) {
      throw bad_support("support beyond the samples",
                        fmt::format("they reach from {} to {}", to_string(first), to_string(last)));
    }
    measured.points = trace.points;
    measured.trend = std::move(trace.trend);
    return {Indenter(support_ ? support_->left : first, std::move(trace.pieces)), std::move(measured)};
  }

  /// Returns one of `words`, or `otherwise` if the field is absent.
  std::string word(const std::string& field, const std::string& what, const std::vector<std::string>& words,
                   const std::string& otherwise) const {
    const Value* value = reader_.find(field);
    if (value == nullptr) return otherwise;
    const std::string& given = reader_.text(field, *value);
    if (std::find(words.begin(), words.end(), given) != words.end()) return given;
    throw reader_.error(field, what, fmt::format("it is one of {}", fmt::join(words, ", ")), excerpt(given));
  }

  /// 1 unit is 10^exponent m.
  static int exponent_of(const std::string& unit) {
    return -3 * static_cast<int>(std::find(length_units.begin(), length_units.end(), unit) - length_units.begin());
  }

  /// The path of a trace: relative to the problem file's folder, or to the current folder for the standard input.
  std::string path_of(const std::string& given) const {
    const std::string path = (std::filesystem::path(file_).parent_path() / given).string();
    return path == "-" ? "./-" : path;
  }

  std::string contents(const std::string& field, const std::string& path) const {
    const auto unreadable = [&](const std::string& value) {
      return reader_.error(field, "no such trace", "it names a file, relative to the problem file", value);
    };
    if (path.find('\0') != path.npos) throw unreadable(excerpt(path));
    try {
      return read_input(path, "a trace");
    } catch (const UnreadableFile& file) {
      throw unreadable(file.what());
    }
  }

  std::vector<Indenter::Piece> read_pieces(const Value& pieces) {
    std::vector<Indenter::Piece> result;
    for (const Value& piece : reader_.list("indenter.pieces", pieces, "tables {to, profile}", max_pieces)) {
      const std::string field = fmt::format("indenter.pieces[{}]", result.size());
      if (piece.kind != Value::Kind::table) {
        throw reader_.error(field, "wrong type", "a piece is a table {to, profile}", name_of(piece.kind));
      }
      reader_.check_keys(field, {"to", "profile"});
      const Value& to = reader_.required(field + ".to", "a piece has its right end");
      const Value& profile = reader_.required(field + ".profile", "a piece has a profile");
      result.push_back({reader_.number(field + ".to", to), polynomial(field + ".profile", profile)});
      check_cost(field, result.back());
    }
    if (!result.empty() && result.back().to != support().right) {
      throw reader_.error(fmt::format("indenter.pieces[{}].to", result.size() - 1), "pieces do not fill the support",
                          "the last piece ends at the support's right end",
                          fmt::format("{}, not {}", to_string(result.back().to), to_string(support().right)));
    }
    return result;
  }

  /// Breaks are found exactly, from the values of the profile at the ends of the pieces with all their digits.
  void check_cost(const std::string& field, const Indenter::Piece& piece) {
    for (const Rational& c : piece.profile.coefficients()) cost_ += bits(piece.to) + bits(c);
    if (cost_ <= max_cost) return;
    throw reader_.error(field, "pieces too complicated", "all pieces together are limited in degree and in digits",
                        "more");
  }

  Polynomial polynomial(const std::string& field, const Value& value) {
    if (value.kind == Value::Kind::integer || value.kind == Value::Kind::decimal) {
      return Polynomial::constant(reader_.number(field, value));
    }
    return reader_.accepted(field, [&] { return parse_polynomial(reader_.text(field, value), budget_); });
  }

  Indenter made(std::vector<Indenter::Piece> pieces) const {
    return reader_.accepted("", [&] { return Indenter(support().left, std::move(pieces)); });
  }

  static constexpr std::size_t max_cost = 20000000;
  /// Each unit is a thousandth of the one before.
  static inline const std::vector<std::string> length_units{"m", "mm", "um", "nm"};

  const ProblemReader& reader_;
  const std::string& file_;
  std::optional<Support> support_;
  PolynomialBudget budget_;
  std::size_t cost_ = 0;
};

/// `whole`: load and friction are required. `same_indenter`: null, or a problem with the same [indenter].
Punch read(const Value& root, const std::string& name, bool whole, const Problem* same_indenter = nullptr) {
  const ProblemReader reader(root, name);
  reader.check_keys("", {"load", "load_at", "sliding", "half_space", "friction", "indenter"});
  const bool has_load = whole || reader.find("load") != nullptr;
  const bool has_friction = whole || reader.find("friction") != nullptr;
  const Rational load = has_load ? reader.number("load", "a problem has a load") : Rational(1);
  const std::optional<Rational> load_at = reader.number_if_any("load_at");
  const auto sliding =
      reader.choice<Sliding>("sliding", "unknown direction", {"+x", Sliding::plus_x}, {"-x", Sliding::minus_x});
  Elasticity elasticity = read_elasticity(reader);
  FrictionProfile friction = has_friction ? read_friction(reader) : FrictionProfile({0});
  ReadIndenter indenter = same_indenter != nullptr
                              ? ReadIndenter{same_indenter->contact.indenter(), same_indenter->measured}
                              : IndenterReader(reader, name).read();
  try {
    ContactProblem contact(std::move(elasticity), std::move(friction), std::move(indenter.shape), load, sliding,
                           load_at);
    return {{std::move(contact), name, std::move(indenter.measured)}, has_friction};
  } catch (const InvalidData& invalid) {
    // The model speaks of pieces; a file with samples has none.
    const bool of_samples = indenter.measured && invalid.field() == "indenter.pieces";
    throw reader.error(of_samples ? "indenter.samples" : invalid.field(), invalid.what());
  }
}

}  // namespace

Problem problem_of(const Value& document, const std::string& name, const Problem* same_indenter) {
  return read(document, name, true, same_indenter).problem;
}

Problem parse_problem(std::string_view text, const std::string& name) {
  return problem_of(parse_document(text, name), name);
}

Problem read_problem(const std::string& name) { return parse_problem(read_input(name, "a problem file"), name); }

Punch read_punch(const std::string& name) {
  return read(parse_document(read_input(name, "a problem file"), name), name, false);
}

}  // namespace steadyslide::library
