#include "app/report/math_symbols.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace steadyslide::app {
namespace {

using Glyphs = std::pair<std::string_view, std::string_view>;

constexpr std::array<Glyphs, 36> letters{
    {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"eps", "ε"},
     {"zeta", "ζ"},  {"eta", "η"},   {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"},   {"lambda", "λ"},
     {"mu", "μ"},    {"nu", "ν"},    {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},     {"sigma", "σ"},
     {"tau", "τ"},   {"phi", "φ"},   {"chi", "χ"},   {"psi", "ψ"},    {"omega", "ω"},   {"ell", "ℓ"},
     {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},      {"Pi", "Π"},
     {"Sigma", "Σ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},   {"Omega", "Ω"},  {"upsilon", "υ"}, {"Upsilon", "Υ"}}};

constexpr std::array<Glyphs, 4> upright_signs{{{"oo", "∞"}, {"partial", "∂"}, {"nabla", "∇"}, {"emptyset", "∅"}}};

constexpr std::array<std::string_view, 32> functions{
    "sin",  "cos",  "tan", "cot", "sec", "csc",  "arcsin", "arccos", "arctan", "arccot", "sinh",
    "cosh", "tanh", "log", "ln",  "exp", "max",  "min",    "sup",    "inf",    "lim",    "arg",
    "det",  "dim",  "deg", "Re",  "Im",  "sinc", "sign",   "sgn",    "supp",   "limsup"};

constexpr std::array<Glyphs, 4> big{{{"int", "∫"}, {"sum", "∑"}, {"prod", "∏"}, {"oint", "∮"}}};

constexpr std::array<Glyphs, 6> named_relations{
    {{"in", "∈"}, {"notin", "∉"}, {"subset", "⊂"}, {"approx", "≈"}, {"propto", "∝"}, {"equiv", "≡"}}};

constexpr std::array<Glyphs, 5> named_operations{
    {{"cup", "∪"}, {"cap", "∩"}, {"times", "×"}, {"cdot", "⋅"}, {"setminus", "∖"}}};

constexpr std::array<std::string_view, 13> words{"for", "and", "or",    "if", "on", "where", "with",
                                                 "of",  "as",  "while", "at", "to", "not"};

constexpr std::array<Glyphs, 15> relations{{{"=", "="},
                                            {"<", "&lt;"},
                                            {">", "&gt;"},
                                            {"<=", "≤"},
                                            {">=", "≥"},
                                            {"!=", "≠"},
                                            {"~", "∼"},
                                            {"~=", "≈"},
                                            {"->", "→"},
                                            {"<-", "←"},
                                            {"=>", "⇒"},
                                            {"<=>", "⇔"},
                                            {"<->", "↔"},
                                            {":=", "≔"},
                                            {"|->", "↦"}}};

constexpr std::array<Glyphs, 5> operations{{{"+", "+"}, {"-", "−"}, {"+-", "±"}, {"-+", "∓"}, {"*", "∗"}}};

constexpr std::array<Glyphs, 3> punctuation{{{",", ","}, {";", ";"}, {":", ":"}}};

template <std::size_t n>
const Glyphs* find(const std::array<Glyphs, n>& table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &Glyphs::first);
  return found == table.end() ? nullptr : &*found;
}

template <std::size_t n>
bool holds(const std::array<std::string_view, n>& table, std::string_view name) {
  return std::ranges::find(table, name) != table.end();
}

}  // namespace

std::optional<MathSymbol> math_name(std::string_view name) {
  if (const Glyphs* g = find(letters, name)) return MathSymbol{g->second, MathRole::operand};
  if (const Glyphs* g = find(upright_signs, name)) return MathSymbol{g->second, MathRole::operand, true};
  if (const Glyphs* g = find(big, name)) return MathSymbol{g->second, MathRole::big};
  if (const Glyphs* g = find(named_relations, name)) return MathSymbol{g->second, MathRole::relation};
  if (const Glyphs* g = find(named_operations, name)) return MathSymbol{g->second, MathRole::binary};
  if (holds(functions, name)) return MathSymbol{name, MathRole::function, true};
  if (holds(words, name)) return MathSymbol{name, MathRole::word, true};
  return std::nullopt;
}

std::optional<MathSymbol> math_sign(std::string_view sign) {
  if (const Glyphs* g = find(relations, sign)) return MathSymbol{g->second, MathRole::relation};
  if (const Glyphs* g = find(operations, sign)) return MathSymbol{g->second, MathRole::binary};
  if (const Glyphs* g = find(punctuation, sign)) return MathSymbol{g->second, MathRole::punctuation};
  return std::nullopt;
}

std::optional<std::string_view> math_accent(std::string_view name) {
  if (name == "bar") return "‾";
  if (name == "tilde") return "˜";
  if (name == "hat") return "^";
  return std::nullopt;
}

}  // namespace steadyslide::app
