#!/usr/bin/env python3
"""Tests that the programs answer changed problem files and certificates, and never crash.

Makes `count` files from the seed `first` on. Each is an example, a problem of tests/checker or a stored certificate with one to four
random changes: of bytes, of lines, of numbers and texts; lines of other files are put in. Problem files go to the commands of
steadyslide, certificates to steadyslide-check. Required are

- exit code 0, 1 or 2, within `--seconds` of processor time and four gigabytes of memory. The largest work that is allowed, 4194304 cells
  or the largest stress with 50 digits, takes about a minute;
- with code 2: nothing on the standard output, and one line that names the program and has no control character;
- with code 0 of solve: JSON, and no number of it is infinite or not a number.

Prints the seed and the command of each failure, and writes its file into `--folder`. A sanitizer in the programs makes the test
stricter. The test misses wrong numbers; the laws and comparisons look for these.
"""

import argparse
import collections
import json
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMBERS = ("0", "-1", "1", "-0", "1e400", "1e-400", "1/0", "1/3", "-7/3", "nan", "inf", "0.5", "1e9", "-1e-9", "1e17", "", " ", "x", "2^31",
           "9" * 400, "0." + "3" * 400, "0x10", "1_000", "∞", "\\u0000", "1,5")
COMMANDS = (("exponents",), ("solve", "--format", "json"), ("solve", "--format", "json", "--method", "variational", "--cells", "64"),
            ("solve", "--format", "json", "--max-stress"), ("solve", "--format", "json", "--both-directions"),
            ("solve", "--format", "csv", "--samples", "5"))
WEAR = ("wear", "--distance", "1/100", "--cells", "32")


def changed_bytes(draw, text, _):
    data = bytearray(text, "utf-8", "surrogateescape")
    place = draw.randrange(len(data) + 1)
    if draw.random() < 0.5:
        data[place:place] = bytes(draw.randrange(256) for _ in range(draw.randint(1, 4)))
    else:
        del data[place:place + draw.randint(1, 8)]
    return data.decode("utf-8", "surrogateescape")


def changed_lines(draw, text, other):
    lines, others = text.splitlines(True), other.splitlines(True)
    place = draw.randrange(len(lines) + 1)
    kind = draw.randrange(4)
    if kind == 0:
        del lines[place:place + draw.randint(1, 3)]
    elif kind == 1:
        lines[place:place] = lines[place:place + 1]
    elif kind == 2:
        lines[place:place] = draw.sample(others, min(2, len(others)))
    else:
        draw.shuffle(lines)
    return "".join(lines)


def changed_number(draw, text, _):
    numbers = list(re.finditer(r"-?\d[\d./e+-]*", text))
    if not numbers:
        return text
    chosen = draw.choice(numbers)
    return text[:chosen.start()] + draw.choice((*NUMBERS, draw.choice(numbers).group())) + text[chosen.end():]


def other_number(draw, text, _):
    """A number that the reader accepts, so that the solvers are reached."""
    numbers = list(re.finditer(r"(?<![\w^.])-?\d+(\.\d+)?(/\d+)?(?![\w.])", text))
    if not numbers:
        return text
    chosen = draw.choice(numbers)
    new = draw.choice((draw.choice(numbers).group(), f"{draw.uniform(-2, 2):.{draw.randint(0, 12)}f}",
                       f"{chosen.group()}{draw.randint(0, 99)}", f"-{chosen.group()}".replace("--", "")))
    return text[:chosen.start()] + new + text[chosen.end():]


def changed_word(draw, text, other):
    words, others = list(re.finditer(r"\"[^\"]*\"|[A-Za-z_]+|\[.*?\]|\{.*?\}", text)), re.findall(r"\"[^\"]*\"|[A-Za-z_]+|\[.*?\]|\{.*?\}", other)
    if not words or not others:
        return text
    chosen = draw.choice(words)
    return text[:chosen.start()] + draw.choice(others) + text[chosen.end():]


def changed(draw, text, other):
    kinds = (changed_bytes, changed_lines, changed_word, changed_number) if draw.random() < 0.3 else (other_number,)
    for _ in range(draw.choice((1, 1, 2, 4))):
        text = draw.choice(kinds)(draw, text, other)
    return text


def limited(seconds):
    def set_limits():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        # A sanitizer reserves terabytes.
        if not SANITIZED:
            resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    return set_limits


SANITIZED = False


def not_finite(name):
    raise ValueError(f"{name} in the answer")


def fault_of(done, name, is_json):
    """Returns what is wrong with an answer, or None."""
    if done.returncode not in (0, 1, 2):
        return f"exit code {done.returncode}"
    if done.returncode == 2:
        lines = done.stderr.decode("utf-8", "replace").split("\n")
        if done.stdout or len(lines) != 2 or not lines[0].startswith(name + ": "):
            return "a refusal that is not one line"
        if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", lines[0]):
            return "a control character in the message"
    elif done.returncode == 0 and is_json:
        try:
            json.loads(done.stdout, parse_constant=not_finite)
        except ValueError as error:
            return str(error)
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("steadyslide", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("checker", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--seconds", type=int, default=240)
    parser.add_argument("--folder", type=pathlib.Path)
    options = parser.parse_args()
    global SANITIZED
    SANITIZED = b"__asan_init" in pathlib.Path(options.steadyslide).read_bytes()

    def read(pattern):
        return [path.read_text() for path in sorted(ROOT.glob(pattern))]

    problems = read("examples/*.toml") + read("tests/checker/problems/*.toml")
    certificates = read("tests/checker/certificates/*.json")
    codes, faults = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for data in ("rough_surface.csv", "wiper.csv"):
            (folder / data).write_bytes((ROOT / "examples" / data).read_bytes())
        for seed in range(options.first, options.first + options.count):
            draw = random.Random(seed)
            is_certificate = draw.random() < 0.2
            pool = certificates if is_certificate else problems
            text = changed(draw, draw.choice(pool), draw.choice(pool)).encode("utf-8", "surrogateescape")
            file = folder / ("f.json" if is_certificate else "f.toml")
            file.write_bytes(text)
            command = [options.checker, file.name] if is_certificate else [options.steadyslide, *(WEAR if b"[wear]" in text else draw.choice(COMMANDS)), file.name]
            done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=False,
                                  preexec_fn=limited(options.seconds))
            codes[done.returncode] += 1
            fault = fault_of(done, pathlib.Path(command[0]).name, "json" in command)
            if fault:
                faults += 1
                print(f"seed {seed}: {fault}: {' '.join(map(str, command[1:]))}\n  {done.stderr.decode(errors='replace')[:300]}", flush=True)
                if options.folder:
                    options.folder.mkdir(parents=True, exist_ok=True)
                    (options.folder / f"{seed}{file.suffix}").write_bytes(text)
    print(f"{options.count} changed files, {faults} faults; exit codes {dict(sorted(codes.items()))}")
    # If almost all files were refused, the solvers were not reached.
    return 1 if faults or (options.count >= 50 and codes[0] < options.count / 10) else 0


if __name__ == "__main__":
    sys.exit(main())
