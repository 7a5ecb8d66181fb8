"""generate.py PROGRAM OUTPUT: writes the pages that the program generates, into OUTPUT/pages.

command-line.md from its help, gallery.md from the examples and `figures`, schema.md and verify-schema.md from the JSON schemas,
statements.md, entries.md and reading-notes.md from `verify --format json`. No part of them is written by hand.
"""

import json
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timezone
from pathlib import Path

import schema
import verdicts

root = Path(__file__).resolve().parents[2]
program, output = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
pages = output / "pages"


def run(*arguments, executable=program):
    answer = subprocess.run([executable, *arguments], capture_output=True, encoding="utf-8", cwd=root)
    if answer.returncode not in (0, 1):
        sys.exit(answer.stderr)
    return answer.stdout


def command_line():
    """Returns the page with the help of the program and of each of its commands."""
    text = ["# The command line", "The output of `--help`."]
    help_text = run("--help")
    commands = re.findall(r"^  ([a-z]+)  ", help_text.split("Subcommands:")[1].split("\n\n")[0], re.MULTILINE)
    for name, answer in [("steadyslide", help_text)] + [(f"steadyslide {one}", run(one, "--help")) for one in commands]:
        text += [f"## {name}", f"```console\n$ {name} --help\n{answer.rstrip()}\n```"]
    for other in ("steadyslide-check", "steadyslide-sweep"):
        if (executable := program.parent / other).exists():
            text += [f"## {other}", f"```console\n$ {other} --help\n{run('--help', executable=executable).rstrip()}\n```"]
    return text


def example(path):
    """Returns a picture, the question that a problem file answers, and the file."""
    comment = [line.removeprefix("#").strip() for line in path.read_text(encoding="utf-8").splitlines() if line[:1] == "#"]
    data = "\n".join(line for line in path.read_text(encoding="utf-8").splitlines() if line[:1] != "#").strip()
    words = [line for line in comment[1:] if line and not line.startswith("steadyslide ")]
    picture = f"gallery/{path.stem}.svg"
    run("solve", str(path), "--plot", str(pages / picture), "-o", str(pages / "gallery" / f"{path.stem}.txt"))
    return [f"## {path.stem.replace('_', ' ')}", f"**{comment[0]}** {' '.join(words)}", f"![{comment[0]}]({picture})",
            f"`examples/{path.name}`, drawn by `steadyslide solve examples/{path.name} --plot {path.stem}.svg`:",
            f"```toml\n{data}\n```"]


def figures():
    """Returns the figures of the theory. docs/engineers.md has a table of their subjects."""
    run("figures", "-o", str(pages / "gallery"))
    text = ["## Figures of the theory", "Drawn by `steadyslide figures`; [what can be relied on](engineers.md#what-can-be-relied-on)."]
    table = (root / "docs/engineers.md").read_text(encoding="utf-8").split("\n## Figures\n")[1]
    for names, words in re.findall(r"^\| (`.*?) \| (.*) \|$", table, re.MULTILINE):
        for name in re.findall("`([^`]+)`", names):
            if (pages / "gallery" / f"{name}.svg").exists():
                text += [f"### {name.replace('-', ' ')}", f"![{name.replace('-', ' ')}](gallery/{name}.svg)", words]
    return text


def gallery():
    (pages / "gallery").mkdir(exist_ok=True)
    problems = [path for path in sorted((root / "examples").glob("*.toml")) if "[indenter]" in path.read_text(encoding="utf-8")]
    with ThreadPoolExecutor(2) as workers:
        drawn = workers.submit(figures)
        examples = list(workers.map(example, problems))
    text = ["# Gallery", "Each picture is drawn when this site is built, from the problem file beside it."]
    return text + [part for one in examples for part in one] + drawn.result()


def ledger():
    """Returns the output of `verify --quick --format json` and writes the report of the same run. The result is kept until the program changes."""
    kept = output / "verify.json"
    report = output / "report"
    if not kept.exists() or not report.exists() or kept.stat().st_mtime < program.stat().st_mtime:
        run("verify", "--quick", "--format", "json", "-o", str(kept), "--report", str(report))
    made = datetime.fromtimestamp(kept.stat().st_mtime, timezone.utc)
    return json.loads(kept.read_text(encoding="utf-8")) | {"date": made.strftime("%Y-%m-%d")}


def main():
    found = ledger()
    written = {"command-line": command_line(), "gallery": gallery(), "statements": verdicts.statements(found),
               "entries": verdicts.entries(found), "reading-notes": verdicts.reading_notes(found),
               "schema": schema.page("The JSON schema", root / "docs/solve.schema.json"),
               "verify-schema": schema.page("The JSON schema of the ledger", root / "docs/verify.schema.json")}
    for name, text in written.items():
        (pages / f"{name}.md").write_text("\n\n".join(text) + "\n", encoding="utf-8")


main()
