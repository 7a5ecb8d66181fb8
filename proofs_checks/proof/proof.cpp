#include "proofs_checks/proof/proof.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

#include "proofs_checks/proof/meaning.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// The reason why a proof stops, in words.
struct Gap {
  std::string words;
  std::string counterexample = {};
};

class ProofChecker {
 public:
  ProofChecker(const ProofText& text, const Theory& theory, const Decisions& decisions)
      : text_(text), theory_(theory), decisions_(decisions) {}

  CheckedProof run() {
    for (const auto* facts : {&text_.assumes, &text_.concludes}) {
      for (const Fact& fact : *facts) theory_.require_declared(fact);
    }
    for (const Fact& fact : text_.assumes) nodes_.push_back({fact, "assumed"});
    std::string gap, counterexample;
    try {
      for (const ProofStep& step : text_.steps) take(step);
      for (const Fact& fact : text_.concludes) {
        const auto place = place_of(fact);
        if (!place || *place < text_.assumes.size()) throw Gap{"concluded, and given by no step: " + text_of(fact)};
      }
      for (std::size_t k = 0; k < text_.assumes.size(); ++k) {
        const auto rests_on_it = [&](const ProofNode& node) { return std::ranges::count(node.from, k) > 0; };
        if (std::ranges::none_of(nodes_, rests_on_it))
          throw Gap{"assumed, and used by no step: " + text_of(text_.assumes[k])};
      }
    } catch (const Gap& g) {
      gap = g.words;
      counterexample = g.counterexample;
    }
    return {text_, std::move(nodes_), std::move(gap), std::move(counterexample), std::move(run_), std::move(in_words_)};
  }

 private:
  std::optional<std::size_t> place_of(const Fact& fact) const {
    const auto found = std::ranges::find(nodes_, fact, &ProofNode::fact);
    if (found == nodes_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - nodes_.begin());
  }
  std::size_t needed(const Fact& fact, const Fact& by) const {
    const auto place = place_of(fact);
    if (!place) throw Gap{text_of(by) + " needs " + text_of(fact)};
    return *place;
  }

  void take(const ProofStep& step) {
    theory_.require_declared(step.fact);
    ProofNode node{step.fact, by_what(step)};
    switch (step.kind) {
      case ProofStep::Kind::identity: by_identity(node); break;
      case ProofStep::Kind::sign: by_sign(node); break;
      case ProofStep::Kind::enclosure: by_enclosure(node); break;
      case ProofStep::Kind::theorem: {
        const auto theorem = theory_.theorems.find(step.name);
        if (theorem == theory_.theorems.end()) throw Gap{"no classical theorem of this name: " + step.name};
        const Rule& rule = by_rules(node, theorem->second);
        node.words.push_back(rule.words);
        run(rule, by_what(step));
        break;
      }
      case ProofStep::Kind::definition: by_rule_of_word(node, theory_.definitions, "not defined: "); break;
      case ProofStep::Kind::inference: by_rule_of_word(node, theory_.inferences, "no inference of: "); break;
      case ProofStep::Kind::entry: by_entry(node, step.name); break;
    }
    if (decisions_.meaning) require(decisions_.meaning->of(node.fact));
    nodes_.push_back(std::move(node));
  }

  void by_rule_of_word(ProofNode& node, const std::map<std::string, Rule>& rules, const std::string& none) {
    const auto rule = rules.find(node.fact.word);
    if (rule == rules.end()) throw Gap{none + node.fact.word};
    by_rules(node, std::span(&rule->second, 1));
    run(rule->second, node.by);
  }

  static void require(const Run& run) {
    if (!run.counterexample.empty()) throw Gap{"refuted: " + run.counterexample, run.counterexample};
    if (!run.idle.empty()) throw Gap{"no instance shows that a premise is needed: " + run.idle.front()};
  }

  void run(const Rule& rule, const std::string& by) {
    const std::string name = by + ": " + text_of(rule.gives);
    if (!decisions_.meaning || decisions_.meaning->of(rule).instances == 0) {
      in_words_.insert(name);
    } else {
      run_.insert(name);
    }
    if (decisions_.meaning) require(decisions_.meaning->of(rule));
  }

  std::vector<const DecidedFact*> decided(const Fact& fact, DecidedFact::By by) const {
    std::vector<const DecidedFact*> all;
    for (const DecidedFact& one : theory_.decided) {
      if (one.fact == fact && one.by == by) all.push_back(&one);
    }
    if (all.empty()) throw Gap{"nothing is said to decide " + text_of(fact)};
    return all;
  }

  void require(const Decision& decision, const std::string& id) const {
    if (decision.holds == Truth::yes) return;
    std::string words;
    for (const std::string& w : decision.words) words += (words.empty() ? ": " : "; ") + w;
    throw Gap{(decision.holds == Truth::no ? "does not hold: " : "not decided: ") + id + words};
  }

  void by_identity(ProofNode& node) const {
    const auto rows = decided(node.fact, DecidedFact::By::identity);
    if (rows.size() > 1) throw std::logic_error("two rows of identities for " + text_of(node.fact));
    for (const Fact& fact : rows[0]->where) node.from.push_back(needed(fact, node.fact));
    for (const std::string& id : rows[0]->ids) {
      Decision decision = decisions_.identity(id);
      require(decision, id);
      if (std::ranges::find(decision.decides, node.fact) == decision.decides.end()) {
        throw Gap{id + " does not say that it decides " + text_of(node.fact)};
      }
      for (const std::string& divisor : decision.divisors) {
        if (std::ranges::find(rows[0]->where, Fact{"nonzero", {'"' + divisor + '"'}}) == rows[0]->where.end()) {
          throw Gap{id + " holds where " + divisor + " != 0, and nothing says so"};
        }
      }
      std::ranges::move(decision.words, std::back_inserter(node.words));
    }
  }

  void by_sign(const ProofNode& node) const {
    const auto& [word, things] = node.fact;
    const bool formula = things.size() == 1 && things[0].size() > 2 && things[0].front() == '"';
    if (!formula || (word != "positive" && word != "negative" && word != "nonzero")) {
      throw Gap{"no sign of a formula: " + text_of(node.fact)};
    }
    const std::string polynomial = things[0].substr(1, things[0].size() - 2);
    const auto positive = [&](const std::string& p) { return decisions_.positive(p, text_.parameters) == Truth::yes; };
    const std::string opposite = "-(" + polynomial + ")";
    const bool holds = (word != "negative" && positive(polynomial)) || (word != "positive" && positive(opposite));
    if (!holds) throw Gap{"not decided for " + text_of(text_.parameters) + ": " + text_of(node.fact)};
  }

  void by_enclosure(ProofNode& node) const {
    std::vector<Box> boxes;
    for (const DecidedFact* row : decided(node.fact, DecidedFact::By::enclosure)) {
      for (const std::string& id : row->ids) {
        Decision decision = decisions_.enclosure(id, row->box);
        require(decision, id + " for " + text_of(row->box));
        std::ranges::move(decision.words, std::back_inserter(node.words));
      }
      boxes.push_back(row->box);
    }
    if (!covers(boxes, text_.parameters)) {
      throw Gap{text_of(node.fact) + " is decided over boxes that do not cover " + text_of(text_.parameters)};
    }
  }

  /// Returns the first rule that gives the fact from the facts above. Throws Gap if there is none.
  const Rule& by_rules(ProofNode& node, std::span<const Rule> rules) const {
    std::string missing;
    for (const Rule& rule : rules) {
      for (const Fact& given : rule.gives) {
        const auto bindings = match(given, node.fact);
        if (bindings && find_needs(rule.needs, *bindings, node.from, missing)) return rule;
      }
    }
    const std::string& name = rules.front().name;
    throw Gap{text_of(node.fact) +
              (missing.empty() ? " is not what " + name + " gives" : " by " + name + " needs " + missing)};
  }

  /// True if facts above match all needs. A variable that occurs only in the needs may stand for any thing that fits
  /// all of them. `from` receives the nodes of these facts, `missing` the first need without one.
  bool find_needs(std::span<const Fact> needs, const Bindings& bindings, std::vector<std::size_t>& from,
                  std::string& missing) const {
    if (needs.empty()) return true;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const auto more = match(needs.front(), nodes_[k].fact, bindings);
      if (!more) continue;
      from.push_back(k);
      if (find_needs(needs.subspan(1), *more, from, missing)) return true;
      from.pop_back();
    }
    if (missing.empty()) missing = text_of(replaced(needs.front(), bindings));
    return false;
  }

  void by_entry(ProofNode& node, const std::string& id) {
    const CheckedProof* entry = decisions_.entry(id);
    if (!entry) throw Gap{"no entry with a proof: " + id};
    if (!entry->complete()) throw Gap{"the proof of " + id + " has a gap: " + entry->gap};
    if (std::ranges::find(entry->text.concludes, node.fact) == entry->text.concludes.end()) {
      throw Gap{id + " does not conclude " + text_of(node.fact)};
    }
    if (!covers(std::span(&entry->text.parameters, 1), text_.parameters)) {
      throw Gap{id + " is proved for " + text_of(entry->text.parameters) + " only"};
    }
    for (const Fact& fact : entry->text.assumes) node.from.push_back(needed(fact, node.fact));
    run_.insert(entry->rules_run.begin(), entry->rules_run.end());
    in_words_.insert(entry->rules_in_words.begin(), entry->rules_in_words.end());
  }

  const ProofText& text_;
  const Theory& theory_;
  const Decisions& decisions_;
  std::vector<ProofNode> nodes_;
  std::set<std::string> run_, in_words_;
};

}  // namespace

CheckedProof check_proof(const ProofText& text, const Theory& theory, const Decisions& decisions) {
  return ProofChecker(text, theory, decisions).run();
}

std::vector<TreeLine> tree_of(const CheckedProof& proof) {
  std::vector<TreeLine> lines;
  std::set<std::size_t> shown;
  const auto show = [&](const auto& self, std::size_t node, std::size_t depth) -> void {
    const bool again = !shown.insert(node).second;
    lines.push_back({node, depth, again});
    if (again) return;
    for (const std::size_t from : proof.nodes[node].from) self(self, from, depth + 1);
  };
  for (const Fact& fact : proof.text.concludes) {
    const auto found = std::ranges::find(proof.nodes, fact, &ProofNode::fact);
    if (found != proof.nodes.end()) show(show, static_cast<std::size_t>(found - proof.nodes.begin()), 0);
  }
  return lines;
}

std::string count_of_steps(const CheckedProof& proof) {
  std::string text;
  const auto count = [&](ProofStep::Kind kind, const std::string& one, const std::string& many) {
    std::size_t n = 0;
    std::set<std::string> names;
    for (const ProofStep& step : proof.text.steps) {
      if (step.kind != kind) continue;
      ++n;
      if (!step.name.empty()) names.insert(step.name);
    }
    if (!names.empty()) n = names.size();
    if (n == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + (n == 1 ? one : many);
    std::string listed;
    for (const std::string& name : names) listed += (listed.empty() ? "" : ", ") + name;
    if (!listed.empty()) text += " (" + listed + ")";
  };
  count(ProofStep::Kind::identity, "identity", "identities");
  count(ProofStep::Kind::sign, "sign", "signs");
  count(ProofStep::Kind::enclosure, "enclosure", "enclosures");
  count(ProofStep::Kind::theorem, "classical theorem", "classical theorems");
  count(ProofStep::Kind::definition, "definition", "definitions");
  count(ProofStep::Kind::inference, "inference", "inferences");
  count(ProofStep::Kind::entry, "entry", "entries");
  const std::size_t words = proof.rules_in_words.size();
  if (words > 0) text += "; rests on " + std::to_string(words) + (words == 1 ? " rule in words" : " rules in words");
  return text;
}

}  // namespace steadyslide::proofs_checks
