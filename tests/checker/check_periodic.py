#!/usr/bin/env python3
"""check_periodic.py CHECKER STEADYSLIDE: steadyslide-check proves certificates of 50 random periodic problems, and refuses changed
ones, also those that solve the equations of another model or of a contact with tension or penetration."""

import cmath
import copy
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

CHECKER, STEADYSLIDE = sys.argv[1:3]
HELD = tempfile.TemporaryDirectory()
FOLDER = pathlib.Path(HELD.name)
PROBLEM, CERTIFICATE = FOLDER / "problem.toml", FOLDER / "certificate.json"
failures = []


def run(*command):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=300, check=False)
    return done.returncode, done.stdout + done.stderr


def expect(what, code, said, codes, words=""):
    if code not in codes or words not in said:
        failures.append(f"{what}: exit code {code}: {said.strip()[-200:]}")


def random_problem(seed):
    """Even seeds: flat punches with 1 to 4 jumps, some without a gap. Odd seeds: up to 3 harmonics, 0 to 4 jumps."""
    r = random.Random(seed)
    length, flat = r.choice([1.0, 2.0, 0.5, 3.0]), seed % 2 == 0
    whole = r.random() < (0.15 if flat else 0.7)
    half = length / 2 if whole else round(length * r.uniform(0.1, 0.48), 4)
    jumps = sorted({round(r.uniform(-0.95, 0.95) * half, 4) for _ in range(r.randint(1 if flat else 0, 4))})
    friction = [round(r.uniform(0, 1.2), 3) for _ in range(len(jumps) + 1)]
    height = 0.01 * length
    waves = ", ".join(f'{{n = {n}, cos = "{-height / n**3 * r.uniform(0.5 if n == 1 else -0.3, 1):.6f}", '
                      f'sin = "{height / n**3 * r.uniform(-0.3, 0.3):.6f}"}}' for n in range(1, r.randint(1, 3) + 1))
    load = round(2 * math.pi * height * r.choice([0.1, 0.4, 0.8, 1.7]), 6)
    return (f'load = "{load}"\nsliding = "{r.choice(["+x", "-x"])}"\n[half_space]\ngamma = "0.7"\nperiod = "{length}"\n'
            f"[friction]\nvalues = {[str(f) for f in friction]}\njumps = {[str(c) for c in jumps]}\n"
            f"[indenter]\nsupport = {[str(-half), str(half)]}\n" + ('profile = "0"\n' if flat else f"harmonics = [{waves}]\n"))


def certificate_of(what, problem, *options):
    PROBLEM.write_text(problem)
    CERTIFICATE.unlink(missing_ok=True)
    code, said = run(STEADYSLIDE, "solve", PROBLEM, "--certificate", CERTIFICATE, *options)
    expect(what, code, said, {0}, ": proved: the box contains a solution")
    code, said = run(CHECKER, "--problem", PROBLEM, CERTIFICATE)
    expect(what, code, said, {0}, "the problem is that of")
    return json.loads(CERTIFICATE.read_text())


def refuse(what, certificate, change, words=""):
    changed = copy.deepcopy(certificate)
    change(changed)
    CERTIFICATE.write_text(json.dumps(changed))
    expect(what, *run(CHECKER, CERTIFICATE), {1, 2}, words)


def places(value, path=()):
    if isinstance(value, (dict, list)):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value):
            yield path + (key,)
            yield from places(item, path + (key,))


def changed_at(path, value):
    def apply(c):
        for key in path[:-1]:
            c = c[key]
        if value is None:
            del c[path[-1]]
        else:
            c[path[-1]] = value(c[path[-1]]) if callable(value) else value

    return apply


def without_effect(c, path):
    """True if the claim stays true when this number changes: it belongs to places outside the contact, or drops out."""
    jumps, (left, right) = [float(x) for x in c["problem"]["friction"]["jumps"]], map(float, c["ends"])
    pieces = [-math.inf, *jumps, math.inf]
    key, k = path[-2:] if isinstance(path[-1], int) else (path[-1], None)
    if len(c["traction"]) == 1 and key in ("period", "origin", "left", "to", "ends"):
        return True  # a flat surface without a gap
    return (key == "compliance" and not c["problem"]["harmonics"] or key == "left" and c["free"][0] or key == "to" and c["free"][1]
            or key == "jumps" and not left < jumps[k] < right
            or key == "values" and not (pieces[k] < right and pieces[k + 1] > left))


def both_moved(interval):
    return [f"{float(x) + 1e-9:.17g}" for x in interval]


def wrong_values(name, c):
    """Changes each value of a certificate: every number by 1e-9, every key away, every value to another type."""
    for path in places(c):
        if isinstance(path[-1], str) and path[-1] not in ("cos", "sin"):
            refuse(f"{name}: {path} left out", c, changed_at(path, None))
        refuse(f"{name}: {path} of another type", c, changed_at(path, 7.5))
        value = c
        for key in path:
            value = value[key]
        if not isinstance(value, str) or path[0] in ("kind", "generator", "radius") or path[-1] in ("sliding", "n"):
            continue
        if value != "0" and not without_effect(c, path):
            by = -1e-9 if path[0] == "claims" and path[-1] == 1 else 1e-9  # an interval must not become wider
            refuse(f"{name}: {path}", c, changed_at(path, lambda v: f"{float(v) + by:.17g}" if "/" not in v else "0.3"))
    for what, path, value in [("sliding", ("problem", "sliding"), "-x" if c["problem"]["sliding"] == "+x" else "+x"),
                              ("a radius of 1e-5", ("radius",), "1e-5"), ("no radius", ("radius",), "0"),
                              ("another kind", ("kind",), "solution"), ("nothing claimed", ("claims", "exists"), False),
                              ("a free end", ("free", 0), not c["free"][0]), ("a free end", ("free", 1), not c["free"][1]),
                              ("a coefficient more", ("traction",), c["traction"] + ["0"]),
                              ("another friction", ("claims", "effective_friction"), both_moved),
                              ("another centre", ("claims", "centre_of_pressure"), both_moved),
                              ("a line of action", ("problem", "load_at"), "0.01")]:
        refuse(f"{name}: {what}", c, changed_at(path, value))


def wrong_models(flat, closed):
    """`flat`: a punch with one friction value. Its traction solves C tau = S - i P/L; without S it is that of another model."""
    p = flat["problem"]
    s = float(p["gamma"]) * float(p["friction"]["values"][0]) * (1 if p["sliding"] == "+x" else -1)
    mean = float(p["load"]) / float(p["period"])
    alpha = math.atan(s) / math.pi
    left, right = (math.pi * (float(x) - float(flat["origin"])) / float(p["period"]) for x in flat["ends"])
    factor = 2 * cmath.exp(1j * ((-0.5 - alpha) * left + (alpha - 0.5) * right)) / 1j  # of Y at +i oo, m = -1
    for what, constant in (("the same model", (s - 1j) * mean), ("without the mean of s", -1j * mean)):
        tau = constant / factor
        if what == "the same model":
            far = max(abs(float(a) - b) for a, b in zip(flat["traction"], (tau.real, tau.imag)))
            expect(f"{what}: {far}", 0 if far < 1e-13 else 1, "", {0})
        else:
            refuse(what, flat, lambda c: c.update(traction=[repr(tau.real), repr(tau.imag)], radius="1e-12"), "Krawczyk")
    # Without a gap and with one friction, T = wave + load/(L cos(pi alpha)): a small load pulls at the valleys.
    p = closed["problem"]
    s = float(p["gamma"]) * float(p["friction"]["values"][0])
    lower = (float(p["load"]) - 0.01) / float(p["period"]) * math.sqrt(1 + s * s)
    refuse("tension", closed, lambda c: (c["problem"].update(load="0.01"), c["claims"].update(
        effective_friction=["0", "2"], centre_of_pressure=["-9", "9"]), c.update(
        traction=[repr(float(c["traction"][0]) - lower), *c["traction"][1:]], radius="1e-12")), "the pressure is not positive")


def wave_claim(a, amplitudes):
    """The certificate for no friction, L = 1 and [-a, a] under sum c_n cos(2 pi n x), whatever happens elsewhere: power series by
    hand, independent of the program."""
    N = len(amplitudes)
    sums = [math.cos(2 * math.pi * k * a) for k in range(N + 1)]
    series = [1.0]
    for n in range(1, N + 1):
        series.append(-sum(sums[k] * series[n - k] for k in range(1, n + 1)) / n)
    tau = [0.0] * N  # of k = 1, 3, ..., 2N - 1
    for n in range(N, 0, -1):
        tau[n - 1] = -2 * math.pi * n * amplitudes[n - 1] - sum(tau[i] * series[i + 1 - n] for i in range(n, N))
    load = (sum(tau[i] * series[i + 1] for i in range(N)) + tau[0]) / 2
    problem = {"load": repr(load), "load_at": None, "sliding": "+x", "gamma": "0.5", "compliance": "1", "period": "1",
               "friction": {"values": ["0"], "jumps": []},
               "indenter": {"left": "-0.5", "pieces": [{"to": "0.5", "profile": []}]},
               "harmonics": [{"n": str(n + 1), "cos": repr(c)} for n, c in enumerate(amplitudes)]}
    return {"certificate": 1, "kind": "periodic", "generator": "by-hand 1.0.0", "problem": problem, "origin": "0",
            "ends": [repr(-a), repr(a)], "free": [True, True], "radius": "1e-10",
            "traction": [text for t in tau for text in (repr(t), "0")],
            "claims": {"exists": True, "effective_friction": ["-1e-6", "1e-6"], "centre_of_pressure": ["-1e-6", "1e-6"]}}


def main():
    bases = {}
    for seed in range(50):
        certificate = certificate_of(f"problem {seed}", random_problem(seed), *(("--digits", "50") if seed > 46 else ()))
        bases.setdefault((seed % 2, *certificate["free"], len(certificate["traction"]) % 2), (seed, certificate))
    expect(f"shapes {sorted(bases)}", len(bases), "", {6})
    for seed, certificate in bases.values():
        wrong_values(f"problem {seed}", certificate)

    punch = ('load = "1"\n[half_space]\ngamma = "0.7"\nperiod = "1"\n[friction]\nvalues = ["1"]\n[indenter]\n'
             'support = ["-0.3", "0.3"]\nprofile = "0"\n')
    flat = certificate_of("flat punch", punch)
    for what, old, new, words in (("another period", 'period = "1"', 'period = "1.1"', "half_space.period"),
                                  ("no period", 'period = "1"', "", "half_space.period"),
                                  ("harmonics", 'profile = "0"', 'harmonics = [{n = 1, cos = "1"}]', "indenter.harmonics")):
        PROBLEM.write_text(punch.replace(old, new))
        expect(what, *run(CHECKER, "--problem", PROBLEM, CERTIFICATE), {1}, f"it differs in {words}")
    wave = punch.replace('support = ["-0.3", "0.3"]\nprofile = "0"', 'support = ["-0.5", "0.5"]\n'
                         'harmonics = [{n = 1, cos = "-0.1"}]')
    wrong_models(flat, certificate_of("wave without a gap", wave))

    # Crests at 0 and 1/2, or at 0 and +-1/3. Contact at 0 alone is a solution if this crest reaches further, under a small load.
    for a, amplitudes, is_solution in ((0.05, [-0.01, -0.01], True), (0.03, [-0.01, 0.0, -0.01], True), (0.1, [0.01, -0.01], False),
                                       (0.1, [-0.0005, -0.01], False), (0.07, [-0.0005, 0.0, -0.01], False)):
        CERTIFICATE.write_text(json.dumps(wave_claim(a, amplitudes)))
        words = "proved: the box contains a solution" if is_solution else "the gap is not positive"
        expect(f"one of several crests, {amplitudes}", *run(CHECKER, CERTIFICATE), {0 if is_solution else 1}, words)

    for what, new in (("a parabola", 'profile = "x^2"'), ("two crests", 'harmonics = [{n = 2, cos = "-0.1"}]')):
        PROBLEM.write_text(punch.replace('profile = "0"', new).replace('"1"', '"0.1"', 1).replace("0.3", "0.5"))
        expect(what, *run(STEADYSLIDE, "solve", PROBLEM, "--certify"), {2},
               "there are certificates for flat punches that do not tilt and for harmonics with one zone of contact")
    print("\n".join(failures))
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
