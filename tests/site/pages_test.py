"""pages_test.py SOURCE PROGRAM WORK: what can be checked of the site without Sphinx. Links between the staged pages lead somewhere,
and the pages of the ledger say what `verify --format json` says, with a citation of each verdict."""

import json
import re
import subprocess
import sys
from pathlib import Path

source, program, work = (Path(argument).resolve() for argument in sys.argv[1:])
sys.dont_write_bytecode = True
sys.path.insert(0, str(source / "docs/site"))
import stage  # noqa: E402
import verdicts  # noqa: E402

GENERATED = {"command-line.md", "gallery.md", "statements.md", "entries.md", "reading-notes.md", "schema.md", "verify-schema.md",
             "cpp.md", "python-reference.md", "report/report.html"}
failures = []


def require(holds, what):
    if not holds:
        failures.append(what)


def wrong_links(pages):
    found = []
    for page in sorted(pages.rglob("*.md")):
        text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
        for match in stage.LINK.finditer(text):
            target = match[2]
            made = re.sub(r"\.html$", ".md", target) in GENERATED or target in GENERATED
            if not (made or target.startswith(("http", "mailto:")) or (page.parent / target).exists()):
                found.append(f"{page.relative_to(pages)}: {target}")
    return found


pages = work / "pages"
stage.main(pages, explorer=False)
failures += wrong_links(pages)
(pages / "control.md").write_text("[nowhere](nowhere.md)\n", encoding="utf-8")
require(len(wrong_links(pages)) == len(failures) + 1, "control: a link to nowhere was not noticed")

claims = ["thm-02-remarks-*", "eq-04-*", "alpha-range", "fig-03-rear-loaded", "rem-01-neglect"]
options = [option for claim in claims for option in ("--claim", claim)]
answer = subprocess.run([program, "verify", "--quick", "--digits", "16", "--format", "json", *options], capture_output=True, check=True)
found = json.loads(answer.stdout) | {"date": "2026-01-02"}
statements, entries, notes = ("\n".join(page(found)) for page in (verdicts.statements, verdicts.entries, verdicts.reading_notes))
for one in found["statements"]:
    said = one["standing"] + (f": {one['html']['restriction']}" if one["restriction"] else "")
    require(f'<td data-label="verdict">{said}<details' in statements, f"statements: {said}")
require("proved, restricted: each sentence" in statements, "statements: no restriction in words")
require(statements.count("@misc{") == len(found["statements"]), "statements: citations")
for claim in found["claims"]:
    require(f"@misc{{steadyslide-{claim['id']}," in entries, f"entries: no citation of {claim['id']}")
    require(f", 2026-01-02: entry {claim['id']}, {claim['verdict']}.</p>" in entries, f"entries: text of {claim['id']}")
groups = re.split(r"^## ", notes, flags=re.MULTILINE)[1:]
require([group.split("\n")[0] for group in groups] == list(verdicts.GROUPS), "reading notes: groups")
for note in found["reading_notes"]:
    home = [name for name, faults in verdicts.GROUPS.items() if note["fault"] in faults]
    places = [group.split("\n")[0] for group in groups if f"### note {note['id']}\n" in group]
    require(home == places, f"reading notes: {note['id']} stands in {places}")
require(len({note["fault"] for note in found["reading_notes"]}) >= 3, "reading notes: too few kinds for this test")
sys.exit("\n".join(failures) or 0)
