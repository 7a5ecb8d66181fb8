"""The list of mutants, tests/mutants/mutants.toml, and docs/mutants.csv, the table of the checks that refute them."""

import csv
import io
import tomllib
from dataclasses import dataclass
from pathlib import Path

COLUMNS = ["id", "file", "change", "killer", "evidence"]
PARTS = ("model", "symbolic", "numeric", "enclosure", "library", "proofs_checks", "app", "checker")


class BadList(Exception):
    """The list is invalid. No mutant was run."""


@dataclass(frozen=True)
class Mutant:
    id: str
    file: str  # a source of the program, relative to the project's root
    old: str  # a text that occurs exactly once in it
    new: str
    change: str  # the mistake in words
    killed_by: str  # an executable of bin/ with its arguments
    sample: bool = False  # one of the mutants that ./check runs

    def applied_to(self, text):
        return text.replace(self.old, self.new)


def faults(mutant, root):
    """Returns the reasons why this entry of the list is invalid."""
    path = root / mutant.file
    if not mutant.file.startswith(tuple(part + "/" for part in PARTS)) or path.suffix not in (".cpp", ".txt"):
        return [f"{mutant.id}: {mutant.file} is no source of {', '.join(PARTS)}"]
    if not path.is_file():
        return [f"{mutant.id}: there is no {mutant.file}"]
    count = path.read_text(encoding="utf-8").count(mutant.old) if mutant.old else 0
    result = []
    if count != 1:
        result.append(f"{mutant.id}: its old text occurs {count} times in {mutant.file}, not once")
    if mutant.old == mutant.new:
        result.append(f"{mutant.id}: changes nothing")
    return result


def read_list(path, root):
    """Returns all mutants in the order of the file. Raises BadList."""
    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8"))["mutant"]
        mutants = [Mutant(**entry) for entry in entries]
    except (OSError, tomllib.TOMLDecodeError, KeyError, TypeError) as error:
        raise BadList(f"{path.name}: {error}") from error
    wrong = [fault for mutant in mutants for fault in faults(mutant, root)]
    ids = [mutant.id for mutant in mutants]
    wrong += [f"{name}: listed more than once" for name in sorted(set(ids)) if ids.count(name) > 1]
    if wrong:
        raise BadList("\n".join(wrong))
    return mutants


def read_table(path):
    """Returns the rows by id. The result is empty if there is no table yet."""
    if not path.is_file():
        return {}
    with path.open(encoding="utf-8", newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def row_of(mutant):
    """Returns the mutant's row of the table without the evidence."""
    return {"id": mutant.id, "file": mutant.file, "change": mutant.change, "killer": mutant.killed_by}


def table_text(mutants, evidence, known):
    """Returns the table in the order of the list. Evidence is the new one, or else that of the old table.

    Mutants without evidence are left out.
    """
    stream = io.StringIO()
    writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for mutant in mutants:
        seen = evidence.get(mutant.id) or known.get(mutant.id, {}).get("evidence")
        if seen:
            writer.writerow({**row_of(mutant), "evidence": seen})
    return stream.getvalue()


def disagreements(mutants, table):
    """Returns the differences between the list and the table."""
    result = [f"{name}: in the table only" for name in table if name not in {mutant.id for mutant in mutants}]
    for mutant in mutants:
        row = table.get(mutant.id)
        if row is None:
            result.append(f"{mutant.id}: not in the table of refuted mutants")
        elif not row["evidence"]:
            result.append(f"{mutant.id}: refuted by nothing")
        else:
            result += [f"{mutant.id}: the table has another {name}" for name, value in row_of(mutant).items()
                       if row[name] != value]
    return result
