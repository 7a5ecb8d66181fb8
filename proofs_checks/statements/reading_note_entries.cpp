#include "proofs_checks/statements/reading_note_entries.hpp"

#include <array>

namespace steadyslide::proofs_checks {
namespace {

constexpr std::string_view lost_superscript =
    "The text has lost other superscripts (`f` and `alpha` of (5) without their minus), so extraction may well have "
    "dropped `+alpha` here; the printed page was not seen.";
constexpr std::string_view words = "These are words, which extraction does not change: the print's.";

constexpr std::array entries{
    ReadingNoteEntry{"eq-04-exponent", "[Bal16, (4)]",
                     "`t_n = -(P cos(pi alpha)/pi) / ((1+x)^{1/2} (1-x)^{1/2-alpha})`",
                     "the exponent of `1+x` is `1/2+alpha`", "eq-04-flat-punch",
                     "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}", "", lost_superscript},
    ReadingNoteEntry{"fig-03-words-frictionless", "[Bal16], the texts before figures 3 and 5",
                     "the rear of the punch carries more and has the stronger singularity; the largest pressure under "
                     "the parabola lies always in the rear half of the contact",
                     "so it is for `gamma f > 0`; for `f = 0`, which `f >= 0` includes, everything is symmetric",
                     "fig-03-rear-loaded", "",
                     "With `alpha = 0` the share of the rear half is `1/2`, the two powers are equal, and `-4 alpha a "
                     "= 0` is the contact's centre.",
                     words},
    ReadingNoteEntry{"eq-05-exponent", "[Bal16], the formula above (5)",
                     "the denominator `(1+x)^{1/2} (1-x)^{1/2-alpha_+}`", "the exponent of `1+x` is `1/2+alpha_-`",
                     "eq-05-07-friction-jump", "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha_-}", "",
                     lost_superscript},
    ReadingNoteEntry{
        "thm-02-beta", "[Bal16, theorem 2], the power `beta`",
        "`beta` of (7), with the friction values `f_-` and `f_+` of a punch with its only jump at `0`",
        "`f(c-)` and `f(c+)` in their places: `beta = alpha(c-) - alpha(c+)`", "thm-02-local-forms", "",
        "The constant beside the power has `f(c+)` and `f(c-)`, and the theorem admits any number of jumps.",
        "The reference is plain text, which extraction does not change: the print's."},
    ReadingNoteEntry{
        "thm-03-angle-rear", "[Bal16, theorem 3], contact on the right of `c`",
        "the power `-(1/2+alpha)` with `alpha` of (5), the angle of the friction on the left of `c`",
        "the angle of the friction on the contact side, the right", "thm-03-contact-side",
        "the printed angle (5), of the friction behind c, for contact in front of c", "",
        "The reference to (5) is plain text, which extraction does not turn from (6); but a lost superscript makes "
        "this half doubtful. At the rear edge of a punch with two coatings, for which (5) was introduced, both "
        "readings coincide; at `c = -1`, which the theorem admits, there is no friction on the left of `c`. The factor "
        "`sqrt(1+gamma^2 f^2)` of the slope behind `c` is to be read in the same way."},
    ReadingNoteEntry{"thm-03-angle-front", "[Bal16, theorem 3], contact on the left of `c`",
                     "the power `-(1/2-alpha_+)` with `alpha_+` of (6), the angle of the friction on the right of `c`",
                     "the angle of the friction on the contact side, the left", "thm-03-contact-side",
                     "the printed angle (6), of the friction in front of c, for contact behind c", "",
                     "The plus signs have survived extraction, so that this reading is the print's. At the front edge "
                     "of a punch with two coatings, for which (6) was introduced, both readings coincide; at `c = 1`, "
                     "which the theorem admits, there is no friction on the right of `c`."},
    ReadingNoteEntry{"thm-03-front-limit", "[Bal16, theorem 3], the estimate of `u'` next to a front end of contact",
                     "as `x -> c-`", "as `x -> c+`: outside of the contact; inside of it `u'` is the indenter's slope",
                     "thm-03-outside-slope",
                     "the printed x -> c- at the front: the estimate read inside of the contact", "",
                     "A plus turned into a minus is not what extraction does elsewhere (it loses signs): more likely "
                     "the print's, copied from the rear end."},
    ReadingNoteEntry{"thm-03-words-infinity", "[Bal16], the words after theorem 3",
                     "at a step of the indenter the singularity of the traction goes to infinity",
                     "so it does where the amplitude of the power is not zero: `t_n -> -oo` as far as `theta(c) > 0`",
                     "thm-10-proof-exclusion", "",
                     "The amplitude at an end held in its place changes its sign with the rest of the contact (claim "
                     "thm-10-proof-exclusion finds both signs): between them is a contact that just reaches the step, "
                     "with the power of a free end there. Theorem 3 itself says `theta(c) > 0` where it needs it.",
                     words},
    ReadingNoteEntry{"rem-01-friction", "[Bal16, remark 1]",
                     "that front and rear have different singularities relies on `gamma != 0`",
                     "on `gamma f != 0`: the difference of the powers is `2 alpha`, and `f = 0` is admitted",
                     "rem-01-front-rear", "they differ without friction", "", words},
    ReadingNoteEntry{
        "rem-01-or", "[Bal16, remark 1]",
        "not valid in the case of a nonsmooth indenter of a nonconstant friction coefficient",
        "a nonsmooth indenter or a nonconstant friction coefficient: either changes the powers by itself",
        "rem-01-neglect", "the printed 'of': no other power unless the indenter is nonsmooth and friction not constant",
        "", "A letter for another one, f for r, is nothing that extraction does elsewhere in the text: the print's."},
    ReadingNoteEntry{"rem-01-compliance", "[Bal16, remark 1]",
                     "an elastic indenter is covered by replacing `gamma` by Dundurs' constant",
                     "and the compliance `2 (1-nu^2)/E` in `u_bar` and `psi_bar` by the sum of both bodies'; at the "
                     "elastic indenter's own edges and steps the half-plane does not hold",
                     "rem-01-elastic-indenter", "the compliance of the half-space alone", "", words},
    ReadingNoteEntry{"eq-08-exponent", "[Bal16, (8)]", "`t_0 = (cos(pi alpha)/pi) / ((1+x)^{1/2} (1-x)^{1/2-alpha})`",
                     "the exponent of `1+x` is `1/2+alpha`", "eq-08-unit-solution",
                     "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}", "", lost_superscript},
    ReadingNoteEntry{"eq-10-exponents", "[Bal16, (10)]",
                     "the kernel `(1+x')^{1/2} (1-x')^{1/2-alpha} / ((1+x)^{1/2} (1-x)^{1/2-alpha})`",
                     "the exponent of `1+x'` and of `1+x` is `1/2+alpha`", "eq-10-inverse",
                     "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}, in both places", "", lost_superscript},
    ReadingNoteEntry{"sec-32-class", "[Bal16, section 3.2], the order of a quotient space",
                     "`t >= 0` if there is a nonnegative element in the equivalence class of `v`",
                     "in the equivalence class of `t`: no `v` occurs", "", "",
                     "The formula that follows the words has `t + l >= 0` for some `l` of the subspace.",
                     "Letters survive extraction elsewhere: most likely the print's."},
    ReadingNoteEntry{"eq-13-second-line", "[Bal16, (13)], the second line",
                     "`phi(u_hat) = <<-P t_0, u_bar_n - psi_bar - sup(u_hat - psi_bar)>>`",
                     "`u_hat` in both places: `phi(u_hat) = <<-P t_0, u_hat - psi_bar - sup(u_hat - psi_bar)>>`",
                     "lemma-04-functional", "the printed u_bar_n instead of u_hat in the second line of (13)",
                     "The proof of lemma 4 uses the line with the argument of `phi` in both places.",
                     "Extraction moves hats and bars off their letters but turns no `u_hat` into `u_bar_n`, with its "
                     "index: more likely the print's."},
    ReadingNoteEntry{"prop-05-support", "[Bal16, proposition 5], proof, the set `S`",
                     "`S` is the support of the positive part of `u_bar_n - psi_bar + C`",
                     "`S` is the set where `u_bar_n - psi_bar + C` is positive", "", "",
                     "A support is closed, and a function of `H^{1/2}` need not be continuous: a negative constant "
                     "with small spikes at all rational places is positive on a dense set of small measure, and its "
                     "positive part has all of `[-1, 1]` for its support. Then the function that (15) is tried with is "
                     "`0` and contradicts nothing. With the set itself the proof is complete.",
                     "Words and abbreviations survive extraction: the print's."},
    ReadingNoteEntry{
        "prop-05-test-function", "[Bal16, proposition 5], proof, the function that (15) is tried with",
        "on `S` the positive value `(1/meas S) int P t_0` over the rest of `]-1, 1[`",
        "with a minus sign: only so has `t_hat` the integral `0`, and `t_hat - P t_0` the sign that contradicts (15)",
        "prop-05-equivalence", "the printed test function without the minus sign", "",
        "Extraction has lost minus signs elsewhere, and before a fraction more easily than in running text: it may "
        "have done so here."},
    ReadingNoteEntry{"eq-16-star", "[Bal16, (16)] and the two lines after it",
                     "`phi(-t_hat)` and `phi(-t_tilde_n)` for the functional of tractions, `phi` being the conjugate "
                     "of `phi` up to a constant",
                     "another functional, the conjugate `phi^*`: `phi^*(-t_hat) = -<<psi_bar, t_hat>>` on `K_0'`; no "
                     "constant is left over",
                     "eq-16-conjugate", "",
                     "`phi` is defined on displacements by (13), and at `-t_hat` by nothing; the supremum of "
                     "`<<-t_hat, u_hat>> - phi(u_hat)` over `u_hat` is what (16) has on its right-hand side.",
                     "Superscripts are what extraction loses most, and without the star the sentence says nothing: "
                     "extraction's, all but certainly."},
    ReadingNoteEntry{
        "prop-07-tilde", "[Bal16, proposition 7] and section 3.1, the lines with `L(u_bar_n)`", "`n = L(u_bar_n)`",
        "`t_tilde_n = L(u_bar_n)`: the traction of zero mean, not `t_n = L(u_bar_n) - P t_0`", "", "",
        "The next line of section 3.1 has `t_n = L(u_bar_n) - P t_0`, and `t_n = t_tilde_n - P t_0` by definition.",
        "A letter with a tilde at the beginning of a line is lost in other places too: extraction's."},
    ReadingNoteEntry{"thm-09-remark", "[Bal16], the remark after theorem 9",
                     "the nonpositive measure by which \"proposition 9\" entails",
                     "theorem 9: there is no proposition of this number, and the conclusion is drawn from its formula",
                     "thm-09-solved-wedge", "",
                     "With `psi_bar'(c+) < psi_bar'(c-)` the logarithm of theorem 9 would be a tension.",
                     "A word is not what extraction exchanges: the print's."},
    ReadingNoteEntry{"thm-10-proof-exponents", "[Bal16, theorem 10], proof, `L` of the linear function",
                     "the kernel with `(1+x')^{1/2}` over `(1+x)^{1/2}`, as in (10)",
                     "the exponent of `1+x'` and of `1+x` is `1/2+alpha`", "thm-10-proof-linear",
                     "the printed (1+x)^{1/2} in t_0", "", lost_superscript},
    ReadingNoteEntry{
        "thm-10-proof-derivative", "[Bal16, theorem 10], proof, the case `c > -1`",
        "`u_tilde_n(x) = (1/pi) int t_tilde_n(x')/(x'-x) dx'`, and `psi_bar - u_tilde_n` as the new profile",
        "`u_tilde_n'` on the left-hand side: the integral is a slope, and only its primitive can be subtracted from a "
        "profile",
        "thm-10-proof-reduction", "the printed u~ where its derivative must stand",
        "`t_tilde_n` is here the part of `t_n` left of `c`, not the traction of zero mean of section 3.1.",
        "The text has a 0 where a prime was printed; here there is nothing, neither prime nor 0: more likely the "
        "print's."},
};

}  // namespace

std::span<const ReadingNoteEntry> reading_note_entries() { return entries; }

}  // namespace steadyslide::proofs_checks
