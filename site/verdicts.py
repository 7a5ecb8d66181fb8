"""Pages of the ledger: statements of the paper with their verdicts, entries with their proofs, reading notes."""

import html
import re
from collections import Counter

VERDICTS = "[proved, supported, undecided or refuted](proofs.md)"


def cell(text):
    """Text that may stand in a table's cell."""
    return text.replace("\n", " ").replace("|", "\\|")


def words(text):
    """Text of the ledger as Markdown: formulas between backticks stay, what else looks like a mark is none."""
    parts = re.split("(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([*_<\[\]])", r"\\\1", part) for part in parts)


def counted(verdicts):
    counts = Counter(verdicts)
    return ", ".join(f"{counts[one]} {one}" for one in ("proved", "supported", "undecided", "refuted"))


def made(found):
    return (f"Made by `steadyslide verify --quick --format json` of version {found['version']}, {found['digits']} digits, when "
            "this site was built.")


def links(ids):
    return ", ".join(f"[{one}](entries.md#{one})" for one in ids)


def table(heads, rows):
    """Without the columns in which no row has anything."""
    kept = [k for k in range(len(heads)) if any(row[k] for row in rows)]
    lines = [[heads[k] for k in kept], ["---"] * len(kept)] + [[row[k] for k in kept] for row in rows]
    return "\n".join("| " + " | ".join(map(cell, line)) + " |" for line in lines)


def statements(found):
    notes = {}
    for note in found["reading_notes"]:
        for entry in re.findall(r"\bclaim ([\w-]+)", note["evidence"]):
            notes.setdefault(entry, set()).add(note["id"])

    def row(one):
        ids = one.get("entries") or one.get("claims", [])
        own = sorted({note for entry in ids for note in notes.get(entry, ())})
        return [one["place"], words(one.get("statement") or one["what"]), one["verdict"], words(one.get("scope", "")), links(ids),
                ", ".join(f"[{note}](reading-notes.md#note-{note})" for note in own)]

    heads = ["place", "statement", "verdict", "scope", "entries", "reading notes"]
    paper, beyond = ([one for one in found["statements"] if bool(one["place"]) == of_paper] for of_paper in (True, False))
    return ["# The paper, statement by statement",
            f"Each statement of [Bal16] is {VERDICTS}. An entry of the ledger says it, or a part of it, and has its proof, its "
            "evidence and its controls; a reading note says where the text at hand and the derivation differ.",
            f"{len(paper)} statements: {counted(one['verdict'] for one in paper)}. {made(found)}",
            table(heads, [row(one) for one in paper]), "## Beyond the paper", table(heads, [row(one) for one in beyond])]


def html_words(text):
    return re.sub("`([^`]+)`", r"<code>\1</code>", html.escape(text, quote=False))


def tree(proof):
    """The proof as nested lists, from what it concludes down; a fact shown before is named only. HTML, since Markdown here
    gives up at the tenth level."""
    steps, shown = proof["steps"], set()
    places = {step["fact"]: k for k, step in enumerate(steps)}

    def show(k):
        step, again = steps[k], k in shown
        shown.add(k)
        below = "" if again or not step["from"] else f"<ul>{''.join(map(show, step['from']))}</ul>"
        words = html_words(step["says"].strip() or step["fact"])
        return f"<li>{words} <em>({html_words(step['by'])}{', see above' if again else ''})</em>{below}</li>\n"

    concluded = "".join(show(places[fact]) for fact in proof["concludes"] if fact in places)
    return f"<details><summary>Proof, {len(steps)} steps</summary>\n<ul>{concluded}</ul></details>"


def entries(found):
    text = ["# Entries of the ledger",
            f"{len(found['claims'])} entries: {counted(one['verdict'] for one in found['claims'])}. {made(found)} `steadyslide "
            "verify --claim ID` prints one of them with its evidence, `--proof` its proof."]
    for claim in found["claims"]:
        text += [f"## {claim['id']}", f"**{claim['verdict']}** – {words(claim['source'])}", words(claim["statement"])]
        if claim["hypotheses"]:
            text += [f"*For:* {words(claim['hypotheses'])}"]
        proof = claim.get("proof") or {}
        if proof.get("steps"):
            text += [tree(proof)]
        text += [f"Pieces of evidence: {len(claim['evidence'])}. Wrong variants that were tried: {claim['controls']['total']}, "
                 f"refuted: {claim['controls']['refuted']}."]
    return text


def reading_notes(found):
    text = ["# Reading notes", "Where the text of [Bal16] at hand and the derivation differ. The printed page was not seen: a note "
            "says what was read, not what was printed, unless it says so.",
            f"{len(found['reading_notes'])} notes. {made(found)}"]
    for note in found["reading_notes"]:
        fault = f"\n- fault: {note['fault']}" if note.get("fault") else ""
        text += [f"## note {note['id']}", words(note["place"]), f"- read: {words(note['printed'])}\n- derived: {words(note['derived'])}{fault}",
                 words(note["evidence"])]
    return text
