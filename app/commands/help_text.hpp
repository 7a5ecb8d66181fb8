#pragma once
// What --help says beyond the options themselves.

namespace steadyslide::app::help {

inline constexpr const char* program =
    R"(Steady sliding contact of an indenter on an elastic half-plane, with a friction
coefficient that is a step function under the indenter: exponents of the stress
singularities, contact pressure, and a check of the theory's claims.)";

inline constexpr const char* program_footer =
    R"(Units      Yours, everywhere: Young's modulus, lengths and loads (force per unit
           thickness) in any consistent set.
Signs      x runs left to right in all data and results. The profile psi points away
           from the body; traction t <= 0 is compression; shear is the tangential
           traction's component along +x.
Numbers    Decimal strings, rounded to nearest. A text shows the digits that the estimated error
           supports; CSV and JSON have all digits asked for, and the error beside each number:
           columns and keys that end in _error.
Errors     One line on stderr: FILE:LINE: what is wrong; the rule; the value. Warnings likewise,
           FILE: warning: what; the rule; the value.
Exit code  0 done; 1 the mathematics said no: a claim refuted, or undecided where calculation
           could decide it, or a solve that did not converge; 2 bad input, or a method that does
           not apply; 3 a file cannot be read or written; 130 interrupted.)";

inline constexpr const char* problem = R"(PROBLEM is a TOML file, or - for the standard input:

  load = "1"                     # P > 0, force per unit thickness
  load_at = "0.1"                # optional: the indenter may tilt, the load acts at this x
  sliding = "+x"                 # or "-x": the way the indenter moves
  [half_space]
  poisson = "0.3"                # in ]-1, 1/2[
  young = "1"                    # default 1: stresses in units of E
  plane = "strain"               # or "stress"
  # gamma = "2/7"                # instead of the three above: the coupling constant itself, in
                                 # ]-1, 1[; psi and u are then reduced, u / c with c = 2(1-nu^2)/E
  [friction]                     # travels with the indenter
  values = ["0.2", "0.6"]        # left to right, >= 0, at most 10000
  jumps = ["0"]                  # increasing, inside the support, one fewer than values
  [indenter]
  support = ["-1", "1"]          # default
  profile = "x^2/2"              # psi(x), away from the body; degree at most 64
  # pieces = [ {to = "0", profile = "-x/2"}, {to = "1", profile = "x^2"} ]
  # samples = "trace.csv"        # measured: points x,psi, one a line, x increasing, beside PROBLEM;
                                 # straight lines join them, the support is their range by default
  # elastic = { poisson = "0.3", young = "2" }     an elastic indenter, smooth profiles only

A number is a string or an integer: "1/3", "0.1" and "1e-3" are exact.)";

inline constexpr const char* exponents =
    R"(Lists every place where the contact pressure can be singular for these data, whatever the
contact zone turns out to be, with the power of the distance.)";

inline constexpr const char* exponents_footer =
    R"(One row for each: support ends (edge: pressure may blow up; free: contact ends there
smoothly), friction jumps, wedges, steps, and the free ends that can lie anywhere under a
friction value.
  x         the place, in your units of length, or anywhere
  kind      edge, free, step, friction_jump, wedge or wedge_and_jump
  side      the side of x on which there is contact: left, right or both
  friction  f on the contact side, or left and right of x
  exponent  the power of the distance in the normal traction; log: a logarithm
  symbolic  the same, exact
  latex     the same, for math mode)";

inline constexpr const char* table =
    R"(The exponents of a rigid indenter in plane strain sliding towards +x (rear = left, front =
right), with one friction jump: one row per combination, poisson slowest, front fastest.)";

inline constexpr const char* table_footer =
    R"(LIST is 0.1,0.2 or 0:0.4:0.1 (first, last, step; inclusive). Write a list that starts with a
minus sign as --poisson=-0.5:0.4:0.1.
Columns, all without unit:
  nu, f_rear, f_front      Poisson's ratio in ]-1, 1/2[, friction coefficients >= 0
  gamma                    (1 - 2 nu) / (2 (1 - nu))
  alpha_rear, alpha_front  arctan(gamma f) / pi
  beta                     alpha_rear - alpha_front, the power at the jump: negative blows up
  edge_rear, edge_front    powers at the support's ends: -1/2 - alpha_rear, -1/2 + alpha_front
  free_rear, free_front    powers at free ends of contact: 1/2 - alpha_rear, 1/2 + alpha_front)";

inline constexpr const char* solve = R"(Finds the contact zone, the contact pressure and the resultants.)";

inline constexpr const char* solve_footer = R"(Results, in your units:
  traction   normal traction t <= 0, force per area; "-inf" where it blows up
  shear      tangential traction along +x, force per area
  gap        psi - u - C >= 0, a length; none outside the support
  slope      u', the slope of the surface
  intensity  theta in t = -theta d^exponent at the ends of contact, in
             t = constant - theta cos(pi alpha) |x-c|^exponent at friction jumps;
             at a wedge without jump the coefficient of log|x-c|/pi
  tilt       the slope added to psi, where load_at lets the indenter tilt
Where the two limits at a place differ, JSON says {"left", "right"} and CSV has two rows.
CSV: x, traction, shear, gap, slope, then traction_error to slope_error; absolute errors, estimated.
--at takes a list, -0.5,0,0.5 or -0.5:0.5:0.1 (first, last, step). CSV is the samples and nothing
else: those of --at and --samples, 101 in each component and gap if neither is given. Text and
JSON have samples only where they are asked for.
Methods:
  closed-form      a formula, for flat punches and parabolas that do not tilt
  riemann-hilbert  any profile: the contact's ends by Newton's method, the pressure in the
                   space of its own singular functions
  variational      any profile, measured ones above all: pressures on N equal cells, in double;
                   ends of contact to one cell, 16 digits at most
  auto             the first of the three that applies
16 digits are found in double, and with 50 digits where double is not enough.
--cells and --iterations go with --method variational, with auto where that takes it (a
profile with more than 200 breaks, more than 1000 values of friction), and with --search-solutions.
What cells cannot show, the intensity at an end of a short zone say, has no number: - in the
text, empty in CSV, null in JSON.
--load-steps LIST takes the loads 0.1,0.2 or 0.1:1:0.1 (first, last, step; each positive, at
most 10000) instead of the file's, each solve starting from the one before. One row for each
load and contact component, in every format:
  load, component                     components are counted from 1, left to right
  left, left_kind, left_intensity     its left end: edge, free or step
  right, right_kind, right_intensity  its right end
  effective_friction, centre_of_pressure, load_share, tilt
                                      of the whole contact; shares left to right
  shortcoming                         empty where the load is solved
  left_error, ..., tilt_error         in CSV and JSON; JSON has warnings, too, a list
--search-solutions N starts from N contact sets: the whole support, then random ones. Shown
are the different solutions, how often each was met, their residuals, and whether the
Riemann-Hilbert method finds a solution there too. CSV: one row for each solution and
component; exit code 1 if no start leads to a solution.
A solve that does not converge is printed all the same, and the exit code is 1. So it is where an
estimated error is above 50 %; from 10 % on there is a warning, and where a measured profile is in
contact at its cut end, or within the last 1 % of the support alone: is its unit or sign wrong?)";

inline constexpr const char* verify =
    R"(Checks the claims of the theory by unrelated routes and prints a verdict for each.)";

inline constexpr const char* verify_footer =
    R"(Verdicts: proved (an exact identity), supported (unrelated routes agree), undecided,
refuted. Every claim is also checked with deliberately wrong variants, its controls, each of
which must be refuted. Exit code 1 if a claim is refuted or undecided, unless no calculation
can decide it.)";

inline constexpr const char* figures =
    R"(Draws the figures of the theory as SVG, from data computed on the spot; gnuplot draws.)";

inline constexpr const char* figures_footer = R"(One file for each figure, NAME.svg, whole or not at all.)";

inline constexpr const char* report =
    R"(Runs the whole ledger and writes the verification report: one HTML page that needs no
network, DIR/report.html.)";

inline constexpr const char* report_footer =
    R"(The page holds every statement with its evidence, controls and verdict, the places where
the paper's text needs care, figures and tables. Exit code 1 if a claim is refuted or
undecided, unless no calculation can decide it; the page is written all the same.)";

}  // namespace steadyslide::app::help
