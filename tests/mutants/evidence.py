"""Finds the first line in the output of an executable that refutes a mutant. The line is the same on every run and every machine,
except for differences of numbers."""

import re
import signal

LONGEST = 240


def shortened(text):
    text = " ".join(text.split())
    return text if len(text) <= LONGEST else text[: LONGEST - 4].rstrip() + " ..."


def from_claims(lines):
    """Returns the first claim in the output of verify-... that is refuted or undecided, with the reason; None without one."""
    for k, line in enumerate(lines):
        words = line.split()
        if line.startswith(" ") or len(words) < 2 or words[1] not in ("refuted", "undecided"):
            continue
        why = []
        for following in lines[k + 1:]:
            if not following.startswith("    "):
                break
            why.append(following.strip())
        reason = next((text for text in why if text.startswith(("counterexample", "note"))), why[0] if why else "")
        return f"{words[0]} {words[1]}: {reason}" if reason else f"{words[0]} {words[1]}"
    return None


def from_doctest(lines, root):
    """Returns the first failed check in the output of a suite of doctest, and its test case."""
    case = ""
    for k, line in enumerate(lines):
        if line.startswith("TEST CASE:"):
            case = line.removeprefix("TEST CASE:").strip()
        found = re.match(r"(.*?):\d+: (?:FATAL )?ERROR: (.*)", line)
        if not found:
            continue
        place = found.group(1).removeprefix(f"{root}/")
        what = found.group(2).removesuffix(" is NOT correct!")
        values = lines[k + 1].strip() if k + 1 < len(lines) else ""
        if values.startswith("values:"):
            what += "; " + values
        elif what.endswith(":") or "exception" in what:
            what += " " + values
        return f"{place}, '{case}': {what}"
    return None


def first_refuting_line(output, code, root):
    lines = re.sub(r"\x1b\[[0-9;]*m", "", output).splitlines()
    found = from_claims(lines) or from_doctest(lines, root)
    if found is None and code < 0:
        found = f"ended by {signal.Signals(-code).name}"
    if found is None:
        last = next((line for line in reversed(lines) if line.strip()), "")
        found = f"exit code {code}: {last}"
    return shortened(found.replace(f"{root}/", ""))
