#!/usr/bin/env python3
"""Tests that the checker proves each certificate of random problems in a few seconds.

Makes random problems from the seed `first` on, until `count` of them have a certificate: notches, steps, wedges on jumps, tilting
indenters, and mixtures of them. In some of them friction almost does not jump. Solves each with --certify --certificate, and
gives the certificate to steadyslide-check --problem. An answer may take at most `seconds` of processor time. `folder` receives
the problem files of the failures. With --falling, s = gamma f falls towards +x at every jump, from at most 5; --family selects
one kind of problem.

The test misses an error in the model that both programs share; both read problem files. With 16 digits it misses errors that
occur only if the bounds need more bits.
"""

import argparse
import collections
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
from fractions import Fraction

NOT_PROVED = 0.2  # largest fraction of problems without a proof


class Draw:
    """Random numbers with few digits, the same on every platform."""

    def __init__(self, seed):
        self.random = random.Random(seed).random

    def whole(self, first, last):
        return first + int(self.random() * (last + 1 - first))

    def among(self, *choices):
        return choices[self.whole(0, len(choices) - 1)]

    def between(self, low, high, steps=1000):
        return low + (high - low) * self.whole(0, steps) / steps

    def size(self, low, high):
        return low * (high / low) ** self.random()


def text(number):
    return f"{number:.6g}"


def pieces_of(places, slopes, heights=None, rounded=False):
    """Returns the indenter of straight pieces from -1 to the last place, with these slopes.

    The pieces join exactly. With rounded=True there are steps of about 1e-9 between them. With heights, each piece has its own
    constant.
    """
    height, last, lines = Fraction(0), Fraction(-1), []
    for k, to in enumerate(Fraction(f"{place:.9g}") for place in places):
        slope = Fraction(f"{slopes[k]:.6g}")
        constant = height - slope * last if heights is None else Fraction(f"{heights[k]:.6g}")
        if rounded:
            constant = round(constant, 9)
        height += slope * (to - last)
        lines.append(f'  {{ to = "{to}", profile = "({slope})*x + ({constant})" }}')
        last = to
    return "support = [-1, 1]\npieces = [\n" + ",\n".join(lines) + "\n]\n"


FAMILIES = ("notch", "steps", "wedge on a jump", "tilt", "mixture")


def problem(seed, family=None, falling=False):
    draw = Draw(seed)
    family = family or FAMILIES[seed % 5]
    corner = draw.among(0.0, round(draw.between(-0.7, 0.7), 2))
    breaks = [corner]
    if family == "notch":
        indenter = pieces_of([corner, 1.0], [draw.size(0.02, 0.6), -draw.size(0.02, 0.6)])
    elif family == "wedge on a jump":
        indenter = pieces_of([corner, 1.0], [-draw.size(0.05, 1), draw.size(0.05, 1)])
    elif family == "steps":
        breaks = sorted({round(draw.between(-0.8, 0.8), 2) for _ in range(draw.whole(1, 3))})
        heights = [draw.among(0.0, draw.size(0.02, 0.5)) for _ in range(len(breaks) + 1)]
        slope = draw.among(0.0, 0.0, round(draw.between(-0.1, 0.1), 3))
        indenter = pieces_of([*breaks, 1.0], [slope] * len(heights), [round(height, 4) for height in heights])
    elif family == "tilt":
        indenter = draw.among("support = [-1, 1]\nprofile = 0\n", f'profile = "{text(draw.size(0.2, 3))}*x^2"\n',
                              f'support = [-1, 1]\nprofile = "{text(draw.size(0.05, 0.5))}*x^4"\n',
                              pieces_of([corner, 1.0], [-draw.size(0.02, 0.3), draw.size(0.02, 0.3)]))
    else:
        breaks = sorted({round(draw.between(-0.8, 0.8), 2) for _ in range(draw.whole(2, 3))})
        indenter = pieces_of([*breaks, 1.0], [draw.among(-1, 1) * draw.size(0.03, 0.6) for _ in range(len(breaks) + 1)],
                             rounded=draw.random() < 0.2)
    jumps = {one for one in breaks if family == "wedge on a jump" or draw.random() < 0.5}
    jumps |= {round(draw.between(-0.9, 0.9), 2) for _ in range(draw.whole(0, 3))}
    values = [round(draw.size(0.02, draw.among(0.5, 1, 5)), 3) for _ in range(len(jumps) + 1)]
    if jumps and draw.random() < 0.15:  # almost no jump
        values[1] = values[0] + draw.among(1, -1) * draw.size(1e-14, 1e-3)
    load = draw.size(0.02, 5)
    at = f'load_at = "{draw.between(-0.3, 0.3, 60):.9g}"\n' if family == "tilt" else ""
    sliding = draw.among("+x", "-x")
    poisson, plane = f"{draw.between(-0.5, 0.49):.3g}", draw.among("strain", "stress")
    if falling:
        nu = float(poisson)
        gamma = (1 - 2 * nu) / (2 - 2 * nu) if plane == "strain" else (1 - nu) / 2
        jumps = jumps or {round(draw.between(-0.5, 0.5), 2)}
        values = sorted((round(draw.size(0.02, 5) / gamma, 3) for _ in range(len(jumps) + 1)), reverse=sliding == "+x")
    quoted = lambda numbers: ", ".join(f'"{number!r}"' for number in numbers)
    return family, (f'# seed {seed}, {family}\nload = "{text(load)}"\n{at}sliding = "{sliding}"\n'
                    f'[half_space]\npoisson = "{poisson}"\nplane = "{plane}"\n'
                    f'[friction]\nvalues = [{quoted(values)}]\njumps = [{quoted(sorted(jumps))}]\n[indenter]\n{indenter}')


def answered(command, folder, most):
    """Returns the exit code, the last line printed, and the seconds of processor time. The code is None if time ran out.

    Other processes do not add to the processor time.
    """
    start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60 * most, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1)))
    except subprocess.TimeoutExpired:
        return None, "no answer", 60.0 * most
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None, f"no answer in {most} s", seconds
    said = (done.stderr.strip() or done.stdout.strip()).splitlines()
    return done.returncode, said[-1] if said else "", seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("steadyslide", type=os.path.abspath)
    parser.add_argument("checker", type=os.path.abspath)
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("folder", type=pathlib.Path, nargs="?")
    parser.add_argument("--family", choices=FAMILIES)
    parser.add_argument("--falling", action="store_true")
    parser.add_argument("--digits", default="16")
    parser.add_argument("--seconds", type=int, default=10)
    arguments = parser.parse_args()
    seed, kept = arguments.first, arguments.folder
    certify = [arguments.steadyslide, "solve", "p.toml", "--certify", "--certificate", "c.json", "--digits", arguments.digits]
    counts, failures, slowest = collections.Counter(), [], {"certifier": (0.0, 0), "checker": (0.0, 0)}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        while counts["certificates"] < arguments.count:
            family, problem_file = problem(seed, arguments.family, arguments.falling)
            (folder / "p.toml").write_text(problem_file)
            (folder / "c.json").unlink(missing_ok=True)

            def failed(who, said):
                failures.append(f"seed {seed}, {family}: {who}: {said}")
                print(failures[-1], flush=True)
                if kept:
                    (kept / f"{seed}.toml").write_text(f"# {who}: {said}\n{problem_file}")

            code, said, seconds = answered(certify, folder, arguments.seconds)
            slowest["certifier"] = max(slowest["certifier"], (seconds, seed))
            counts["problems"] += 1
            if code is None:
                failed("certifier", said)
            elif (folder / "c.json").exists():
                counts["certificates"] += 1
                counts[family] += 1
                code, said, seconds = answered([arguments.checker, "--problem", "p.toml", "c.json"], folder,
                                               arguments.seconds)
                slowest["checker"] = max(slowest["checker"], (seconds, seed))
                if code != 0 or "the only one" not in said:
                    failed("checker", said)
                counts["checked"] += code == 0
                counts["the only solution"] += "the only one" in said
            elif code in (1, 2):
                counts["not proved"] += 1
                if kept:
                    print(f"seed {seed}, {family}: not proved: {said}", flush=True)
            else:
                failed("certifier", f"exit code {code}: {said}")
            seed += 1
    print(", ".join(f"{count} {what}" for what, count in counts.items()))
    print(", ".join(f"{who}: at most {seconds:.1f} s, seed {which}" for who, (seconds, which) in slowest.items()))
    if counts["not proved"] > NOT_PROVED * counts["problems"]:
        failures.append("too many problems are not proved")
        print(failures[-1])
    return 1 if failures else 0


sys.exit(main())
