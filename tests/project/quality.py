#!/usr/bin/env python3
"""quality.py [--check] [--output FILE]: writes docs/quality.md from the results that ./check left in build/*/Testing/*.xml.

Each row of ROWS names tests and the numbers in their outputs, which are added. Of a test that ran several times the last result
counts. A row with a test that failed, or with some tests that did not run, has no figure. A row of which no test ran here keeps the
figure and the commit that the page has; there it may be a sum, with several commits. The commit is that of the tree: run this before
the tree changes. --check only looks whether each row has its tests.

Exit code: 0 written, 1 written, and a row has no figure, 2 a row of this build without tests or a wrong argument.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMBERS = {
    "cases": r"\[doctest\] test cases: +(\d+)", "assertions": r"\[doctest\] assertions: +(\d+)", "random": r"OK, passed (\d+) tests",
    "proved": r"(?m)^(\d+) proved", "supported": r"(\d+) supported, \d+ undecided", "undecided": r"(\d+) undecided, \d+ refuted",
    "controls": r"(\d+) of +\d+ controls refuted",
    "refuted": r"(\d+) of \d+ mutants refuted", "mutants": r"\d+ of (\d+) mutants refuted",
    "changes": r"noticed by \d+", "files": r"(\d+) changed files", "faults": r"(\d+) faults",
    "compared": r"(?:Riemann-Hilbert|cells) +(\d+) +\d+ +\d+", "broken": r"(?:Riemann-Hilbert|cells) +\d+ +\d+ +(\d+)",
    "certified": r"(\d+) checked", "only": r"(\d+) the only solution",
    "honest": r"(\d+) of \d+ estimates honest", "estimates": r"\d+ of (\d+) estimates honest",
    "lemmas": r"(\d+) lemmas compiled", "variants": r"(\d+) wrong variants compiled",
    "links": r"(\d+) links, 0 wrong", "names": r"(\d+) exported", "states": r"(\d+) states of",
}
# Evidence, what it shows, the build, the label of the tests or None, the tests' names, the command, the figure.
ROWS = [
    ("Tests", "Parts of the program, its commands and answers", "release", None, ".", "./check",
     "{tests} tests, {cases} test cases, {assertions} assertions"),
    ("Slow tests", "The same with more data, more digits and other programs", "release", "slow", ".", "./check --all",
     "{tests} tests more, {cases} test cases, {assertions} assertions"),
    ("Ledger", "The paper's statements, [proved or supported](proofs.md), with 16 digits (`./verify`: 50)", "release", None,
     "^verify-(?!wrong|schema)", "./check",
     "{proved} proved, {supported} supported, {undecided} undecided; {controls} wrong variants refuted"),
    ("Laws", "Load, equation and mirror of random problems, each method", "release", "full", "^laws", "./check --full laws_400",
     "{random} random problems"),
    ("Laws of pairs", "Order in load, tilt and friction", "release", "full", "^contact_laws", "./check --full contact_laws",
     "{compared} pairs, {broken} against a law"),
    ("Mutants", "[One wrong line](mutants.csv); its test must fail", "release", "full", "^mutants", "./check --full mutants",
     "{refuted} of {mutants} refuted"),
    ("Guard", "[A changed model](guard.csv); its claims must notice", "release", "full", "^guard", "./check --full guard",
     "{changes} changes, each noticed"),
    ("Compilers", "Warnings of clang 14 (g++ 12 compiles the tests, where a warning is an error in CI)", "release", "slow", "^project_clang",
     "./check --all", "none in the whole tree"),
    ("clang-tidy", "Its findings in sources, and those of shellcheck in scripts", "release", "full", "^project_tidy", "./check --full tidy",
     "none"),
    ("Sanitizers", "Addresses and undefined behaviour", "sanitize", None, ".", "./check --sanitize",
     "{tests} tests, {assertions} assertions, no report"),
    ("Threads", "Data races", "tsan", "threads", ".", "cmake --preset tsan && cmake --build --preset tsan && ctest --preset tsan",
     "{tests} tests, {assertions} assertions, no report"),
    ("Fuzzing", "Changed problem files and certificates", "release", "full", "^fuzz_", "./check --full fuzz",
     "{files} files, {faults} faults"),
    ("Containment", "Balls of random arguments contain the values", "release", "slow", "^enclosure", "./check --all",
     "{random} random arguments"),
    ("Error estimates", "Estimated error against the true one", "release", "full", "^error_estimates", "./check --full error_estimates",
     "{honest} of {estimates} not below the true error"),
    ("Certificates", "[Proofs](certified.md) of random problems, checked by steadyslide-check", "release", "slow", "^checker_audit",
     "./check --all", "{certified} accepted, {only} of them as the only solution"),
    ("Coq", "Decided identities, and wrong variants of them", "release", "slow", "^coq", "./check --all",
     "{lemmas} lemmas accepted, {variants} variants refused"),
    ("Peers", "Finite elements, SciPy, mpmath, and other routes", "release", "slow", "^(reference|layer_comp|example_finite)", "./check --all",
     "{tests} comparisons ([cost](cost.md) has the times)"),
    ("Explorer", "States of the page against the program", "release", "slow", "^explorer", "./check --all", "{states} states agree to 1e-12"),
    ("Site", "Its links and its index of names", "release", "slow", "^site", "./check --all", "{links} links, {names} names of C++"),
]

PAGE = """# Evidence

What was run for version {version}, with the figures of these runs and the commit that was tested. `./check` and the commands below leave
their results in `build/`, and `tests/project/quality.py` makes this page of them. The times are for two cores: `./check --all` takes at
most 75 minutes, a test of a full set (`./check --full NAME`) at most 40. `ctest --preset tests -N -L full` lists the full sets.
The test `numeric` tests the products of powers on each instruction set of the processor, so the number of assertions depends on the machine.
{age}

| evidence | what it shows | command | commit | figure |
|---|---|---|---|---|
{rows}

{ending}
"""


def tests_of(build):
    """Returns the names of the build's tests with their labels."""
    done = subprocess.run(["ctest", "--test-dir", ROOT / "build" / build, "--show-only=json-v1"], capture_output=True, check=False)
    if done.returncode:
        return {}
    properties = {test["name"]: {entry["name"]: entry["value"] for entry in test["properties"]} for test in json.loads(done.stdout)["tests"]}
    return {name: set(entry.get("LABELS", [])) for name, entry in properties.items()}


def results_of(build):
    """Returns (status, output) of the last run of each test."""
    results = {}
    reports = sorted((ROOT / "build" / build / "Testing").glob("*.xml"), key=lambda path: path.stat().st_mtime)
    for report in reports:
        for case in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
            results[case.get("name")] = (case.get("status"), case.findtext("system-out") or "")
    return results


def selected(tests, label, pattern):
    long = {"slow", "full"}
    return [name for name, labels in tests.items() if re.search(pattern, name) and (label in labels if label else not labels & long)]


def rows_of(page):
    """Returns the commit and the figure of each row of a page that exists."""
    if not page.exists():
        return {}
    cells = [line.strip("| ").split(" | ") for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    return {row[0]: tuple(row[3:]) for row in cells if len(row) == 5}


def age_of(commits):
    """Returns which rows tested the program before its last change, and what changed since, from the commit of each row."""
    git = ["git", "-C", ROOT]
    layers = ["model", "symbolic", "numeric", "enclosure", "checker", "proofs_checks", "library", "app", "bindings"]
    # A change of comments, includes or help alone does not count. The help of the checker is the strings of its main.cpp.
    kinds = [("^[[:space:]]*[^#/[:space:]]", [*layers, ":!app/help", ":!checker/main.cpp", ":!*.1", ":!*.py"]),
             ("^[[:space:]]*[^#/\"[:space:]]", ["checker/main.cpp"])]
    changes = [subprocess.run([*git, "log", "-1", "--format=%H", "-G", pattern, "--", *paths], capture_output=True,
                              text=True, check=True).stdout.strip() for pattern, paths in kinds]
    newest = [*git, "log", "-1", "--no-walk", "--format=%h", *changes]
    last = subprocess.run(newest, capture_output=True, text=True, check=True).stdout.strip()
    older, changed = [], set()
    for kind, tested in commits.items():
        files = {name for commit in filter(None, tested.split(", ")) for pattern, paths in kinds
                 for name in subprocess.run([*git, "diff", "--name-only", "-G", pattern, commit.removesuffix("-dirty"), "HEAD", "--", *paths],
                                            capture_output=True, text=True, check=True).stdout.split()}
        older += [kind] if files else []
        changed |= files
    rows = "No run is older."
    if older:
        names = ", ".join(f"`{name}`" for name in sorted(changed))
        rows = f"The runs of these rows are older: {', '.join(older)}. Only these files changed after them: {names}."
    return f"The C++ code of the program changed last at {last}. {rows}"


class Figure(dict):
    """The numbers of a row by name, for str.format_map."""

    def __init__(self, outputs):
        super().__init__(tests=f"{len(outputs):,}")
        self.text = "\n".join(outputs)

    def __missing__(self, name):
        found = re.findall(NUMBERS[name], self.text)
        if not found:
            raise ValueError(f"no output has the number of {name}")
        # An expression without a group counts lines.
        return f"{sum(map(int, found)) if re.compile(NUMBERS[name]).groups else len(found):,}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="look whether each row of this build has tests")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs" / "quality.md")
    options = parser.parse_args()
    tests = {build: tests_of(build) for build in (["release"] if options.check else ["release", "sanitize", "tsan"])}
    empty = [row[0] for row in ROWS if row[2] == "release" and not selected(tests["release"], row[3], row[4])]
    if empty or options.check:
        print("\n".join(f"{kind}: no test" for kind in empty) or f"{len(ROWS)} kinds of evidence")
        return 2 if empty else 0
    results = {build: results_of(build) for build in tests}
    commit = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True, check=True).stdout.strip()
    before = rows_of(options.output)
    wrong, skipped, lines, commits = [], set(), [], {}
    for kind, shows, build, label, pattern, command, figure in ROWS:
        names = selected(tests[build], label, pattern)
        found = {name: results[build].get(name, ("not run", "")) for name in names}
        skipped.update(name for name, (status, _) in found.items() if status == "notrun")
        without = [f"{kind}: {name}: {status}" for name, (status, _) in found.items() if status not in ("run", "notrun")]
        if all(name not in results[build] for name in names):
            here = before.get(kind, ("", "not run"))
            wrong += [] if here[0] else [f"{kind}: not run"]
        elif without:
            here = commit, f"{len(without)} of {len(names)} tests failed or did not run"
            wrong += without
        else:
            try:
                here = commit, figure.format_map(Figure([output for status, output in found.values() if status == "run"]))
            except ValueError as error:
                here = commit, str(error)
                wrong.append(f"{kind}: {error}")
        commits[kind] = here[0]
        lines.append(f"| {kind} | {shows} | `{command}` | {here[0]} | {here[1]} |")
    version = re.search(r"project\(steadyslide VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    ending = f"Skipped, because a program is missing: {', '.join(sorted(skipped))}." if skipped else "No test was skipped."
    options.output.write_text(PAGE.format(version=version, age=age_of(commits), rows="\n".join(lines), ending=ending), encoding="utf-8")
    print("\n".join(wrong) or f"{len(lines)} rows")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
