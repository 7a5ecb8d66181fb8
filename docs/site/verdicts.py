"""Writes the pages of the ledger: statements of the paper with verdicts, entries with proofs, reading notes. Their texts come from
`verify --format json`, which has each text in plain letters and as HTML with formulas as MathML."""

import html
import re
from collections import Counter

VERDICTS = "[proved, supported, undecided or refuted](proofs.md)"

# The groups of reading notes, with their faults.
GROUPS = {"Formulas": ("print", "extraction", "undecided"), "Missing hypotheses": ("hypothesis",), "Wording": ("wording",)}


def counted(verdicts, names=("proved", "supported", "undecided", "refuted")):
    counts = Counter(verdicts)
    return "; ".join(f"{counts[one]} {one}" for one in names)


def made(found):
    return (f"Made by `steadyslide verify --quick --format json` of version {found['version']}, {found['digits']} digits, when "
            "this site was built.")


def cite(found, key, what):
    """Returns a fold with a citation of a verdict, as text and as BibTeX."""
    commit = f", commit {found['commit']}" if found["commit"] else ""
    place = f"steadyslide {found['version']}{commit}, {found['date']}"
    bibtex = (f"@misc{{steadyslide-{key},\n  author = {{{{The steadyslide contributors}}}},\n  title = {{{what}}},\n"
              f"  year = {{{found['date'][:4]}}},\n  note = {{{place}}},\n}}")
    return (f'<details class="cite"><summary aria-label="cite this verdict: {key}">cite</summary><p>{html.escape(f"{place}: {what}.")}</p>'
            f'<pre tabindex="0">{html.escape(bibtex)}</pre></details>')


def links(page, ids, prefix=""):
    return ", ".join(f'<a href="{page}.html#{prefix}{one.lower()}">{one}</a>' for one in ids)


def table(heads, rows):
    """Returns a table in HTML without columns that are empty in every row."""
    kept = [k for k in range(len(heads)) if any(row[k] for row in rows)]
    lines = ["".join(f'<td data-label="{heads[k]}">{row[k]}</td>' for k in kept) for row in rows]
    head = "".join(f'<th scope="col">{heads[k]}</th>' for k in kept)
    body = "\n".join(f"<tr>{line}</tr>" for line in lines)
    return (f'<div class="table-wrapper docutils container">\n<table class="docutils ledger">\n<thead><tr>{head}</tr></thead>\n'
            f"<tbody>\n{body}\n</tbody></table></div>")


def notes_of(found):
    """Returns the reading notes of each entry."""
    notes = {}
    for note in found["reading_notes"]:
        notes.setdefault(note["claim"], []).append(note["id"])
    return notes


def statements(found):
    notes = notes_of(found)

    def standing(one):
        but_for = one["html"]["restriction"]
        return one["standing"] + (f": {but_for}" if but_for else "")

    def row(one):
        entries = one["entries"] + one["instances"]
        own = sorted({note for entry in entries for note in notes.get(entry, ())})
        ids = [links("entries", one["entries"])] if one["entries"] else []
        ids += ["instances: " + links("entries", one["instances"])] if one["instances"] else []
        what = f"{one['place']} of Ballard (2016): {one['statement']}" if one["place"] else one["statement"]
        key = re.sub("[^a-z0-9]+", "-", (one["place"] or one["statement"]).lower()).strip("-")
        verdict = standing(one) + cite(found, key, f"{what.replace('`', '')}, {one['standing']}")
        return [html.escape(one["place"]), one["html"]["statement"], verdict, one["html"]["scope"], "; ".join(ids),
                links("reading-notes", own, "note-")]

    heads = ["place", "statement", "verdict", "scope", "entries", "reading notes"]
    paper, beyond = ([one for one in found["statements"] if bool(one["place"]) == of_paper] for of_paper in (True, False))
    return ["# The paper, statement by statement",
            f"Each statement of [Bal16] is {VERDICTS}. An entry of the ledger says it, or a part of it, and has its proof, its "
            "evidence and its controls; a reading note says where the text at hand and the derivation differ.",
            f"{len(paper)} statements: {counted((one['standing'] for one in paper), found['statement_counts'])}. {made(found)}",
            table(heads, [row(one) for one in paper]), "## Beyond the paper", table(heads, [row(one) for one in beyond])]


def tree(proof):
    """Returns the proof as nested lists, from its conclusion down. Steps have numbers; one that was shown before has its number alone."""
    steps, numbers = proof["steps"], {}
    places = {step["fact"]: k for k, step in enumerate(steps)}

    def show(k):
        step = steps[k]
        if k in numbers:
            return f"<li>({numbers[k]}) above</li>\n"
        numbers[k] = len(numbers) + 1
        by = step["by"]
        by = f'entry {links("entries", [by[6:]])}' if by.startswith("entry ") else html.escape(by)
        below = f"<ul>{''.join(map(show, step['from']))}</ul>" if step["from"] else ""
        return f"<li>({numbers[k]}) {step['html']['says']} <em>{by}</em>{below}</li>\n"

    concluded = "".join(show(places[fact]) for fact in proof["concludes"] if fact in places)
    return f"<details><summary>Proof, {len(steps)} steps</summary>\n<ul>{concluded}</ul></details>"


def entries(found):
    text = ["# Entries of the ledger",
            f"{len(found['claims'])} entries: {counted(one['verdict'] for one in found['claims'])}. {made(found)} `steadyslide "
            "verify --claim ID` prints one of them with its evidence, `--proof` its proof."]
    notes = notes_of(found)
    for claim in found["claims"]:
        own = links("reading-notes", notes.get(claim["id"], []), "note-")
        said, proof = claim["html"], claim.get("proof") or {}
        text += [f"## {claim['id']}",
                 f"<p><strong>{claim['verdict']}</strong> – {said['source']}</p>\n<p>{said['statement']}</p>"
                 + (f"\n<p><em>For:</em> {said['hypotheses']}</p>" if claim["hypotheses"] else "")
                 + (f"\n{tree(proof)}" if proof.get("steps") else ""),
                 f"Pieces of evidence: {len(claim['evidence'])}. Wrong variants that were tried: {claim['controls']['total']}, "
                 f"refuted: {claim['controls']['refuted']}." + (f" Reading notes: {own}." if own else ""),
                 cite(found, claim["id"], f"entry {claim['id']}, {claim['verdict']}")]
    return text


def reading_note(note):
    said = note["html"]
    fault = f"<li>at fault: {note['fault']}</li>\n" if note["fault"] in GROUPS["Formulas"] else ""
    return [f"### note {note['id']}",
            f"<p>{said['place']}</p>\n<ul>\n<li>read: {said['printed']}</li>\n<li>derived: {said['derived']}</li>\n{fault}</ul>\n"
            f"<p>{said['evidence']}</p>"]


def reading_notes(found):
    text = ["# Reading notes", "Where the text of [Bal16] at hand and the derivation differ: a note says what was read, not what was "
            "printed, unless it says so.",
            f"{len(found['reading_notes'])} notes. The printed page was not seen. {made(found)}"]
    for group, faults in GROUPS.items():
        text.append(f"## {group}")
        text += [part for note in found["reading_notes"] if note["fault"] in faults for part in reading_note(note)]
    return text
