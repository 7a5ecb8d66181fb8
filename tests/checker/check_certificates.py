#!/usr/bin/env python3
"""check_certificates.py CHECKER STEADYSLIDE: steadyslide-check proves each certificate, and refuses each changed one.

The test makes certificates of all files in problems/ and of some examples, with `steadyslide solve --certify --certificate`. Some
certificates are stored in certificates/, so that the test notices a change of the format. NAME.loads is for an interval of loads,
NAME.cells is a bound for cells; MADE has their options. NAME.refused.json must be refused, with the words in REFUSED.
The changes are those in changes.json and CHANGES, each to the certificate that it names; then one key left out, for every key, and
one value of another type, for every value.
"""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent / "certificates"
PROBLEMS = pathlib.Path(__file__).parent / "problems"
LISTED = pathlib.Path(__file__).parent / "changes.json"
EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
CERTIFIED_EXAMPLES = ("flat_punch", "parabola", "parabola_rough_front", "parabola_rough_rear", "rounded_wedge", "stepped_punch",
                      "three_jumps", "tilting_punch", "two_bumps", "two_coatings_forward")
MADE = {
    "parabola_rough_front.loads": ("--load-steps", "0.9,1.1"),
    "two_bumps.loads": ("--load-steps", "0.099,0.101"),
    "lifted_punch.loads": ("--load-steps", "0.98,1.02"),
    "rounded_wedge.loads": ("--load-steps", "0.999,1.001"),
    "parabola_rough_front.cells": ("--method", "variational", "--cells", "64"),
}
REFUSED = {
    "wedge_on_jump_below_threshold": "theta > 0 fails",
    "wedge_on_jump_closed_corner": "theta > 0 fails",
}


def problem_of(name):
    name = name.removesuffix(".loads").removesuffix(".cells")
    return (EXAMPLES if name in CERTIFIED_EXAMPLES else PROBLEMS) / f"{name}.toml"


def made_by(steadyslide):
    """Returns certificates by name, made of the files in problems/ and of some examples."""
    names = {f.stem for f in PROBLEMS.glob("*.toml") if not f.stem.endswith(".refused")}.union(CERTIFIED_EXAMPLES)
    certificates = {}
    with tempfile.NamedTemporaryFile("r", suffix=".json") as file:
        for name, options in (dict.fromkeys(sorted(names), ("--digits", "50")) | MADE).items():
            subprocess.run([steadyslide, "solve", problem_of(name), "--certify", "--certificate", file.name, *options],
                           stdout=subprocess.DEVNULL, timeout=300, check=True)
            certificates[name] = pathlib.Path(file.name).read_text()
    return certificates


def run(checker, text, *options):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(text)
        file.flush()
        done = subprocess.run([checker, *options, file.name], capture_output=True, text=True, timeout=300, check=False)
    return done.returncode, done.stdout + done.stderr


def shifted(ball, power):
    """Returns the ball with its midpoint moved by 2^power. The radius stays."""
    mantissa, exponent, *radius = ball.split()
    m, e = int(mantissa, 16), int(exponent, 16)
    low = min(e, power)
    m = (m << (e - low)) + (1 << (power - low))
    return " ".join([f"{m:x}", f"{low:x}", *radius])


def with_radius(ball, radius):
    return " ".join(ball.split()[:2] + radius.split())


def free(c):
    return [p for p in c["points"] if "side" in p]


def change(path, value):
    """Returns a change that replaces the value at a path of keys."""

    def apply(c):
        at = c
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = value(at[path[-1]]) if callable(value) else value

    return apply


def drop_zone(c):
    """Removes all contact zones but the left one."""
    ends = [k for k, p in enumerate(c["points"]) if p["contact"] in ("begins", "ends")]
    c["points"] = [p for k, p in enumerate(c["points"]) if k not in ends[2:]]
    c["segments"] = c["segments"][: len(c["points"]) - 1]
    for k in range(ends[1], len(c["segments"])):
        c["segments"][k] = False


def close_gap(c):
    """Makes the whole support one contact zone: removes the free ends and the coefficients of q."""
    c["points"] = [p for p in c["points"] if "side" not in p]
    c["segments"] = [True] * (len(c["points"]) - 1)
    for point in c["points"][1:-1]:
        point["contact"] = "interior"
    c["q"] = []


def split_zone(c):
    """Opens a gap of length 2^-10 or so in the middle of the contact."""
    inner = next(k for k, p in enumerate(c["points"]) if p["contact"] == "interior")
    anchor = c["points"][inner]["anchor"]
    c["points"][inner]["contact"] = "outside"
    end = {"anchor": anchor, "log_offset": "-7 0 1 -64", "free": True}
    c["points"].insert(inner + 1, {**end, "side": "right", "contact": "begins"})
    c["points"].insert(inner, {**end, "side": "left", "contact": "ends"})
    c["segments"].insert(inner, False)
    c["segments"].insert(inner, False)


def exchange_side(c):
    """Exchanges the side of its anchor on which a free end lies. Its offset stays."""
    point = free(c)[0]
    point["side"] = "left" if point["side"] == "right" else "right"


def exchange_kind(c):
    """Replaces contact up to the right edge of the support by a free end just beside the edge."""
    last = c["points"][-1]
    last["contact"] = "outside"
    end = {"anchor": last["anchor"], "side": "left", "log_offset": "-14 0 1 -64", "contact": "ends", "free": True}
    c["points"].insert(-1, end)
    c["segments"].append(False)


def wide_loads(c):
    """Extends the loads of the last box beyond those that the proof was made for, to 1.2."""
    c["problem"]["loads"][1] = c["boxes"][-1]["loads"][1] = "1.2"


def scaled(factor):
    return lambda number: str(float(number) * factor)


def two_pressures(c):
    """Moves 2 % of one cell's pressure to its neighbour."""
    moved = c["pressures"][25] // 50
    c["pressures"][25] -= moved
    c["pressures"][26] += moved


def moved(by):
    return lambda number: str(float(number) + by)


LOADS, LIFTED_LOADS, CELLS = "parabola_rough_front.loads", "lifted_punch.loads", "parabola_rough_front.cells"
PARABOLA, STEP, SLOT, TILT, PUNCH, BUMPS, WEDGE = (
    "parabola_rough_front", "stepped_punch", "slotted_punch", "tilting_punch", "two_coatings_forward", "two_bumps", "wedge_on_jump")

# Each entry of changes.json changes one value: a name, the certificate, the path, and the new value. The origin of the frame is
# changed in a certificate with q: without q the frame may move, because offsets are relative to anchors, and the certificate stays
# true.
CHANGES = [(what, name, change(path, value)) for what, name, path, value in json.loads(LISTED.read_text())] + [
    ("step the other way", STEP, change(["problem", "indenter", "pieces", 1, "profile", 0], lambda c: "-" + c)),
    ("anchor of a free end", PARABOLA, lambda c: free(c)[0].update(anchor=0)),
    ("an edge that is free", PARABOLA, lambda c: free(c)[0].update(free=False)),
    ("side of a free end", PARABOLA, exchange_side),
    ("place of a free end", PARABOLA, lambda c: free(c)[0].update(log_offset=shifted(free(c)[0]["log_offset"], -100))),
    ("box moved by its width", PARABOLA, lambda c: free(c)[1].update(log_offset=shifted(free(c)[1]["log_offset"], -174))),
    ("box without width", PARABOLA, lambda c: free(c)[0].update(log_offset=with_radius(free(c)[0]["log_offset"], "0 0"))),
    ("box too wide", PARABOLA, lambda c: free(c)[0].update(log_offset=with_radius(free(c)[0]["log_offset"], "1 1"))),
    ("box of everything", PARABOLA, lambda c: free(c)[0].update(log_offset=with_radius(free(c)[0]["log_offset"], "1 ff"))),
    ("infinite place", PARABOLA, lambda c: free(c)[0].update(log_offset="0 -1 0 0")),
    ("place that is no number", PARABOLA, lambda c: free(c)[0].update(log_offset="0 -3 0 -1")),
    ("place in decimals", PARABOLA, lambda c: free(c)[0].update(log_offset="-0.9")),
    ("no contact at all", PARABOLA, lambda c: c.update(segments=[False] * len(c["segments"]))),
    ("a segment less", PARABOLA, lambda c: c["segments"].pop()),
    ("a point less", PARABOLA, lambda c: c["points"].pop()),
    ("points in another order", PARABOLA, lambda c: c["points"].reverse()),
    ("an anchor twice", PARABOLA, lambda c: (c["points"].append(c["points"][-1]), c["segments"].append(False))),
    ("coefficient of q", SLOT, lambda c: c.update(q=[shifted(c["q"][0], -100)])),
    ("coefficient of q too many", SLOT, lambda c: c["q"].append(c["q"][0])),
    ("coefficient of q too few", SLOT, lambda c: c["q"].pop()),
    ("coefficient of q that is none", PARABOLA, lambda c: c["q"].append("1 0 1 -64")),
    ("tilt", TILT, lambda c: c.update(tilt=shifted(c["tilt"], -100))),
    ("tilt's box without width", TILT, lambda c: c.update(tilt=with_radius(c["tilt"], "0 0"))),
    ("tilt left out", TILT, lambda c: c.pop("tilt")),
    ("tilt without load_at", PARABOLA, lambda c: c.update(tilt="0 0 1 -64")),
    ("a zone dropped", BUMPS, drop_zone),
    ("a zone split", PARABOLA, split_zone),
    ("a free end for an edge", PUNCH, exchange_kind),
    ("loads from 0", LOADS, lambda c: (change(["problem", "loads", 0], "0")(c), change(["boxes", 0, "loads", 0], "0")(c))),
    ("loads the other way", LOADS, lambda c: c["problem"]["loads"].reverse()),
    ("loads of three ends", LOADS, lambda c: c["problem"]["loads"].append("2")),
    ("a load beside the loads", LOADS, lambda c: c["problem"].update(load="1")),
    ("loads too many for their box", LOADS, wide_loads),
    ("a part left out", LOADS, lambda c: c["boxes"].pop(1)),
    ("the last part left out", LOADS, lambda c: c["boxes"].pop()),
    ("parts in another order", LOADS, lambda c: c["boxes"].reverse()),
    ("boxes of each other", LOADS, lambda c: c["boxes"][0].update(points=c["boxes"][1]["points"])),
    ("a point in one box", LOADS, lambda c: c["boxes"][2]["points"].pop()),
    ("a free end in one box", LOADS, lambda c: free(c["boxes"][2])[0].update(
        log_offset=shifted(free(c["boxes"][2])[0]["log_offset"], -4))),
    ("one box too narrow for its loads", LOADS, lambda c: free(c["boxes"][2])[0].update(
        log_offset=with_radius(free(c["boxes"][2])[0]["log_offset"], "1 -40"))),
    ("a tilt in one box", LIFTED_LOADS, lambda c: c["boxes"][1].update(tilt=shifted(c["boxes"][1]["tilt"], -3))),
    ("an energy too small by 1 %", CELLS, change(["energy"], scaled(0.99))),
    ("an energy that proves less", CELLS, change(["energy"], scaled(1.01))),
    ("pressure moved from cell to cell", CELLS, two_pressures),
    ("no pressure", CELLS, lambda c: c.update(pressures=[0] * len(c["pressures"]))),
    ("a cell less", CELLS, lambda c: c["pressures"].pop()),
    ("a reach less", CELLS, lambda c: c["reaches"].pop()),
    ("a load share from higher up", CELLS, change(["claims", "load_share", 0, 0], moved(1e-4))),
    ("a load share to lower down", CELLS, change(["claims", "load_share", 1, 1], moved(-1e-4))),
    ("a load share less", CELLS, lambda c: c["claims"]["load_share"].pop()),
    ("a load share the other way", CELLS, lambda c: c["claims"]["load_share"][0].reverse()),
    ("effective friction from higher up", CELLS, change(["claims", "effective_friction", 0], moved(1e-4))),
    ("effective friction to lower down", CELLS, change(["claims", "effective_friction", 1], moved(-1e-4))),
    ("a radius of 33 bits", PARABOLA, lambda c: free(c)[0].update(log_offset=with_radius(free(c)[0]["log_offset"], "80000001 -f0"))),
    ("a ball not in lowest terms", PARABOLA, lambda c: free(c)[0].update(log_offset=with_radius(free(c)[0]["log_offset"], "2 -b1"))),
    ("an end in the contact that is none", SLOT,
     lambda c: next(p for p in c["points"] if p["contact"] == "ends").update(contact="interior")),
    ("contact beyond the gap of a notch", "notch_gap", drop_zone),
    ("the gap of a notch closed", "notch_gap", close_gap),
    ("the gap of a notch on the other side", "notch_gap", exchange_side),
    ("an unknown key", PARABOLA, lambda c: c.update(proved=True)),
    ("an unknown key of a point", PARABOLA, lambda c: c["points"][0].update(proved=True)),
]

# Changes that leave a certificate true. The narrowest gap of the first one is 0.0028, and 3.7e-11 after the change.
STILL_TRUE = [
    ("load under which a gap almost closes", "gap_that_narrows", change(["problem", "load"], "0.3027864235")),
]


def paths(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from paths(item, (*path, key))


def main():
    checker = sys.argv[1]
    failures, checked = [], 0

    def expect(codes, what, text, words="", options=()):
        nonlocal checked
        checked += 1
        code, said = run(checker, text, *options)
        lines = said.strip().splitlines()
        clear = code == 0 or len(lines) >= 1 and lines[-1].startswith("steadyslide-check: ")
        if code not in codes or words not in said or not clear:
            failures.append(f"{what}: exit code {code}: {said.strip()[:300]}")

    def expect_proof(name, text):
        proved = ("load shares and effective friction of the solution lie in the intervals" if name.endswith(".cells")
                  else "for every load its box contains a solution" if name.endswith(".loads")
                  else "the box contains a solution")
        options = ("--problem", problem_of(name))
        expect({0}, name, text, f"proved: {proved}", options)
        other = certificates["two_bumps" if name.startswith(PARABOLA) else PARABOLA]
        expect({1}, f"{name}'s problem, another certificate", other, "not the certificate's", options)

    stored = {f.name.removesuffix(".json"): f.read_text() for f in sorted(HERE.glob("*.json"))}
    made = made_by(sys.argv[2])
    certificates = made | stored
    for name, text in [*made.items(), *stored.items()]:
        if name.endswith(".refused"):
            expect({1}, name, text, REFUSED[name.removesuffix(".refused")])
        else:
            expect_proof(name, text)

    for what, name, apply in CHANGES:
        changed = json.loads(certificates[name])
        apply(changed)
        expect({1, 2}, f"changed: {what}", json.dumps(changed))

    for what, name, apply in STILL_TRUE:
        changed = json.loads(certificates[name])
        apply(changed)
        expect({0}, f"changed, and true: {what}", json.dumps(changed), "proved: the box contains a solution")

    # Leaves out every key that is not optional, and gives every value another type.
    original = json.loads(certificates[PARABOLA])
    for path in list(paths(original))[1:]:
        for kind, value in (("left out", None), ("another type", 7.5)):
            changed = copy.deepcopy(original)
            at = changed
            for key in path[:-1]:
                at = at[key]
            if kind == "another type":
                at[path[-1]] = value
            elif path[-1] == "free" and "side" not in at:
                continue
            else:
                del at[path[-1]]
            expect({1, 2}, f"{kind}: {'.'.join(map(str, path))}", json.dumps(changed))
    text = certificates[PARABOLA]
    expect({2}, "a key twice", text.replace('"bits": 256', '"bits": 512, "bits": 256'), "key given twice")
    expect({2}, "half a document", text[: len(text) // 2], "not JSON")
    expect({2}, "nothing", "", "not JSON")

    def expect_file(name, words):
        nonlocal checked
        checked += 1
        done = subprocess.run([checker, name], capture_output=True, timeout=60, check=False)
        said = done.stderr.decode("utf-8", "replace")
        if done.returncode != 2 or words not in said or said.count("\n") != 1:
            failures.append(f"{name}: exit code {done.returncode}: {said[:300]}")

    expect_file("/dev/zero", "at most 64 MiB")
    expect_file(str(HERE), "a directory")
    expect_file("no\nsuch \x1b[31m file", "no\\x0asuch \\x1b[31m file: cannot be read")
    expect_file("nö such file", "nö such file: cannot be read")

    print("\n".join(failures))
    print(f"{checked - len(failures)} passed, {len(failures)} failed")
    print(f"{len(CHANGES)} kinds of change")
    sys.exit(bool(failures) or len(stored) < 8 or len(made) < 20)


if __name__ == "__main__":
    main()
