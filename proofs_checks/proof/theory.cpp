#include "proofs_checks/proof/theory.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/join.hpp>
#include <iterator>
#include <set>
#include <stdexcept>

#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {

namespace embedded {
extern const std::string_view proofs_md;  // docs/proofs.md
extern const std::string_view facts_md;   // proofs_checks/facts/*.md
}  // namespace embedded

namespace {

void add_once(auto& map, const std::string& name, auto value) {
  if (!map.emplace(name, std::move(value)).second) throw std::logic_error("declared twice: " + name);
}

/// Adds the facts of a row of the table "Decided"; for an enclosure, each fact over each of its boxes.
void add_decided(std::vector<DecidedFact>& all, const std::vector<std::string>& cells) {
  const std::string& by = cells[1];
  const std::size_t space = by.find(' ');
  const std::string kind = by.substr(0, space);
  if (space == std::string::npos || (kind != "identity" && kind != "enclosure")) {
    throw std::logic_error("decided neither by an identity nor by an enclosure: " + cells[0] + ", " + by);
  }
  const std::vector<std::string> ids = items_of(by.substr(space + 1));
  const std::vector<std::string> boxes = cells[2].empty() ? std::vector<std::string>{""} : list_of(cells[2], "; ");
  for (const Fact& fact : parse_facts(cells[0])) {
    if (kind == "identity") {
      all.push_back({fact, DecidedFact::By::identity, ids, parse_facts(cells[2]), {}});
      continue;
    }
    for (const std::string& box : boxes) all.push_back({fact, DecidedFact::By::enclosure, ids, {}, parse_box(box)});
  }
}

/// Returns a variable of the facts that the rule gives that does not occur in its needs, or nothing.
std::optional<std::string> free_variable(const Rule& rule) {
  for (const Fact& given : rule.gives) {
    for (const std::string& thing : given.things) {
      const auto names = [&](const Fact& fact) { return std::ranges::find(fact.things, thing) != fact.things.end(); };
      if (is_variable(thing) && std::ranges::none_of(rule.needs, names)) return thing;
    }
  }
  return std::nullopt;
}

/// Returns the formulas of a sentence that are run, **`...`**. Takes their marks out of it.
std::vector<std::string> take_formulas(std::string& says) {
  std::vector<std::string> formulas;
  for (std::size_t from = 0; (from = says.find("**`", from)) != std::string::npos;) {
    const std::size_t to = says.find("`**", from);
    if (to == std::string::npos) throw std::logic_error("a formula without end: " + says);
    formulas.push_back(says.substr(from + 3, to - from - 3));
    says.replace(to, 3, "`").replace(from, 3, "`");
  }
  return formulas;
}

/// Returns the text with `value(k)` in place of the k-th variable. A variable is a whole word.
std::string with_values(const Fact& declared, const std::string& text, const auto& value) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::string result;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string word = text.substr(k, end - k);
    const auto found = std::ranges::find(declared.things, word);
    const bool is_value = !word.empty() && found != declared.things.end();
    result += is_value ? value(static_cast<std::size_t>(found - declared.things.begin())) : word;
    if (end < text.size()) result += text[end];
    k = end + 1;
  }
  return result;
}

/// Reads documents line by line into a theory.
class Reader {
 public:
  explicit Reader(Theory& theory) : theory_(theory) {}

  void read(std::string_view line) {
    if (line.starts_with("# ")) {
      part_.clear();
      rules_ = nullptr;
    } else if (line.starts_with("## ")) {
      open_tables(std::string(line.substr(3)));
    } else if (line.starts_with("### ")) {
      open_theorem(std::string(line.substr(4)));
    } else if (line.starts_with('|')) {
      if (is_rule_of_table(line)) {
        in_rows_ = true;
      } else if (in_rows_) {
        row(cells_of(line));
      }
    } else {
      in_rows_ = false;
      if (rules_) words(line);
    }
  }

 private:
  void open(std::string part) {
    part_ = std::move(part);
    in_rows_ = false;
    rules_ = nullptr;
    facts_ = nullptr;
  }

  void open_tables(std::string part) {
    open(std::move(part));
    static const std::set<std::string> parts{"Words", "Things", "Definitions", "Decided", "Instances"};
    if (!parts.contains(part_)) {
      throw std::logic_error("a heading that a theory does not have: " + part_);
    }
  }

  void open_theorem(std::string name) {
    open(std::move(name));
    add_once(theory_.theorems, part_, std::vector<Rule>{Rule{part_, {}, {}, {}}});
    rules_ = &theory_.theorems.at(part_);
  }

  void row(const std::vector<std::string>& cells) {
    if (part_.empty() || rules_) throw std::logic_error("a row outside a table of a theory: " + cells.at(0));
    const bool good = part_ == "Words"     ? cells.size() == 2 || cells.size() == 3
                      : part_ == "Decided" ? cells.size() == 3
                                           : cells.size() == 2;
    if (!good) throw std::logic_error("not a row of the table " + part_ + ": " + cells.at(0));
    if (part_ == "Things") {
      const std::string name = items_of(cells[0]).at(0);
      add_once(theory_.things, name, with_formulas_of(name, cells[1]));
    } else if (part_ == "Decided") {
      add_decided(theory_.decided, cells);
    } else if (part_ == "Instances") {
      for (const std::string& of : list_of(cells[0], "; ")) {
        const bool of_rule = of.find('(') != std::string::npos;
        for (const Fact& fact : parse_facts(of_rule ? of : "of(" + of + ")")) {
          const std::string name = text_of(fact);
          const std::string key = of_rule ? name : name.substr(3, name.size() - 4);
          add_once(theory_.instances, key, InstanceRow{key, items_of(cells[1])});
        }
      }
    } else {
      const Fact fact = parse_fact(items_of(cells[0]).at(0));
      const std::set<std::string> different(fact.things.begin(), fact.things.end());
      if (!std::ranges::all_of(fact.things, is_variable) || different.size() != fact.things.size()) {
        throw std::logic_error("a word is declared, defined and inferred for all things: " + cells[0]);
      }
      const std::size_t needs = part_ == "Words" ? 2 : 1;
      Rule rule{fact.word, {}, {}, {fact}};
      if (cells.size() > needs) rule.needs = parse_facts(cells[needs]);
      if (part_ == "Words") add_once(theory_.words, fact.word, std::pair(fact, with_formulas_of(fact.word, cells[1])));
      if (part_ == "Definitions") add_once(theory_.definitions, fact.word, rule);
      if (part_ == "Words" && !rule.needs.empty()) add_once(theory_.inferences, fact.word, rule);
    }
  }

  /// Keeps the formulas of a word or of a thing that are run, and returns the sentence without their marks.
  std::string with_formulas_of(const std::string& name, std::string says) {
    if (auto formulas = take_formulas(says); !formulas.empty()) add_once(theory_.formulas, name, std::move(formulas));
    return says;
  }

  /// Reads a line of a theorem. The facts after Needs and Gives may take several lines and end at an empty one. Words
  /// after the given facts begin another rule.
  void words(std::string_view line) {
    const bool needs = line.starts_with("Needs ");
    if (needs || line.starts_with("Gives ")) {
      facts_ = needs ? &rules_->back().needs : &rules_->back().gives;
      line.remove_prefix(6);
    }
    if (line.empty()) {
      facts_ = nullptr;
    } else if (facts_) {
      std::ranges::move(parse_facts(line), std::back_inserter(*facts_));
    } else {
      if (!rules_->back().gives.empty()) rules_->push_back({part_, {}, {}, {}});
      std::string& text = rules_->back().words;
      text += (text.empty() ? "" : " ") + std::string(line);
    }
  }

  Theory& theory_;
  std::string part_;
  bool in_rows_ = false;
  std::vector<Rule>* rules_ = nullptr;  ///< of the theorem that is read at present
  std::vector<Fact>* facts_ = nullptr;
};

}  // namespace

Theory::Theory(std::span<const std::string_view> documents) {
  for (const std::string_view document : documents) {
    Reader reader(*this);
    for (const std::string_view line : parts_of(document, "\n")) reader.read(line);
  }
  const auto all_declared = [&](const std::vector<Fact>& facts) {
    for (const Fact& fact : facts) require_declared(fact, true);
  };
  const auto check = [&](const Rule& rule) {
    if (rule.gives.empty()) throw std::logic_error("a theorem that gives nothing: " + rule.name);
    all_declared(rule.needs);
    all_declared(rule.gives);
    if (const auto free = free_variable(rule)) {
      throw std::logic_error(rule.name + " says something of any " + *free + ", and needs nothing of it");
    }
  };
  for (const auto& [word, rule] : definitions) {
    check(rule);
    if (inferences.contains(word)) throw std::logic_error("both defined and inferred: " + word);
  }
  for (const auto& [word, rule] : inferences) check(rule);
  for (const auto& [name, rules] : theorems) std::ranges::for_each(rules, check);
  for (const auto& [of, row] : instances) {
    if (of.find('(') != std::string::npos) {
      require_declared(parse_fact(of), true);
      continue;
    }
    for (const std::string& thing : items_of(of)) {
      if (!things.contains(thing)) throw std::logic_error("instances of a thing that is not declared: " + thing);
    }
  }
  std::map<std::string, Fact> first;  // by identity: the first fact that it decides
  for (const DecidedFact& one : decided) {
    require_declared(one.fact);
    for (const Fact& fact : one.where) require_declared(fact);
    if (one.by != DecidedFact::By::identity) continue;
    for (const std::string& id : one.ids) {
      const Fact& other = first.try_emplace(id, one.fact).first->second;
      if (other.word != one.fact.word) {
        throw std::logic_error("one identity, two facts: " + id + ", " + text_of(other) + " and " + text_of(one.fact));
      }
    }
  }
}

void Theory::require_declared(const Fact& fact, bool in_rule) const {
  const auto word = words.find(fact.word);
  if (word == words.end()) throw std::logic_error("a word that is not declared: " + text_of(fact));
  if (word->second.first.things.size() != fact.things.size()) {
    throw std::logic_error("not as the word is declared, " + text_of(word->second.first) + ": " + text_of(fact));
  }
  for (const std::string& thing : fact.things) {
    const bool known = thing.starts_with('"') || things.contains(thing) || (in_rule && is_variable(thing));
    if (!known) throw std::logic_error("a thing that is not declared: " + thing + " in " + text_of(fact));
  }
}

std::string Theory::sentence(const Fact& fact) const {
  // The list of things explains their names.
  const auto& [declared, says] = words.at(fact.word);
  return with_values(declared, says, [&](std::size_t k) {
    const std::string& thing = fact.things[k];
    return thing.starts_with('"') ? thing.substr(1, thing.size() - 2) : thing;
  });
}

std::string Theory::formula(const Fact& fact, const std::string& formula) const {
  const Fact& declared = words.at(fact.word).first;
  return with_values(declared, formula, [&](std::size_t k) -> std::string {
    const std::string& thing = fact.things[k];
    if (thing.starts_with('"')) return "(" + thing.substr(1, thing.size() - 2) + ")";
    const auto own = formulas.find(thing);
    return own == formulas.end() ? thing : "(" + boost::algorithm::join(own->second, ") and (") + ")";
  });
}

const Theory& theory() {
  static const std::array documents{section_of(embedded::proofs_md, "## Classical theorems"), embedded::facts_md};
  static const Theory all(documents);
  return all;
}

}  // namespace steadyslide::proofs_checks
