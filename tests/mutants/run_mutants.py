#!/usr/bin/env python3
"""Builds mutants of the program, each with one wrong line, and shows that a verification executable or a test refutes every
one. A check that accepts a wrong formula is no check.

tests/mutants/mutants.toml is the list, docs/mutants.csv the table of the checks that refuted them. For each mutant one source is
compiled, outside the build directory, and linked into its killer before the libraries. The mutant is refuted if the killer fails,
or gives no answer in time. Each killer must first pass without a mutant. If a killer runs the program and does not contain
it, the mutant is linked into the program.

Exit code: 0 all refuted, 1 one survives, 2 the list is wrong or the table differs from it, 3 the build is not usable.
"""

import argparse
import os
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from threading import Lock

sys.dont_write_bytecode = True
from build_tree import BuildFailed, BuildTree  # noqa: E402
from evidence import first_refuting_line  # noqa: E402
from mutant_list import BadList, disagreements, read_list, read_table, table_text  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = "steadyslide"


@dataclass
class Outcome:
    killed: bool
    seconds: float
    evidence: str
    broken: bool = False  # the run has no result


def started(command, time_limit, program=None):
    """Returns the exit code and the output. The code is None if there is no answer in time."""
    environment = {"RC_PARAMS": "seed=2016", **os.environ}
    if program:
        environment["STEADYSLIDE_EXECUTABLE"] = str(program)
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                              text=True, errors="replace", timeout=time_limit, env=environment, check=False)
        return done.returncode, done.stdout
    except subprocess.TimeoutExpired:
        return None, ""


class Runner:
    def __init__(self, tree, time_limit, root=ROOT):
        self.tree = tree
        self.time_limit = time_limit
        self.root = root
        self.limits = {}
        self.lock = Lock()

    def limit_of(self, killer):
        """Returns the seconds that the killer may take with a mutant: many times its time without one, for a busy machine.

        Returns None if the killer fails without a mutant. The first thread that needs a killer's limit runs it, once.
        """
        with self.lock:
            if killer not in self.limits:
                name, *arguments = shlex.split(killer)
                start = time.monotonic()
                code, output = started([self.tree.executable(name), *arguments], 10 * self.time_limit)
                # A filter that matches no test case would always pass.
                passes = code == 0 and "test cases: 0 |" not in " ".join(output.split())
                needed = round(20 * (time.monotonic() - start))
                self.limits[killer] = max(self.time_limit, needed) if passes else None
            return self.limits[killer]

    def run(self, mutant):
        start = time.monotonic()

        def outcome(killed, evidence, broken=False):
            return Outcome(killed, time.monotonic() - start, evidence, broken)

        name, *arguments = shlex.split(mutant.killed_by)
        if not self.tree.executable(name).is_file():
            return outcome(False, f"{name} is not built", broken=True)
        limit = self.limit_of(mutant.killed_by)
        if limit is None:
            return outcome(False, "the killer fails, or checks nothing, without any mutant", broken=True)
        with tempfile.TemporaryDirectory(prefix="mutant-") as temporary:
            folder = Path(temporary)
            try:
                text = (self.root / mutant.file).read_text(encoding="utf-8")
                mutated = self.tree.compile(mutant.file, mutant.applied_to(text), folder)
                inside = self.tree.contains(name, mutant.file)
                built = self.tree.link(name if inside else PROGRAM, mutated, folder)
            except BuildFailed as failure:
                return outcome(False, f"not built: {failure}", broken=True)
            executable, program = (built, None) if inside else (self.tree.executable(name), built)
            code, output = started([executable, *arguments], limit, program)
            if code == 0:
                return outcome(False, "the killer passes")
            if code is None:
                return outcome(True, "no answer in twenty times the time that it takes unmutated, or longer")
            return outcome(True, first_refuting_line(output.replace(str(folder), "bin"), code, self.root))


def selected(mutants, options):
    if options.only:
        unknown = sorted(set(options.only) - {mutant.id for mutant in mutants})
        if unknown:
            raise BadList(f"no such mutant: {', '.join(unknown)}")
        mutants = [mutant for mutant in mutants if mutant.id in options.only]
    if options.sample:
        mutants = [mutant for mutant in mutants if mutant.sample]
    if options.shard:
        # Neighbours in the list have the same killer, which runs without a mutant once in each shard.
        number, shards = options.shard
        mutants = mutants[(number - 1) * len(mutants) // shards:number * len(mutants) // shards]
    return mutants[: options.first]


def shard(text):
    number, shards = (int(part) for part in text.split("/"))
    if not 1 <= number <= shards:
        raise ValueError
    return number, shards


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", metavar="DIR", type=Path, default=ROOT / "build" / "release",
                        help="a build directory of Ninja with the tests built (build/release)")
    parser.add_argument("--from", dest="list_file", metavar="FILE", type=Path,
                        default=Path(__file__).with_name("mutants.toml"), help="another list of mutants")
    parser.add_argument("--only", metavar="ID", nargs="+", help="these mutants")
    parser.add_argument("--first", metavar="N", type=int, help="the first N of those")
    parser.add_argument("--shard", metavar="N/M", type=shard, help="the N-th of M parts of the list")
    parser.add_argument("--sample", action="store_true", help="the few that ./check runs")
    parser.add_argument("--list", action="store_true", help="show them and run nothing")
    parser.add_argument("--check", metavar="CSV", type=Path, help="compare the list with this table and run nothing")
    parser.add_argument("--write", metavar="CSV", type=Path,
                        help="write the table; of mutants not run now, the rows that it has")
    parser.add_argument("--time-limit", metavar="S", type=int, default=60, help="seconds a killer may take at least before it counts as hanging (60)")
    parser.add_argument("-j", dest="jobs", metavar="N", type=int, default=1, help="mutants run at a time (1)")
    return parser.parse_args(arguments)


def run_all(mutants, runner, jobs):
    """Runs the mutants. Prints the line of a mutant as soon as all mutants before it are done."""
    outcomes = {}
    with ThreadPoolExecutor(jobs) as pool:
        for mutant, outcome in zip(mutants, pool.map(runner.run, mutants)):
            verdict = "killed" if outcome.killed else "NOT RUN" if outcome.broken else "SURVIVED"
            print(f"{mutant.id:28} {verdict:8} {mutant.killed_by}  {outcome.seconds:.1f} s  {outcome.evidence}", flush=True)
            outcomes[mutant.id] = outcome
    return outcomes


def main(arguments):
    options = parsed(arguments)
    try:
        everything = read_list(options.list_file, ROOT)
        mutants = selected(everything, options)
    except BadList as error:
        print(error, file=sys.stderr)
        return 2
    if options.list:
        for mutant in mutants:
            print(f"{mutant.id:28} {mutant.file}: {mutant.change}; {mutant.killed_by}")
        return 0
    if options.check:
        wrong = disagreements(everything, read_table(options.check))
        print("\n".join(wrong) if wrong else f"{len(everything)} mutants, all in the table")
        return 2 if wrong else 0
    try:
        tree = BuildTree(options.build.resolve(), ROOT)
    except OSError as error:
        print(f"no build of Ninja with compile commands: {error}", file=sys.stderr)
        return 3
    outcomes = run_all(mutants, Runner(tree, options.time_limit), options.jobs)
    killed = {name: outcome.evidence for name, outcome in outcomes.items() if outcome.killed}
    broken = any(outcome.broken for outcome in outcomes.values())
    print(f"{len(killed)} of {len(outcomes)} mutants refuted")
    if options.write:
        known = {name: row for name, row in read_table(options.write).items() if name not in outcomes}
        options.write.write_text(table_text(everything, killed, known), encoding="utf-8")
    if broken:
        return 3
    return 0 if len(killed) == len(outcomes) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
