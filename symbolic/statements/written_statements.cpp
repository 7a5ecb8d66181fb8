#include "symbolic/statements/written_statements.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "symbolic/field/comparison.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"
#include "symbolic/statements/statement_lines.hpp"
#include "symbolic/statements/written_expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;
using Arguments = std::vector<ex>;
using Line = StatementLine;

ExactIdentity rational_identity(const ex& lhs, const ex& rhs) {
  const RationalDecision decision = decide_equal(lhs, rhs);
  const auto& divisors = decision.nonvanishing;
  return {"",
          canonical_text(lhs),
          canonical_text(rhs),
          decision.identical,
          {divisors.begin(), divisors.end()},
          std::make_shared<WrittenIdentity>(WrittenIdentity{{}, {{"", lhs, rhs}}})};
}

/// Decides the statements of a section and their wrong variants, line by line.
class StatementReader : private ExpressionMeaning {
 public:
  /// `symbols`: the names that are symbols; `place` is always the current line.
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

  std::vector<DecidedStatement> statements() {
    decide();
    std::vector<DecidedStatement> all;
    for (const Part& part : parts_) all.push_back({id_of(part), part.as(part.words), {}, part.decides});
    const std::map<std::string, ex> right = values_;
    for (const Line& line : section_.lines) {
      if (line.keyword != "wrong") continue;
      place_ = line.place;
      const auto sides = cut(line.rest, " :: ");
      if (!sides) refuse("a wrong variant says what it changes", line.rest);
      values_ = right;
      std::map<std::string, ex> changes;
      for (const std::string& change : split(sides->second)) {
        const auto parts = cut(change, " = ");
        if (!parts || !right.contains(parts->first)) refuse("a wrong variant changes what `let` gives", change);
        changes[parts->first] = value(parts->second);
      }
      changes_ = changes;
      decide();
      const bool breaks_none = std::ranges::all_of(parts_, [](const Part& part) { return part.as("").identical; });
      for (std::size_t k = 0; k < all.size(); ++k) {
        ExactIdentity variant = parts_[k].as(sides->first);
        if (breaks_none || !variant.identical) all[k].controls.push_back(std::move(variant));
      }
    }
    for (const DecidedStatement& one : all) {
      if (one.controls.empty()) refuse("no wrong variant breaks it", one.id);
    }
    return all;
  }

 private:
  struct Function {
    std::vector<std::string> parameters;
    std::string body;
  };

  /// One line `says` with the equations after it.
  struct Part {
    std::string name, decides, words;  ///< the name is the word of the first fact
    Comparison comparison;
    std::optional<ExactIdentity> rational = {};  ///< the equation that stands alone
    int equations = 0;

    ExactIdentity as(const std::string& statement) const {
      if (!rational) return comparison.as(statement);
      ExactIdentity identity = *rational;
      identity.statement = statement;
      return identity;
    }
  };

  std::string id_of(const Part& part) const { return parts_.size() == 1 ? section_.id : section_.id + "-" + part.name; }

  void decide() {
    parts_.clear();
    for (const Line& line : section_.lines) {
      if (line.keyword != "says") continue;
      place_ = line.place;
      open_part(line.rest);
    }
    if (parts_.empty()) refuse("a statement has words", section_.id);
    current_ = parts_.size();
    run(0, section_.lines.size());
  }

  /// Begins a statement, or continues the one of the same name.
  void open_part(const std::string& text) {
    const auto [decides, words] = cut(text, " :: ").value_or(std::pair("", text));
    const std::string name = decides.empty() ? words : decides.substr(0, decides.find('('));
    current_ = static_cast<std::size_t>(std::ranges::find(parts_, name, &Part::name) - parts_.begin());
    if (current_ < parts_.size()) return;
    if (!parts_.empty() && (decides.empty() || parts_[0].decides.empty())) {
      refuse("each of several statements names its fact", words);
    }
    parts_.push_back({name, decides, words, Comparison(field_)});
  }

  void run(std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto& [keyword, rest, place] = section_.lines[k];
      place_ = place;
      if (keyword == "let") {
        for (const std::string& definition : split(rest)) define(definition);
      } else if (keyword == "equal") {
        add_equation(rest);
      } else if (keyword == "for") {
        const std::size_t end = end_of_loop(k);
        const auto sides = cut(rest, " = ");
        if (!sides) refuse("`for` gives values", rest);
        for (const ex& item : items(sides->second)) {
          values_[sides->first] = item;
          run(k + 1, end);
        }
        k = end;
      } else if (keyword == "says") {
        open_part(rest);
      } else if (keyword != "wrong" && keyword != "field") {
        refuse("no such line", keyword + " " + rest);
      }
    }
  }

  /// Returns the line of the `end` of a loop, or the end of the section.
  std::size_t end_of_loop(std::size_t first) const {
    int depth = 0;
    for (std::size_t k = first; k < section_.lines.size(); ++k) {
      const std::string& keyword = section_.lines[k].keyword;
      depth += (keyword == "for") - (keyword == "end");
      if (depth == 0) return k;
    }
    return section_.lines.size();
  }

  void define(const std::string& definition) {
    const auto sides = cut(definition, " = ");
    if (!sides) refuse("`let` gives values", definition);
    const auto& [name, body] = *sides;
    if (const std::size_t open = name.find('('); open != std::basic_string<char>::npos) {
      if (functions_.contains(name.substr(0, open))) refuse("a function of every text", name.substr(0, open));
      written_[name.substr(0, open)] = {split(name.substr(open + 1, name.size() - open - 2)), body};
    } else {
      const auto change = changes_.find(name);
      values_[name] = change == changes_.end() ? value(body) : change->second;
    }
  }

  void add_equation(const std::string& text) {
    if (current_ == parts_.size()) refuse("an equation stands below the words that it decides", text);
    Part& part = parts_[current_];
    if (!part.comparison.holds()) return;
    const auto named = cut(text, " :: ");
    const std::vector<std::string> sides = split(named ? named->second : text, " = ", "[");
    if (sides.size() != 2) refuse("an equation has two sides", text);
    const ex lhs = value(sides[0]);
    const ex rhs = value(sides[1]);
    if (part.rational || (!named && part.equations > 0)) refuse("an equation without a name stands alone", text);
    ++part.equations;
    if (named) {
      part.comparison.equal(with_values(named->first), lhs, rhs);
    } else {
      part.rational = rational_identity(lhs, rhs);
    }
  }

  /// Returns the text with expressions in braces replaced by their values.
  std::string with_values(const std::string& text) {
    const std::size_t open = text.find('{'), close = text.find('}');
    if (open == std::string::npos || close == std::string::npos) return text;
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

  /// True if the name is declared as such, or as `name_*` for name_0, name_1, ...
  bool is_declared(const std::string& name) const {
    const std::size_t end = name.find_last_not_of("0123456789") + 1;
    return declared_.contains(name) || (end < name.size() && declared_.contains(name.substr(0, end) + "*"));
  }

  ex named(const std::string& name) override {
    if (const auto place = values_.find(name); place != values_.end()) return place->second;
    if (name == "i") return field_.i();
    if (name == "edge") return 0;
    if (name == "free") return 1;
    if (!is_declared(name)) refuse("no such name", name);
    return symbol_named(name);
  }

  ex call(const std::string& name, const Arguments& arguments) override {
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

  /// Returns the values of "a, b, 0..3"; for "f(j) | j = 0..3" the values of f(0), ..., f(3).
  Arguments items(const std::string& text) override {
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

  ex value(const std::string& text) { return value_of(text, *this); }

  const StatementSection& section_;
  StatementPlace& place_;
  std::set<std::string> declared_;
  WrittenFunctions functions_;
  PhaseField field_;
  std::map<std::string, symbol> symbols_;
  std::map<std::string, ex> values_;
  std::map<std::string, Function> written_;
  std::map<std::string, ex> changes_;  ///< of the current wrong variant
  std::vector<Part> parts_;
  std::size_t current_ = 0;
};

/// Returns the section with the definitions before and after it.
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
      std::ranges::move(StatementReader(whole, symbols, more, place).statements(), std::back_inserter(all));
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
  StatementPlace place;  // the place that is read or decided
  try {
    return read_statements(text, more, decided_elsewhere, place);
  } catch (const UnreadableStatement& error) {
    throw std::logic_error("statement: " + to_text(place) + ": " + error.what());
  }
}

}  // namespace steadyslide::symbolic
