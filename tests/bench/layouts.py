"""The layouts of the tables in tests/bench/README.md.

A layout names a benchmark program and its arguments. It turns the measurements into one or two tables of Markdown; the second one
is for the marker `NAME 2`. A measurement is the CPU time in nanoseconds, and its counters. `Times` returns it by the name of the
benchmark.
"""

import json
import subprocess


class Times:
    def __init__(self, program, arguments):
        out = subprocess.run([program, "--benchmark_format=json", *arguments], check=True, capture_output=True, text=True)
        unit = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
        self.of, self.counters = {}, {}
        for run in json.loads(out.stdout)["benchmarks"]:
            if run.get("aggregate_name", "median") != "median" or "error_occurred" in run or "cpu_time" not in run:
                continue
            name = run.get("run_name", run["name"])
            measured = "real_time" if name.endswith("/real_time") else "cpu_time"
            self.of[name] = run[measured] * unit[run["time_unit"]]
            self.counters[name] = run

    def time(self, name, unit):
        return short(self.of[name] / unit) if name in self.of else ""

    def ratio(self, above, below, digits=2):
        return f"**{short(self.of[above] / self.of[below], digits)}**" if above in self.of and below in self.of else ""

    def counter(self, name, counter):
        return power_of_ten(self.counters[name][counter]) if name in self.counters else ""


def short(number, digits=2):
    """Returns the number with two or three digits."""
    if number == 0:
        return "0"
    text = f"{number:.{digits}g}"
    return f"{float(text):.0f}" if abs(number) >= 10**digits else text


def power_of_ten(number):
    return "0" if number == 0 else f"{number:.0e}".replace("e-0", "e-")


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows]


NS, US, MS = 1, 1e3, 1e6


def traction(t):
    floor = "double/floor"
    names = (("floor, five `pow` of glibc", floor), ("one by one, at points of panels", "double/one_by_one"),
             ("at given x, with shear (`tractions()`)", "double/at_places"),
             ("at points of panels", "double/on_panels"), ("kernel, AVX-512", "double/kernel/avx512"),
             ("kernel, AVX2 and FMA", "double/kernel/avx2"), ("kernel, SSE2", "double/kernel/baseline"),
             ("libmvec, AVX-512", "double/libmvec/avx512"), ("libmvec, AVX2", "double/libmvec/avx2"),
             ("libmvec, SSE2", "double/libmvec/baseline"))
    points = 1e6
    rows = [[text, short(t.of[name] / points, 3) + " ns", t.ratio(floor, name)] for text, name in names if name in t.of]
    points = 1e5
    digits = [[f"{d} digits"] + [short(t.of[f"{d} digits/{name}"] / points / 1000, 3) + " us" for name in ("arb", "on_panels")] +
              [t.ratio(f"{d} digits/on_panels", f"{d} digits/arb", 3)] for d in (50, 100) if f"{d} digits/arb" in t.of]
    return (table(["a point", "time", "floor / time"], rows),
            table(["a point", "Arb's logarithms and exponential", "tractions", "ratio"], digits))


def precision(t):
    functions = table(["function", "50 digits", "MPFR", "", "100 digits", "MPFR", ""],
                  [[f] + [cell for d in (50, 100) for cell in
                          (t.time(f"{f}, {d} digits", US), t.time(f"{f} by MPFR, {d} digits", US),
                           t.ratio(f"{f} by MPFR, {d} digits", f"{f}, {d} digits"))] for f in ("log", "exp", "pow")])
    rules = ("Gauss-Jacobi, rule known", "double-exponential grid", "Boost's tanh-sinh", "PARI's intnum",
             "acb_calc_integrate")
    names = [(rule, f"panel, {rule}, 50 digits", f"panel, {rule}, 100 digits") for rule in rules]
    return functions, table(["panel by", "50 digits", "error", "100 digits", "error"],
                                [[rule] + [cell for name in (a, b) for cell in
                                           (t.time(name, MS), t.counter(name, "error") if "acb" not in rule else "")]
                                 for rule, a, b in names])


def answers(t):
    rows = []
    for problem in ("punch", "parabola", "wedge, all in contact", "wedge, partly", "two zones"):
        for how, name in ((", by formula", " by formula"), (", Riemann–Hilbert", "")):
            cells = []
            for digits in (50, 100):
                bare, answer = (f"{problem}, {digits} digits, {x}" for x in ("bare", "answer" + name))
                cells += [t.time(bare, MS), t.time(answer, MS), t.ratio(answer, bare)]
            if cells[1]:
                rows.append([problem + how] + cells)
    return (table(["problem", "50 digits: bare", "answer", "ratio", "100 digits: bare", "answer", "ratio"], rows),)


def derivations(t):
    jumps = (0, 1, 2, 3, 4, 8)
    names = ("problem_closed_form", "problem_local_forms")
    texts = ("a punch with numbers, closed form", "a punch with numbers, all local forms")
    return (table(["derivation"] + [str(n) for n in jumps],
                 [[text] + [t.time(f"{name}/{n}", MS) for n in jumps] for text, name in zip(texts, names)]),)


def riemann_hilbert(t):
    both = ("quartic", "wedge")
    names = (("coarse solution, about 1,024 cells", "coarse_1024", "ends"), ("solve, from nothing", "solve_cold", "ends"),
             ("solve, with the best start", "solve_warm", ""),
             ("50 digits, from nothing", "solve_50_digits", ""), ("100 digits, from nothing", "solve_100_digits", ""),
             ("one traction value", "traction", "traction"), ("one traction value by GSL", "traction_by_gsl", "traction"))
    rows = [[text] + [cell for p in both for cell in
                      (t.time(f"{name}/{p}", US) + " us", t.counter(f"{name}/{p}", error) if error else "")]
            for text, name, error in names]
    lines = table(["", "quartic", "error", "wedge", "error"], rows)
    jumps = (4, 16, 64, 256, 1024)
    kinds = [(f"{text}, {p}", f"{name}/{p}") for text, name in (("solve, with the best start", "solve_by_jumps"),
                                                              ("traction", "traction_by_jumps")) for p in both]
    return lines, table(["us, by jumps"] + [str(n) for n in jumps],
                                [[text] + [t.time(f"{name}/{n}", US) for n in jumps] for text, name in kinds])


def variational(t):
    rows = []
    for octave in range(12, 21, 2):
        name = {kind: f"{kind}/{2**octave}/real_time" for kind in
                ("solve/parabola", "solve/asperities", "product", "two_transforms")}
        cells = [f"2^{octave}"]
        for kind in ("solve/parabola", "solve/asperities"):
            products = t.counters.get(name[kind], {}).get("products")
            cells += [t.time(name[kind], MS), "" if products is None else f"{products:.0f}"]
        rows.append(cells + [t.time(name["product"], MS), t.time(name["two_transforms"], MS),
                             t.ratio(name["product"], name["two_transforms"], 3)])
    head = ["cells", "parabola, ms", "products", "asperities, ms", "products", "one product, ms", "two transforms, ms", "ratio"]
    return (table(head, [row for row in rows if any(row[1:])]),)


# For each name: the layout, the arguments of bench_NAME, and the arguments of a quick run.
LAYOUTS = {
    "traction": (traction, ["--benchmark_repetitions=3", "--benchmark_report_aggregates_only=true"], []),
    "precision": (precision, ["--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"],
                  ["--benchmark_min_time=0.02"]),
    "answers": (answers, ["--benchmark_min_time=0.05", "--benchmark_repetitions=9",
                          "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"],
                ["--benchmark_min_time=0.01"]),
    "derivations": (derivations, ["--benchmark_min_time=0.05"], ["--benchmark_min_time=0.01"]),
    "riemann_hilbert": (riemann_hilbert, [], ["--benchmark_min_time=0.01"]),
    "variational": (variational, ["--benchmark_min_time=0.2"], ["--benchmark_filter=/(4096|16384)/",
                                                               "--benchmark_min_time=0.01"]),
}
