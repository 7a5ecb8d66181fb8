#!/usr/bin/env python3
"""The guard against tautologies. It changes one definition of the model, for all code that uses it, and checks the whole ledger.
A claim about this definition that still holds compares the program with itself.

tests/mutants/guard.toml has the changes, and for each the claims that must notice it. docs/guard.csv has the claims that noticed
each change. A claim that must notice a change and does not gets a second route. There are no exceptions.

Exit code: 0 every claim has noticed the changes that it must notice, 1 a claim has not, 2 the list is wrong or the table differs
from it, 3 the build is not usable.
"""

import argparse
import csv
import fnmatch
import json
import sys
import tempfile
import tomllib
from dataclasses import dataclass
from pathlib import Path

sys.dont_write_bytecode = True
from build_tree import BuildFailed, BuildTree  # noqa: E402
from mutant_list import BadList, Mutant, faults  # noqa: E402
from run_mutants import PROGRAM, ROOT, started  # noqa: E402

COLUMNS = ["change", "file", "what", "noticed by"]
SETTLED = ("proved", "supported")
TIME_LIMIT = 900


@dataclass(frozen=True)
class Change:
    mutant: Mutant
    speaks: tuple  # patterns of the ids of claims that have to notice the change


def read_changes(path):
    entries = tomllib.loads(path.read_text(encoding="utf-8"))["change"]
    changes = []
    for entry in entries:
        if "open" in entry:
            raise BadList(f"{entry['id']}: no claim may be open, silent under a change that it speaks of: {entry['open']}")
        speaks = tuple(entry.pop("speaks"))
        changes.append(Change(Mutant(killed_by=PROGRAM, **entry), speaks))
    wrong = [fault for change in changes for fault in faults(change.mutant, ROOT)]
    if wrong:
        raise BadList("\n".join(wrong))
    return changes


def examined(program):
    """Returns the claims of a quick run in double by id: True if proved or supported. Returns None if the program fails."""
    code, output = started([program, "verify", "--quick", "--digits", "16", "--format", "json"], TIME_LIMIT)
    if code not in (0, 1):
        return None
    claims = json.loads(output)["claims"]
    return {claim["id"]: claim["verdict"] in SETTLED for claim in claims}


def noticed(change, tree, before):
    """Returns the claims that hold before the change and not after it. If the changed program fails, these are all."""
    with tempfile.TemporaryDirectory(prefix="guard-") as temporary:
        folder = Path(temporary)
        text = (ROOT / change.mutant.file).read_text(encoding="utf-8")
        program = tree.link(PROGRAM, tree.compile(change.mutant.file, change.mutant.applied_to(text), folder), folder)
        after = examined(program)
    held = [name for name, holds in before.items() if holds]
    return held if after is None else [name for name in held if not after[name]]


def silent(change, before, claims):
    speaking = [name for name in before if any(fnmatch.fnmatch(name, pattern) for pattern in change.speaks)]
    return [name for name in speaking if name not in claims]


def unmatched(changes, known):
    return [f"{change.mutant.id}: no claim {pattern}" for change in changes for pattern in change.speaks
            if not fnmatch.filter(known, pattern)]


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", metavar="DIR", type=Path, default=ROOT / "build" / "release",
                        help="a build directory of Ninja with the program built (build/release)")
    parser.add_argument("--only", metavar="ID", nargs="+", help="these changes")
    parser.add_argument("--check", metavar="CSV", type=Path, help="compare the list with this table and run nothing")
    parser.add_argument("--write", metavar="CSV", type=Path, help="write the table")
    return parser.parse_args(arguments)


def main(arguments):
    options = parsed(arguments)
    try:
        changes = read_changes(Path(__file__).with_name("guard.toml"))
    except (BadList, OSError, KeyError, TypeError, tomllib.TOMLDecodeError) as error:
        print(error, file=sys.stderr)
        return 2
    if options.check:
        with options.check.open(encoding="utf-8", newline="") as file:
            table = {row["change"]: row["noticed by"].split() for row in csv.DictReader(file)}
        wrong = [f"{c.mutant.id}: not in the table" for c in changes if c.mutant.id not in table]
        wrong += [f"{c.mutant.id}: no claim in the table is {pattern}" for c in changes if c.mutant.id in table
                  for pattern in c.speaks if not fnmatch.filter(table[c.mutant.id], pattern)]
        print("\n".join(wrong) if wrong else f"{len(changes)} changes, all in the table")
        return 2 if wrong else 0
    if options.only:
        changes = [change for change in changes if change.mutant.id in options.only]
    try:
        tree = BuildTree(options.build.resolve(), ROOT)
    except OSError as error:
        print(f"no build of Ninja with compile commands: {error}", file=sys.stderr)
        return 3
    before = examined(tree.executable(PROGRAM))
    if before is None:
        print("the program fails without any change", file=sys.stderr)
        return 3
    if wrong := unmatched(changes, before):
        print("\n".join(wrong), file=sys.stderr)
        return 2
    rows, quiet = [], 0
    for change in changes:
        try:
            claims = noticed(change, tree, before)
        except BuildFailed as failure:
            print(f"{change.mutant.id}: not built: {failure}", file=sys.stderr)
            return 3
        missing = silent(change, before, claims)
        quiet += len(missing)
        print(f"{change.mutant.id:20} noticed by {len(claims)}" + (f"; SILENT: {' '.join(missing)}" if missing else ""), flush=True)
        rows.append([change.mutant.id, change.mutant.file, change.mutant.change, " ".join(claims)])
    if options.write:
        with options.write.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    return 1 if quiet else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
