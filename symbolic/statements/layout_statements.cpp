// The flat punch under any strips: |Y| beside it by A = int alpha dy/(x+y) and B = int alpha dy/(x-y), the balance of the
// tangential force, both directions of sliding, the load behind one jump, the centre of pressure. Logarithms of distances
// and exponentials are symbols of their own. [Bal16, (4)-(7)]

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

ex one_half() { return ex(1) / 2; }

/// front: sum p_j log(x-e_j) = -log(x^2-1)/2 - B, behind: sum p_j log(x+e_j) = -log(x^2-1)/2 + A, on one strip.
DecidedStatement surface_base() {
  const auto decided = [](const std::string& words, int angle, const ex& edges) {
    const symbol a("alpha"), left("log_left"), right("log_right");  // of the distances to both edges
    const PhaseField field;
    const ex powers = -(edges + a) * left - (edges - a) * right;
    return Comparison(field)
        .equal("in front", powers, -(left + right) / 2 - angle * a * (left - right))
        .equal("behind", powers, -(left + right) / 2 + angle * a * (right - left))
        .as(words);
  };
  return {"rh-layout-surface-base",
          decided("one strip: |Y| is e^-B/sqrt(x^2-1) in front and e^A/sqrt(x^2-1) behind", 1, one_half()),
          {decided("alpha of the other sign", -1, one_half()), decided("without alpha", 0, one_half()),
           decided("the power 1 + alpha at the edges", 1, 1), decided("2 alpha", 2, one_half())}};
}

/// One more jump, at c in the last strip: its powers add (alpha_0 - alpha_1) (log(x-c) - log(x-b)), b the right edge.
DecidedStatement surface_step() {
  struct Variant {
    int beta = 1;
    int front = -1;
    int behind = 1;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol a0("alpha_0"), a1("alpha_1"), last("log_last"), jump("log_c"), edge("log_b");
    const PhaseField field;
    const ex change = v.beta * (a0 - a1) * jump + (a1 - a0) * edge;
    const ex one = a0 * (last - edge);
    const ex two = a0 * (last - jump) + a1 * (jump - edge);
    return Comparison(field)
        .equal("in front", change, v.front * (two - one))
        .equal("behind", change, v.behind * (one - two))
        .as(words);
  };
  return {"rh-layout-surface-step",
          decided("one more jump: what the powers add to log |Y| is what it adds to -B in front and to A behind", {}),
          {decided("beta of the other sign", {.beta = -1}), decided("+B in front", {.front = 1}),
           decided("-A behind", {.behind = -1}), decided("2 B in front", {.front = -2})}};
}

/// The integrals over a strip: d log(x+y)/dy = 1/(x+y), d(-log(x-y))/dy = 1/(x-y).
DecidedStatement logarithms() {
  const auto decided = [](const std::string& words, int behind, int front) {
    const symbol x("x"), y("y");
    const PhaseField field;
    return Comparison(field)
        .equal("behind", behind * GiNaC::log(x + y).diff(y), 1 / (x + y))
        .equal("in front", front * GiNaC::log(x - y).diff(y), 1 / (x - y))
        .as(words);
  };
  return {"rh-layout-logarithms",
          decided("log(x+y) and -log(x-y) are primitives of 1/(x+y) and 1/(x-y) in y", 1, -1),
          {decided("log(x-y) without its sign", 1, 1), decided("-log(x+y)", -1, -1), decided("twice", 2, -2),
           decided("three times", 3, -3)}};
}

/// int_-L^L F+ has the real part 0 far away: on the contact Re F+ = H t = -s t, beside it F = -(P/pi) |Y| behind and
/// (P/pi) |Y| in front.
DecidedStatement balance() {
  struct Variant {
    int friction = -1;
    int behind = -1;
    bool pi = true;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol force("int_st"), behind("int_behind"), front("int_front"), load("P"), pi("pi");
    const PhaseField field;
    const ex beside = load / (v.pi ? ex(pi) : ex(1)) * (front + v.behind * behind);
    // Solved for int s t dx where the sum of the three parts vanishes.
    const ex solved = -beside / v.friction;
    return Comparison(field)
        .equal("vanishes", v.friction * force + beside, v.friction * (force - solved))
        .equal("-int s t dx", -solved, load / pi * (behind - front))
        .as(words);
  };
  return {
      "rh-layout-balance",
      decided("-int s t dx = (P/pi) (int |Y| behind - int |Y| in front), where the real part of int F+ vanishes", {}),
      {decided("H t = s t", {.friction = 1}), decided("u' positive behind", {.behind = 1}),
       decided("without 1/pi", {.pi = false}), decided("H t = -2 s t", {.friction = -2})}};
}

/// e^A - e^-B + e^-A - e^B = 2 (cosh A - cosh B).
DecidedStatement direction() {
  const auto decided = [](const std::string& words, int reversed, const ex& factor, int second) {
    const symbol a("exp_A"), na("exp_minus_A"), b("exp_B"), nb("exp_minus_B");
    const PhaseField field;
    return Comparison(field)
        .equal("both directions", (a - nb) + reversed * (na - b), factor * ((a + na) / 2 + second * (b + nb) / 2))
        .as(words);
  };
  return {"rh-layout-direction",
          decided("e^A - e^-B and the same with -A, -B add up to 2 (cosh A - cosh B)", 1, 2, -1),
          {decided("subtracted", -1, 2, -1), decided("cosh A - cosh B once", 1, 1, -1),
           decided("cosh A + cosh B", 1, 2, 1), decided("cosh A alone", 1, 2, 0)}};
}

/// Two equal halves on [-1, 1]: the logarithms of x, x-1 and x+1 are symbols; cosh A - cosh B with e^A = u v, e^B = u/v.
DecidedStatement halves() {
  struct Variant {
    bool exchanged = false;
    int middle = 2;
    ex factor = 2;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol x("x"), a1("alpha_1"), a2("alpha_2"), lx("log_x"), lm("log_x_minus_1"), lp("log_x_plus_1");
    const symbol u("u"), iu("u_inverse"), w("v"), iw("v_inverse");
    const PhaseField field;
    const ex a = a1 * (lx - lm) + a2 * (lp - lx);
    const ex b = v.exchanged ? a : a1 * (lp - lx) + a2 * (lx - lm);
    const ex cosh_a = (u * w + iu * iw) / 2;
    const ex cosh_b = (u * iw + iu * w) / 2;
    return Comparison(field)
        .equal("A - B", a - b, (a1 - a2) * (v.middle * lx - lm - lp))
        .equal("A + B", a + b, (a1 + a2) * (lp - lm))
        .equal("cosh A - cosh B", cosh_a - cosh_b, v.factor * (u - iu) / 2 * (w - iw) / 2)
        .equal("x^2 above (x-1)(x+1)", x * x - (x - 1) * (x + 1), 1)
        .equal("x+1 above x-1", (x + 1) - (x - 1), 2)
        .as(words);
  };
  return {"rh-layout-halves",
          decided("two equal halves: A - B = (alpha_1 - alpha_2) log(x^2/(x^2-1)), A + B = (alpha_1 + alpha_2) "
                  "log((x+1)/(x-1)), cosh A - cosh B = 2 sinh((A+B)/2) sinh((A-B)/2)",
                  {}),
          {decided("A for B", {.exchanged = true}), decided("log(x/(x^2-1))", {.middle = 1}),
           decided("cosh A - cosh B without the 2", {.factor = 1}), decided("of the other sign", {.factor = -2})}};
}

/// v = (c-x)/(1-x), v = u r, c = 2 u - 1, takes the load behind the jump to Euler's integral: powers of 1-v, 2, 1-u, u.
DecidedStatement share() {
  struct Variant {
    int jump = 1;  // sign of the power at c
    bool edges = true;
    ex density = -1;  // power of 1 - v
  };
  const auto decided = [](const std::string& words, const Variant& variant) {
    const symbol u("u"), v("v"), al("alpha_l"), ar("alpha_r");
    const PhaseField field;
    const ex half = one_half();
    const ex c = 2 * u - 1;
    const ex above = c - v;  // x = above/below
    const ex below = 1 - v;
    const ex rear = -half - (variant.edges ? ex(al) : ex(ar));
    const ex jump = variant.jump * (al - ar);
    const ex front = -half + ar;
    return Comparison(field)
        .equal("1 + x", below + above, 2 * (u - v))
        .equal("1 - x", below - above, 2 * (1 - u))
        .equal("c - x", c * below - above, 2 * v * (1 - u))
        .equal("dx/dv", above.diff(v) * below - above * below.diff(v), -2 * (1 - u))
        .equal("power of 1 - v", -rear - jump - front - 2, variant.density)
        .equal("power of 2", rear + jump + front + 1, 0)
        .equal("power of 1 - u", jump + front + 1, half + al)
        .equal("power of u", rear + jump + 1, half - ar)
        .equal("power of r", jump, (half - ar) + (half + al) - 1)
        .equal("power of 1 - r", rear, -(half + al))
        .as(words);
  };
  return {"rh-layout-share",
          decided("with v = (c-x)/(1-x) = u r the load on [-1, c] is that of (1-u)^b u^a r^(a+b-1) (1-r)^-b/(1-u r), "
                  "a = 1/2 - alpha_r, b = 1/2 + alpha_l",
                  {}),
          {decided("beta of the other sign", {.jump = -1}), decided("alpha_r at the rear edge", {.edges = false}),
           decided("without 1/(1-u r)", {.density = 0}), decided("1/(1-u r)^2", {.density = -2})}};
}

/// F = -(1/pi) (int t/z + int x t/z^2) = (P/pi) Y: int x t = P sigma_1, so that the centre is int x t/int t = -sigma_1.
DecidedStatement centre() {
  const auto decided = [](const std::string& words, int sign, int load, const ex& part) {
    const symbol p("P"), pi("pi");
    const std::vector<ex> sigma = symbols("sigma", 2, 1);
    const PhaseField field;
    const std::vector<ex> series = series_at_infinity(sigma, -1, 2);
    const ex moment = sign * part * p * sigma[0];
    return Comparison(field)
        .equal("coefficient of 1/z^2", p / pi * series[1], -moment / pi)
        .equal("int x t = x int t", moment, load * -sigma[0] * p)
        .as(words);
  };
  return {
      "rh-layout-centre",
      decided("where F = (P/pi) Y = -(1/pi) (int t/z + int x t/z^2 + ...) and Y = 1/z - sigma_1/z^2 + ..., int x t = "
              "-sigma_1 int t",
              1, -1, 1),
      {decided("int x t of the other sign", -1, -1, 1), decided("int t = P", 1, 1, 1),
       decided("half of it", 1, -1, one_half()), decided("twice", 1, -1, 2)}};
}

}  // namespace

void add_strips(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {surface_base, surface_step, logarithms, balance, direction, halves, share, centre}) {
    all.push_back(statement());
  }
}

}  // namespace steadyslide::symbolic
