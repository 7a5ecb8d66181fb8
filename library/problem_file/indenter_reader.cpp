#include "library/problem_file/indenter_reader.hpp"

#include <fmt/format.h>

#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/sample_file.hpp"

namespace steadyslide::library {
namespace {

class IndenterReader {
 public:
  IndenterReader(const ProblemReader& reader, const std::string& file) : reader_(reader), file_(file) {}

  ReadIndenter read() {
    reader_.check_table("indenter", {"support", "profile", "pieces", "samples", "harmonics", "elastic"});
    check_one_shape();
    read_support();
    if (reader_.find("indenter.samples") != nullptr) return read_measured();
    if (const Value* profile = reader_.find("indenter.profile")) {
      return {made({{support().right, polynomial("indenter.profile", *profile)}}), std::nullopt};
    }
    if (const Value* harmonics = reader_.find("indenter.harmonics")) {
      const Indenter plane = made({{support().right, Polynomial::constant(0)}});
      return {plane.with_harmonics(read_harmonics(*harmonics)), std::nullopt};
    }
    return {made(read_pieces(*reader_.find("indenter.pieces"))), std::nullopt};
  }

 private:
  void check_one_shape() const {
    const std::string rule = "an indenter has exactly one of profile, pieces, samples, harmonics";
    std::string first;
    for (const std::string key : {"profile", "pieces", "samples", "harmonics"}) {
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

  ReadIndenter read_measured() {
    const std::string table = "indenter.samples";
    const std::string file =
        file_field(reader_, table, {"file", "x_unit", "height_unit", "flip", "detrend", "filter", "interpolate"});
    const std::string& given = reader_.find(file)->text;
    MeasuredProfile measured{is_table(given) ? "" : given, 0};
    const Heights heights = file == table ? Heights() : read_heights(table, measured);
    const SampleFile samples = read_samples(reader_, file, file_, "trace");
    ProfileTrace trace =
        reader_.accepted(table + ".", [&] { return parse_trace(samples.text, samples.path, support_, heights); });
    const auto& [first, last] = trace.range;
    if (support_ && (support_->left < first || support_->right > last)) {
      throw bad_support("support beyond the samples",
                        fmt::format("they reach from {} to {}", to_string(first), to_string(last)));
    }
    measured.points = trace.points;
    measured.trend = std::move(trace.trend);
    measured.cutoff = heights.cutoff;
    measured.interpolation = heights.interpolation;
    return {Indenter(support_ ? support_->left : first, std::move(trace.pieces)), std::move(measured)};
  }

  /// Reads the table `field`; sets the units and the sign of `measured`.
  Heights read_heights(const std::string& field, MeasuredProfile& measured) const {
    measured.x_unit = length_unit(reader_, field + ".x_unit");
    measured.height_unit = length_unit(reader_, field + ".height_unit");
    if (measured.x_unit.empty() && !measured.height_unit.empty()) {
      throw reader_.error(field + ".height_unit", "no unit of x", "heights are brought into the unit that x_unit names",
                          measured.height_unit);
    }
    Heights heights;
    if (!measured.height_unit.empty()) heights.factor = unit_ratio(measured.height_unit, measured.x_unit);
    if (const Value* flip = reader_.find(field + ".flip")) {
      if (flip->kind != Value::Kind::boolean) {
        throw reader_.error(field + ".flip", "wrong type", "it is true or false", name_of(flip->kind));
      }
      measured.flip = flip->text == "true";
      if (measured.flip) heights.factor = -heights.factor;
    }
    const std::string detrend = word(reader_, field + ".detrend", "unknown trend", {"none", "mean", "line"}, "none");
    heights.detrend = detrend == "none" ? Detrend::none : detrend == "mean" ? Detrend::mean : Detrend::line;
    if (reader_.find(field + ".filter") != nullptr) heights.cutoff = read_cutoff(field + ".filter");
    heights.interpolation =
        reader_.choice<Interpolation>(field + ".interpolate", "unknown interpolation",
                                      {"linear", Interpolation::linear}, {"spline", Interpolation::spline});
    return heights;
  }

  Rational read_cutoff(const std::string& field) const {
    reader_.check_table(field, {"kind", "cutoff"});
    reader_.required(field + ".kind", "a filter has a kind");
    word(reader_, field + ".kind", "unknown filter", {"gauss"}, "");
    Rational cutoff = reader_.number(field + ".cutoff", "a filter has a cutoff");
    if (cutoff <= 0) {
      throw reader_.error(field + ".cutoff", "cutoff out of range", "it is positive", to_string(cutoff));
    }
    return cutoff;
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

  std::vector<Harmonic> read_harmonics(const Value& harmonics) const {
    std::vector<Harmonic> result;
    for (std::size_t k = 0;
         k < reader_.list("indenter.harmonics", harmonics, "tables {n, cos, sin}", max_harmonics).size(); ++k) {
      const std::string field = fmt::format("indenter.harmonics[{}]", k);
      reader_.check_table(field, {"n", "cos", "sin"});
      const Rational n = reader_.number(field + ".n", "a harmonic has a number");
      if (n < 1 || n > max_harmonics || denominator(n) != 1) {
        throw reader_.error(field + ".n", "number out of range",
                            fmt::format("it is a whole number from 1 to {}", max_harmonics), to_string(n));
      }
      result.push_back({n.convert_to<int>(), reader_.number_if_any(field + ".cos").value_or(0),
                        reader_.number_if_any(field + ".sin").value_or(0)});
    }
    if (result.empty())
      throw reader_.error("indenter.harmonics", "no harmonic", fmt::format("there are 1 to {}", max_harmonics),
                          "0 harmonics");
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

  const ProblemReader& reader_;
  const std::string& file_;
  std::optional<Support> support_;
  PolynomialBudget budget_;
  std::size_t cost_ = 0;
};

}  // namespace

ReadIndenter read_indenter(const ProblemReader& reader, const std::string& file) {
  return IndenterReader(reader, file).read();
}

}  // namespace steadyslide::library
