#include "symbolic/statements/written_statements.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>

#include "symbolic/field/comparison.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/polynomial_slope.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

struct Line {
  std::string keyword;
  std::string rest;
};

struct Section {
  std::string id;
  std::vector<Line> lines;
};

[[noreturn]] void refuse(const std::string& what, const std::string& text) {
  throw std::logic_error("statement: " + what + "; " + text);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Both parts, without the separator; absent if it does not occur.
std::optional<std::pair<std::string, std::string>> cut(const std::string& text, const std::string& separator) {
  const std::size_t place = text.find(separator);
  if (place == text.npos) return std::nullopt;
  return std::pair(trimmed(text.substr(0, place)), trimmed(text.substr(place + separator.size())));
}

/// At commas that no parenthesis encloses.
std::vector<std::string> list(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

std::vector<Section> sections(std::string_view text) {
  constexpr std::size_t indent = 2;
  std::vector<Section> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = line.find_first_not_of(' ');
    if (first == line.npos || line[first] == '#') continue;
    const std::string content = line.substr(first);
    if (first == 0) {
      all.push_back({content, {}});
    } else if (all.empty()) {
      refuse("a line belongs to a statement", content);
    } else if (first == indent) {
      const auto words = cut(content + " ", " ");
      all.back().lines.push_back({words->first, words->second});
    } else if (all.back().lines.empty()) {
      refuse("a line continues none", content);
    } else {
      std::string& before = all.back().lines.back().rest;
      before += (before.empty() ? "" : " ") + content;
    }
  }
  return all;
}

int integer(const ex& e) {
  if (!GiNaC::is_a<GiNaC::numeric>(e)) refuse("no number", canonical_text(e));
  return GiNaC::ex_to<GiNaC::numeric>(e).to_int();
}

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

/// Decides one statement and its wrong variants, line by line.
class StatementReader {
 public:
  StatementReader(const Section& section, const WrittenFunctions& more) : section_(section), functions_(more) {
    for (const Line& line : section.lines) {
      if (line.keyword != "field") continue;
      std::vector<ex> frictions;
      for (const std::string& friction : list(line.rest)) frictions.push_back(value(friction));
      field_ = PhaseField(frictions);
    }
    add_functions();
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
      const auto parts = cut(line.rest, " :: ");
      if (!parts) refuse("a wrong variant says what it changes", line.rest);
      values_ = right;
      std::map<std::string, ex> changes;
      for (const std::string& change : list(parts->second)) {
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
      const auto& [keyword, rest] = section_.lines[k];
      if (keyword == "let") {
        for (const std::string& definition : list(rest)) define(definition);
      } else if (keyword == "equal") {
        add_equation(rest, comparison);
      } else if (keyword == "for") {
        const std::size_t end = end_of_loop(k);
        const auto sides = cut(rest, " = ");
        if (!sides) refuse("`for` gives values", rest);
        for (const std::string& item : list(sides->second)) {
          values_[sides->first] = value(item);
          run(k + 1, end, comparison);
        }
        k = end;
      } else if (keyword != "says" && keyword != "wrong" && keyword != "field") {
        refuse("no such line", keyword + " " + rest);
      }
    }
  }

  std::size_t end_of_loop(std::size_t k) const {
    int depth = 0;
    for (;; ++k) {
      const std::string& keyword = section_.lines.at(k).keyword;
      depth += (keyword == "for") - (keyword == "end");
      if (depth == 0) return k;
    }
  }

  void define(const std::string& definition) {
    const auto sides = cut(definition, " = ");
    if (!sides) refuse("`let` gives values", definition);
    const auto& [name, body] = *sides;
    if (const std::size_t open = name.find('('); open != name.npos) {
      written_[name.substr(0, open)] = {list(name.substr(open + 1, name.size() - open - 2)), body};
    } else {
      const auto change = changes_.find(name);
      values_[name] = change == changes_.end() ? value(body) : change->second;
    }
  }

  void add_equation(const std::string& text, Comparison& comparison) {
    const auto named = cut(text, " :: ");
    const auto sides = cut(named ? named->second : text, " = ");
    if (!sides) refuse("an equation has two sides", text);
    const ex lhs = value(sides->first);
    const ex rhs = value(sides->second);
    if (identity_ || (!named && equations_ > 0)) refuse("an equation without a name stands alone", text);
    ++equations_;
    if (named) {
      comparison.equal(named->first, lhs, rhs);
    } else {
      identity_ = rational_identity(words_, lhs, rhs);
    }
  }

  void add_functions() {
    const auto add = [&](const char* name, std::function<ex(const std::vector<ex>&)> function) {
      functions_.emplace(name, std::move(function));
    };
    const auto replaced = [](const std::vector<ex>& a, bool squares) {
      GiNaC::lst equations;
      for (std::size_t k = 1; k + 1 < a.size(); k += 2) equations.append((squares ? a[k] * a[k] : a[k]) == a[k + 1]);
      return equations;
    };
    add("at", [=](const auto& a) { return a[0].subs(replaced(a, false)); });
    add("squares",
        [=](const auto& a) { return a[0].expand().subs(replaced(a, true), GiNaC::subs_options::algebraic); });
    add("diff", [](const auto& a) { return a[0].diff(GiNaC::ex_to<symbol>(a[1])); });
    add("coeff", [](const auto& a) { return a[0].coeff(a[1], integer(a[2])); });
    add("expand", [](const auto& a) { return a[0].expand(); });
    add("normal", [](const auto& a) { return a[0].normal(); });
    add("log", [](const auto& a) -> ex { return GiNaC::log(a[0]); });
    add("r", [this](const auto& a) { return field_.friction(index(a[0])).r; });
    add("cos", [this](const auto& a) { return field_.friction(index(a[0])).cos; });
    add("sin", [this](const auto& a) { return field_.friction(index(a[0])).sin; });
    add("angle", [this](const auto& a) -> ex { return angle(index(a[0])); });
    add("phase", [this](const auto& a) { return field_.phase(form(a[0])); });
    const auto relation = [this](const std::vector<ex>& a) {
      return jump_relation(a[0], a.size() > 1 ? a[1] : ex(field_.i()), a.size() > 2 ? a[2] : ex(1));
    };
    add("ratio", [=](const auto& a) { return relation(a).ratio; });
    add("source", [=](const auto& a) { return relation(a).source; });
    add("power_sum", [](const auto& a) {
      std::vector<ex> powers, places;
      for (std::size_t k = 1; k + 1 < a.size(); k += 2) {
        powers.push_back(a[k]);
        places.push_back(a[k + 1]);
      }
      return power_sums(powers, places, static_cast<std::size_t>(integer(a[0]))).back();
    });
    add("series_of_Y", [](const auto& a) {
      return series_at_infinity({a.begin() + 1, a.end()}, -1, a.size() - 1).at(static_cast<std::size_t>(integer(a[0])));
    });
    for (const auto& [name, kind] : {std::pair("left_edge", PointKind::left_edge),
                                     {"right_edge", PointKind::right_edge},
                                     {"left_free", PointKind::left_free},
                                     {"right_free", PointKind::right_free},
                                     {"jump", PointKind::jump}}) {
      add(name, [kind = kind](const auto& a) { return expression(derived_exponent(kind), {a.front(), a.back()}); });
    }
  }

  std::size_t index(const ex& friction) const {
    for (std::size_t k = 0; k < field_.size(); ++k) {
      if (field_.friction(k).s.is_equal(friction)) return k;
    }
    refuse("no friction of the field", section_.id);
  }

  ex angle(std::size_t k) { return named("angle_" + std::to_string(k)); }

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

  ex named(const std::string& name) {
    if (name == "i") return field_.i();
    if (const auto place = values_.find(name); place != values_.end()) return place->second;
    return symbols_.try_emplace(name, symbol(name)).first->second;
  }

  ex call(const std::string& name, const std::vector<ex>& arguments) {
    if (const auto place = functions_.find(name); place != functions_.end()) return place->second(arguments);
    const auto place = written_.find(name);
    if (place == written_.end() || place->second.parameters.size() != arguments.size()) {
      refuse("no such function", name);
    }
    const std::map<std::string, ex> outside = values_;
    for (std::size_t k = 0; k < arguments.size(); ++k) values_[place->second.parameters[k]] = arguments[k];
    const ex result = value(place->second.body);
    values_ = outside;
    return result;
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
      const ex base = atom();
      return next('^') ? GiNaC::pow(base, factor()) : base;
    }
    ex atom() {
      if (next('(')) {
        const ex inside = sum();
        close();
        return inside;
      }
      std::string name;
      for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '\'') break;
        name += c;
      }
      if (name.empty()) refuse("not an expression", text_);
      if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) return GiNaC::numeric(name.c_str());
      if (!next('(')) return statement_.named(name);
      std::vector<ex> arguments{sum()};
      while (next(',')) arguments.push_back(sum());
      close();
      return statement_.call(name, arguments);
    }
    void close() {
      if (!next(')')) refuse("a parenthesis is not closed", text_);
    }

    StatementReader& statement_;
    std::string text_;
    std::size_t at_ = 0;
  };
  ex value(const std::string& text) { return ExpressionReader(*this, text).all(); }

  const Section& section_;
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

}  // namespace

std::vector<DecidedStatement> written_statements(std::string_view text,
                                                 const std::vector<DecidedStatement>& decided_elsewhere,
                                                 const WrittenFunctions& more) {
  std::vector<DecidedStatement> all;
  std::size_t others = 0;
  std::vector<Line> definitions;
  for (Section section : sections(text)) {
    if (section.id == "definitions") {
      definitions = section.lines;
      continue;
    }
    if (!section.lines.empty()) {
      section.lines.insert(section.lines.begin(), definitions.begin(), definitions.end());
      all.push_back(StatementReader(section, more).statement());
      continue;
    }
    const auto other =
        std::ranges::find_if(decided_elsewhere, [&](const DecidedStatement& s) { return s.id == section.id; });
    if (other == decided_elsewhere.end()) refuse("not decided", section.id);
    all.push_back(*other);
    ++others;
  }
  if (others != decided_elsewhere.size()) refuse("one that is decided is not in the text", std::to_string(others));
  return all;
}

}  // namespace steadyslide::symbolic
