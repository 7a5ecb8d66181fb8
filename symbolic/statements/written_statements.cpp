#include "symbolic/statements/written_statements.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <stdexcept>

#include "symbolic/field/comparison.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/polynomial_slope.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"
#include "symbolic/statements/polynomial_families.hpp"
#include "symbolic/statements/statement_lines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;
using Arguments = std::vector<ex>;
using Line = StatementLine;

int integer(const ex& e) {
  if (!e.info(GiNaC::info_flags::integer)) refuse("no integer", canonical_text(e));
  return GiNaC::ex_to<GiNaC::numeric>(e).to_int();
}

std::size_t count(const ex& e) {
  const int n = integer(e);
  if (n < 0) refuse("no count", canonical_text(e));
  return static_cast<std::size_t>(n);
}

GiNaC::numeric number(const ex& e) {
  if (!GiNaC::is_a<GiNaC::numeric>(e)) refuse("no number", canonical_text(e));
  return GiNaC::ex_to<GiNaC::numeric>(e);
}

/// A list in a text is a list of GiNaC's.
Arguments entries(const ex& e) {
  if (!GiNaC::is_a<GiNaC::lst>(e)) refuse("no list", canonical_text(e));
  return {e.begin(), e.end()};
}

ex list_of(const Arguments& entries) { return GiNaC::lst(entries.begin(), entries.end()); }

const symbol& symbol_in(const ex& e) {
  if (!GiNaC::is_a<symbol>(e)) refuse("no symbol", canonical_text(e));
  return GiNaC::ex_to<symbol>(e);
}

ex polynomial(const Arguments& coefficients, const ex& x) {
  ex value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * x + coefficients[k];
  return value;
}

/// [left, right, jumps, left, right, jumps, ...]
FundamentalSolution contact(const ex& ends_and_jumps) {
  const auto end = [](const ex& free_ends) { return integer(free_ends) == 0 ? EndKind::edge : EndKind::free; };
  const Arguments all = entries(ends_and_jumps);
  if (all.size() % 3 != 0) refuse("a component has two ends and a number of jumps", std::to_string(all.size()));
  std::vector<Component> components;
  for (std::size_t k = 0; k < all.size(); k += 3)
    components.push_back({end(all[k]), end(all[k + 1]), count(all[k + 2]) + 1});
  return FundamentalSolution(components);
}

PolynomialSlope polynomial_slope(const Arguments& a) { return {integer(a[0]), entries(a[1]), entries(a[2]), a[3]}; }

ExactIdentity rational_identity(const std::string& words, const ex& lhs, const ex& rhs) {
  const RationalDecision decision = decide_equal(lhs, rhs);
  const auto& divisors = decision.nonvanishing;
  return {words,
          canonical_text(lhs),
          canonical_text(rhs),
          decision.identical,
          {divisors.begin(), divisors.end()},
          std::make_shared<WrittenIdentity>(WrittenIdentity{{}, {{"", lhs, rhs}}})};
}

/// The functions that need no field.
WrittenFunctions plain_functions() {
  constexpr std::size_t any = -1;
  const auto replaced = [](const Arguments& a, bool squares) {
    GiNaC::lst equations;
    for (std::size_t k = 1; k + 1 < a.size(); k += 2) equations.append((squares ? a[k] * a[k] : a[k]) == a[k + 1]);
    return equations;
  };
  WrittenFunctions all{
      {"at", {{3, any, 2}, [=](const Arguments& a) { return a[0].subs(replaced(a, false)); }}},
      {"squares",
       {{3, any, 2},
        [=](const Arguments& a) { return a[0].expand().subs(replaced(a, true), GiNaC::subs_options::algebraic); }}},
      {"diff", {2, [](const Arguments& a) { return a[0].diff(symbol_in(a[1])); }}},
      {"coeff", {3, [](const Arguments& a) { return a[0].coeff(a[1], integer(a[2])); }}},
      {"expand", {1, [](const Arguments& a) { return a[0].expand(); }}},
      {"normal", {1, [](const Arguments& a) { return a[0].normal(); }}},
      {"log", {1, [](const Arguments& a) -> ex { return GiNaC::log(a[0]); }}},
      {"integral", {4, [](const Arguments& a) { return integral(a[0], symbol_in(a[1]), a[2], a[3]); }}},
      {"chebyshev_T", {2, [](const Arguments& a) { return chebyshev_t(integer(a[0]), a[1]); }}},
      {"chebyshev_U", {2, [](const Arguments& a) { return chebyshev_u(integer(a[0]), a[1]); }}},
      {"max", {{1, any}, [](const Arguments& a) { return *std::ranges::max_element(a, {}, number); }}},
      {"size", {1, [](const Arguments& a) -> ex { return entries(a[0]).size(); }}},
      {"join",
       {{1, any},
        [](const Arguments& a) {
          Arguments all;
          for (const ex& list : a) std::ranges::copy(entries(list), std::back_inserter(all));
          return list_of(all);
        }}},
      {"panels",
       {1,
        [](const Arguments& a) {
          Arguments panels;
          const FundamentalSolution solution = contact(a[0]);
          for (std::size_t k = 0; k < solution.regions().size(); ++k) {
            if (solution.regions()[k].friction) panels.push_back(k);
          }
          return list_of(panels);
        }}},
      {"banks",
       {1,
        [](const Arguments& a) {
          Arguments names;
          const FundamentalSolution solution = contact(a[0]);
          for (const auto& region : solution.regions()) {
            names.push_back(symbol(region.friction ? "panel " + std::to_string(*region.friction)
                                                   : "off contact " + std::to_string(names.size())));
          }
          return list_of(names);
        }}},
      {"zeros",
       {2,
        [](const Arguments& a) {
          GiNaC::lst equations;
          for (const ex& f : entries(a[0])) equations.append(f == 0);
          Arguments values;
          for (const ex& solved : GiNaC::lsolve(equations, a[1])) values.push_back(solved.rhs());
          return list_of(values);
        }}},
      {"same", {2, [](const Arguments& a) -> ex { return a[0].is_equal(a[1]) ? 1 : 0; }}},
      {"sum", {1, [](const Arguments& a) { return polynomial(entries(a[0]), 1); }}},
      {"polynomial", {2, [](const Arguments& a) { return polynomial(entries(a[0]), a[1]); }}},
      {"power_sums",
       {3, [](const Arguments& a) { return list_of(power_sums(entries(a[0]), entries(a[1]), count(a[2]))); }}},
      {"binomials",
       {3, [](const Arguments& a) { return list_of(binomial_product(entries(a[0]), entries(a[1]), count(a[2]))); }}},
      {"series_of_Y",
       {1, [](const Arguments& a) { return list_of(series_at_infinity(entries(a[0]), -1, a[0].nops())); }}},
      {"series_of_reciprocal",
       {1, [](const Arguments& a) { return list_of(series_at_infinity(entries(a[0]), 1, a[0].nops())); }}},
      {"N_of", {4, [](const Arguments& a) { return list_of(polynomial_slope(a).factor()); }}},
      {"conditions", {4, [](const Arguments& a) { return list_of(polynomial_slope(a).conditions()); }}},
      {"F_of", {5, [](const Arguments& a) {
                  return field_coefficient(integer(a[0]), entries(a[1]), entries(a[2]), entries(a[3]), integer(a[4]));
                }}}};
  for (const auto& [name, kind] : {std::pair("left_edge", PointKind::left_edge),
                                   {"right_edge", PointKind::right_edge},
                                   {"left_free", PointKind::left_free},
                                   {"right_free", PointKind::right_free},
                                   {"jump", PointKind::jump}}) {
    const std::size_t angles = kind == PointKind::jump ? 2 : 1;
    all.emplace(name, WrittenFunction{angles, [kind = kind](const Arguments& a) {
                                        return expression(derived_exponent(kind), {a.front(), a.back()});
                                      }});
  }
  return all;
}

/// Decides one statement and its wrong variants, line by line.
class StatementReader {
 public:
  /// `symbols`: the names that stand for themselves; `place` follows the line that is read.
  StatementReader(const StatementSection& section, const std::vector<std::string>& symbols,
                  const WrittenFunctions& more, StatementPlace& place)
      : section_(section), place_(place), declared_(symbols.begin(), symbols.end()), functions_(more) {
    functions_.merge(plain_functions());
    add_functions();
    for (const Line& line : section.lines) {
      if (line.keyword != "field") continue;
      place_ = line.place;
      for (const std::string& friction : split(line.rest)) declared_.insert(friction);
      field_ = PhaseField(items(line.rest));
    }
  }

  DecidedStatement statement() {
    DecidedStatement result{section_.id, {}, {}};
    for (const Line& line : section_.lines) {
      if (line.keyword == "says") result.identity = decided(line.rest);
    }
    if (result.identity.statement.empty()) refuse("a statement has words", section_.id);
    const std::map<std::string, ex> right = values_;
    for (const Line& line : section_.lines) {
      if (line.keyword != "wrong") continue;
      place_ = line.place;
      const auto parts = cut(line.rest, " :: ");
      if (!parts) refuse("a wrong variant says what it changes", line.rest);
      values_ = right;
      std::map<std::string, ex> changes;
      for (const std::string& change : split(parts->second)) {
        const auto sides = cut(change, " = ");
        if (!sides || !right.contains(sides->first)) refuse("a wrong variant changes what `let` gives", change);
        changes[sides->first] = value(sides->second);
      }
      changes_ = changes;
      result.controls.push_back(decided(parts->first));
    }
    return result;
  }

 private:
  struct Function {
    std::vector<std::string> parameters;
    std::string body;
  };

  ExactIdentity decided(const std::string& words) {
    Comparison comparison(field_);
    identity_.reset();
    equations_ = 0;
    words_ = words;
    run(0, section_.lines.size(), comparison);
    return identity_ ? *identity_ : comparison.as(words);
  }

  void run(std::size_t first, std::size_t last, Comparison& comparison) {
    for (std::size_t k = first; k < last; ++k) {
      const auto& [keyword, rest, place] = section_.lines[k];
      place_ = place;
      if (keyword == "let") {
        for (const std::string& definition : split(rest)) define(definition);
      } else if (keyword == "equal") {
        add_equation(rest, comparison);
      } else if (keyword == "for") {
        const std::size_t end = end_of_loop(k);
        const auto sides = cut(rest, " = ");
        if (!sides) refuse("`for` gives values", rest);
        for (const ex& item : items(sides->second)) {
          values_[sides->first] = item;
          run(k + 1, end, comparison);
        }
        k = end;
      } else if (keyword != "says" && keyword != "wrong" && keyword != "field") {
        refuse("no such line", keyword + " " + rest);
      }
    }
  }

  std::size_t end_of_loop(std::size_t first) const {
    int depth = 0;
    for (std::size_t k = first; k < section_.lines.size(); ++k) {
      const std::string& keyword = section_.lines[k].keyword;
      depth += (keyword == "for") - (keyword == "end");
      if (depth == 0) return k;
    }
    refuse("`for` has an `end`", section_.lines[first].rest);
  }

  void define(const std::string& definition) {
    const auto sides = cut(definition, " = ");
    if (!sides) refuse("`let` gives values", definition);
    const auto& [name, body] = *sides;
    if (const std::size_t open = name.find('('); open != name.npos) {
      if (functions_.contains(name.substr(0, open))) refuse("a function of every text", name.substr(0, open));
      written_[name.substr(0, open)] = {split(name.substr(open + 1, name.size() - open - 2)), body};
    } else {
      const auto change = changes_.find(name);
      values_[name] = change == changes_.end() ? value(body) : change->second;
    }
  }

  void add_equation(const std::string& text, Comparison& comparison) {
    if (!comparison.holds()) return;
    const auto named = cut(text, " :: ");
    const std::vector<std::string> sides = split(named ? named->second : text, " = ", "[");
    if (sides.size() != 2) refuse("an equation has two sides", text);
    const ex lhs = value(sides[0]);
    const ex rhs = value(sides[1]);
    if (identity_ || (!named && equations_ > 0)) refuse("an equation without a name stands alone", text);
    ++equations_;
    if (named) {
      comparison.equal(with_values(named->first), lhs, rhs);
    } else {
      identity_ = rational_identity(words_, lhs, rhs);
    }
  }

  /// The text with the values of expressions in braces.
  std::string with_values(const std::string& text) {
    const std::size_t open = text.find('{'), close = text.find('}');
    if (open == text.npos || close == text.npos) return text;
    return text.substr(0, open) + canonical_text(value(text.substr(open + 1, close - open - 1))) +
           with_values(text.substr(close + 1));
  }

  void add_functions() {
    const auto add = [&](const char* name, ArgumentCount arguments, std::function<ex(const Arguments&)> function) {
      functions_.emplace(name, WrittenFunction{arguments, std::move(function)});
    };
    add("r", 1, [this](const auto& a) { return field_.friction(index(a[0])).r; });
    add("cos", 1, [this](const auto& a) { return field_.friction(index(a[0])).cos; });
    add("sin", 1, [this](const auto& a) { return field_.friction(index(a[0])).sin; });
    add("angle", 1, [this](const auto& a) -> ex { return angle(index(a[0])); });
    add("phase", 1, [this](const auto& a) { return field_.phase(form(a[0])); });
    add("sign", 1, [this](const auto& a) -> ex {
      for (const int sign : {1, -1}) {
        if (field_.are_equal(a[0], sign).holds) return sign;
      }
      refuse("neither 1 nor -1", field_.text(a[0]));
    });
    const auto relation = [this](const Arguments& a) {
      return jump_relation(a[0], a.size() > 1 ? a[1] : ex(field_.i()), a.size() > 2 ? a[2] : ex(1));
    };
    add("ratio", {1, 3}, [=](const auto& a) { return relation(a).ratio; });
    add("source", {1, 3}, [=](const auto& a) { return relation(a).source; });
    add("powers", 1, [this](const auto& a) {
      const FundamentalSolution solution = contact(a[0]);
      Arguments angles, powers;
      for (std::size_t k = 0; k < solution.panels(); ++k) angles.push_back(angle(k));
      for (const auto& point : solution.points()) powers.push_back(expression(point.power, angles));
      return list_of(powers);
    });
    add("ratios", 1, [this](const auto& a) {
      Arguments ratios;
      const FundamentalSolution solution = contact(a[0]);
      for (const auto& region : solution.regions()) {
        ratios.push_back(region.friction ? jump_relation(field_.friction(*region.friction).s, field_.i()).ratio : 1);
      }
      return list_of(ratios);
    });
  }

  std::size_t index(const ex& friction) const {
    for (std::size_t k = 0; k < field_.size(); ++k) {
      if (field_.friction(k).s.is_equal(friction)) return k;
    }
    refuse("no friction of the field", section_.id);
  }

  symbol symbol_named(const std::string& name) { return symbols_.try_emplace(name, symbol(name)).first->second; }
  symbol angle(std::size_t k) { return symbol_named("alpha_" + std::to_string(k)); }

  AngleForm form(const ex& e) {
    std::map<std::size_t, int> times;
    ex rest = e.expand();
    for (std::size_t k = 0; k < field_.size(); ++k) {
      const ex factor = rest.coeff(angle(k));
      times[k] = integer(factor);
      rest -= factor * angle(k);
    }
    return {integer((2 * rest).expand()), times};
  }

  /// Declared as it is, or as `name_*` for name_0, name_1, ...
  bool is_declared(const std::string& name) const {
    const std::size_t end = name.find_last_not_of("0123456789") + 1;
    return declared_.contains(name) || (end < name.size() && declared_.contains(name.substr(0, end) + "*"));
  }

  ex named(const std::string& name) {
    if (const auto place = values_.find(name); place != values_.end()) return place->second;
    if (name == "i") return field_.i();
    if (name == "edge") return 0;
    if (name == "free") return 1;
    if (!is_declared(name)) refuse("no such name", name);
    return symbol_named(name);
  }

  ex call(const std::string& name, const Arguments& arguments) {
    const auto function = functions_.find(name);
    const auto written = written_.find(name);
    if (function == functions_.end() && written == written_.end()) refuse("no such function", name);
    const bool fits = function != functions_.end() ? function->second.arguments.admit(arguments.size())
                                                   : written->second.parameters.size() == arguments.size();
    if (!fits) refuse("wrong number of arguments (" + std::to_string(arguments.size()) + ")", name);
    if (function != functions_.end()) return function->second.value(arguments);
    const std::map<std::string, ex> outside = values_;
    for (std::size_t k = 0; k < arguments.size(); ++k) values_[written->second.parameters[k]] = arguments[k];
    const ex result = value(written->second.body);
    values_ = outside;
    return result;
  }

  /// The values of "a, b, 0..3"; of "f(j) | j = 0..3" those of f(0), ..., f(3).
  Arguments items(const std::string& text) {
    Arguments all;
    if (text.empty()) return all;
    if (const auto parts = split(text, " | "); parts.size() == 2) {
      const auto range = cut(parts[1], " = ");
      if (!range) refuse("a list gives values", text);
      const std::map<std::string, ex> outside = values_;
      for (const ex& item : items(range->second)) {
        values_[range->first] = item;
        all.push_back(value(parts[0]));
      }
      values_ = outside;
      return all;
    }
    for (const std::string& item : split(text)) {
      if (const auto ends = split(item, ".."); ends.size() == 2) {
        const int last = integer(value(ends[1]));
        for (int k = integer(value(ends[0])); k <= last; ++k) all.push_back(k);
      } else {
        all.push_back(value(item));
      }
    }
    return all;
  }

  /// An expression, evaluated from left to right.
  class ExpressionReader {
   public:
    ExpressionReader(StatementReader& statement, std::string text) : statement_(statement), text_(std::move(text)) {}
    ex all() {
      const ex result = sum();
      if (at_ != text_.size()) refuse("not an expression", text_);
      return result;
    }

   private:
    bool next(char c) {
      while (at_ < text_.size() && text_[at_] == ' ') ++at_;
      if (at_ == text_.size() || text_[at_] != c) return false;
      ++at_;
      return true;
    }
    ex sum() {
      ex result = product();
      for (;;) {
        if (next('+')) {
          result = result + product();
        } else if (next('-')) {
          result = result - product();
        } else {
          return result;
        }
      }
    }
    ex product() {
      ex result = factor();
      for (;;) {
        if (next('*')) {
          result = result * factor();
        } else if (next('/')) {
          result = result / factor();
        } else {
          return result;
        }
      }
    }
    ex factor() {
      if (next('-')) return -factor();
      ex base = atom();
      while (next('[')) {
        const std::size_t k = count(ExpressionReader(statement_, enclosed(']')).all());
        if (k >= entries(base).size()) refuse("no such entry", text_);
        base = base.op(k);
      }
      return next('^') ? GiNaC::pow(base, factor()) : base;
    }
    ex atom() {
      if (next('(')) {
        const ex inside = sum();
        close();
        return inside;
      }
      if (next('[')) return list_of(statement_.items(enclosed(']')));
      std::string name;
      for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '\'') break;
        name += c;
      }
      if (name.empty()) refuse("not an expression", text_);
      if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) return GiNaC::numeric(name.c_str());
      if (name.back() == '_' && next('{'))
        return statement_.named(name + canonical_text(statement_.value(enclosed('}'))));
      if (!next('(')) return statement_.named(name);
      Arguments arguments{sum()};
      while (next(',')) arguments.push_back(sum());
      close();
      return statement_.call(name, arguments);
    }
    /// The text up to the bracket that closes the one before it.
    std::string enclosed(char bracket) {
      const std::size_t first = at_;
      for (int depth = 1; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        if (depth == 0 && c == bracket) return text_.substr(first, at_++ - first);
      }
      refuse("a bracket is not closed", text_);
    }
    void close() {
      if (!next(')')) refuse("a parenthesis is not closed", text_);
    }

    StatementReader& statement_;
    std::string text_;
    std::size_t at_ = 0;
  };
  ex value(const std::string& text) { return ExpressionReader(*this, text).all(); }

  const StatementSection& section_;
  StatementPlace& place_;
  std::set<std::string> declared_;
  WrittenFunctions functions_;
  PhaseField field_;
  std::map<std::string, symbol> symbols_;
  std::map<std::string, ex> values_;
  std::map<std::string, Function> written_;
  std::map<std::string, ex> changes_;  ///< of the wrong variant that is decided
  std::optional<ExactIdentity> identity_;
  int equations_ = 0;
  std::string words_;
};

/// The section with the definitions around it.
StatementSection with_definitions(const std::vector<Line>& definitions, StatementSection section) {
  const auto then = std::ranges::find(definitions, "then", &Line::keyword);
  section.lines.insert(section.lines.begin(), definitions.begin(), then);
  if (then != definitions.end()) section.lines.insert(section.lines.end(), then + 1, definitions.end());
  return section;
}

std::vector<DecidedStatement> read_statements(std::string_view text, const WrittenFunctions& more,
                                              const std::vector<DecidedStatement>& decided_elsewhere,
                                              StatementPlace& place) {
  std::vector<DecidedStatement> all;
  std::size_t others = 0;
  std::vector<std::string> symbols;
  std::vector<Line> definitions;
  for (const StatementSection& section : statement_sections(text, place)) {
    if (section.place.file != place.file) symbols.clear();
    place = section.place;
    if (section.id == "definitions") {
      definitions = section.lines;
    } else if (const std::string keyword = "symbols "; section.id.starts_with(keyword)) {
      std::ranges::copy(split(section.id.substr(keyword.size())), std::back_inserter(symbols));
    } else if (!section.lines.empty()) {
      const StatementSection whole = with_definitions(definitions, section);
      all.push_back(StatementReader(whole, symbols, more, place).statement());
    } else {
      const auto other =
          std::ranges::find_if(decided_elsewhere, [&](const DecidedStatement& s) { return s.id == section.id; });
      if (other == decided_elsewhere.end()) refuse("not decided", section.id);
      all.push_back(*other);
      ++others;
    }
  }
  if (others != decided_elsewhere.size()) refuse("one that is decided is not in the text", std::to_string(others));
  return all;
}

}  // namespace

std::vector<DecidedStatement> written_statements(std::string_view text,
                                                 const std::vector<DecidedStatement>& decided_elsewhere,
                                                 const WrittenFunctions& more) {
  StatementPlace place;  // of what is read or decided
  try {
    return read_statements(text, more, decided_elsewhere, place);
  } catch (const UnreadableStatement& error) {
    throw std::logic_error("statement: " + to_text(place) + ": " + error.what());
  }
}

}  // namespace steadyslide::symbolic
