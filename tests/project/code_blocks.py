"""code_blocks.py PROGRAMS SOURCE WORK [FILE...]: runs, compiles or reads every block of code in README.md, docs/*.md and
examples/README.md.

    python   runs the blocks of a page, one after the other, in one interpreter
    cpp      compiles and runs a program; each line prints the text in its comment (`...` stands for more digits)
    toml     solves a problem file or a sweep; adds the tables that an incomplete block lacks
    json     reads a document, or one document in each line
    coq      compares with the lemmas that `verify --export-coq` writes
    bibtex   compares names and numbers with CITATION.cff
    console  another test, run_snippets, runs these

Any other block gives a reason after its language: ```sh not run: REASON. Blocks without a language are not code.
PROGRAMS is the build tree. Exit code 1 if a block is wrong; the last line counts the blocks.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path

FENCE = re.compile(r"^```(\S+)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def squeezed(text):
    return " ".join(text.split())


class Runner:
    def __init__(self, programs, source, work):
        self.programs, self.source, self.work = programs, source, work
        self.environment = os.environ | {
            "PATH": f"{programs / 'bin'}:{os.environ['PATH']}", "PYTHONPATH": str(programs / "python"),
            "PYTHONDONTWRITEBYTECODE": "1", "MPLBACKEND": "Agg", "LD_LIBRARY_PATH": str(programs / "library")}
        self.pages = {}  # for each page its Python blocks until now

    def answer(self, *command, **options):
        done = subprocess.run(command, cwd=self.work, env=self.environment, capture_output=True, encoding="utf-8", **options)
        return done.returncode, done.stdout, done.stderr

    def python(self, page, text):
        before = self.pages.get(page, "")
        self.pages[page] = before + text
        code, _, errors = self.answer("/usr/bin/python3", "-c", self.pages[page])
        return errors if code else ""

    def cpp(self, _page, text):
        (self.work / "program.cpp").write_text(text, encoding="utf-8")
        code, _, errors = self.answer("g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "program.cpp", "-o", "program", "-I",
                                      str(self.source), "-I", str(self.source / "library"), "-L",
                                      str(self.programs / "library"), "-lsteadyslide")
        if code:
            return errors
        code, printed, errors = self.answer("./program")
        if code:
            return errors
        said = [comment.strip() for comment in re.findall(r"'\\n';\s*// (.*)", text)]
        for line, comment in zip(printed.splitlines(), said, strict=True):
            if not line.startswith(comment.removesuffix("...")):
                return f"prints {line}, its comment says {comment}"
        return ""

    def toml(self, _page, text):
        if text.lstrip().startswith("samples"):
            text = "[indenter]\n" + text
        data = tomllib.loads(text)
        folder = self.work / "examples"
        if "vary" in data:
            (folder / "block.toml").write_text(text, encoding="utf-8")
            code, _, errors = self.answer("steadyslide", "sweep", str(folder / "block.toml"), "-o", str(folder / "block.csv"))
            return errors if code else ""
        head = "" if "load" in data else 'load = "1"\n'
        tail = "".join(part for name, part in {"half_space": '[half_space]\npoisson = "0.3"\n',
                                               "friction": '[friction]\nvalues = ["0.3"]\n',
                                               "indenter": '[indenter]\nprofile = "0"\n'}.items() if name not in data)
        samples = data.get("indenter", {}).get("samples", {})
        name = samples if isinstance(samples, str) else samples.get("file")
        if name and "\n" not in name:
            file = self.work / name
            if not file.exists():
                example = folder / file.name
                shutil.copy(example if example.exists() else folder / "rough_surface.csv", file)
        (self.work / "block.toml").write_text(head + text + "\n" + tail, encoding="utf-8")
        code, _, errors = self.answer("steadyslide", "solve", "block.toml")
        return errors if code else ""

    def json(self, _page, text):
        try:
            json.loads(text)
        except json.JSONDecodeError:
            try:
                for line in text.splitlines():
                    json.loads(line)
            except json.JSONDecodeError as error:
                return str(error)
        return ""

    def coq(self, _page, text):
        shutil.rmtree(self.work / "lemmas", ignore_errors=True)
        self.answer("steadyslide", "verify", "--export-coq", "lemmas")
        written = squeezed(" ".join(file.read_text(encoding="utf-8") for file in (self.work / "lemmas").glob("*.v")))
        lemmas = re.findall(r"^Lemma.*?\.$", text, re.MULTILINE | re.DOTALL)
        missing = [lemma for lemma in lemmas if squeezed(lemma) not in written]
        return f"not among the lemmas: {missing[0]}" if missing else "" if lemmas else "no lemma"

    def bibtex(self, _page, text):
        known = (self.source / "CITATION.cff").read_text(encoding="utf-8")
        for key, value in re.findall(r"(\w+)\s*= \{([^}]*)\}", text):
            for part in re.split(r"--|, ", value) if key != "title" else [squeezed(value)]:
                if part not in squeezed(known):
                    return f"{key}: {part} is not in CITATION.cff"
        return ""


def main():
    programs, source, work = (Path(one).resolve() for one in sys.argv[1:4])
    files = [Path(one) for one in sys.argv[4:]] or [source / "README.md", *sorted(source.glob("docs/*.md")), source / "examples/README.md"]
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    shutil.copytree(source / "examples", work / "examples")
    runner, counts, wrong = Runner(programs, source, work), Counter(), 0
    for file in files:
        text = file.read_text(encoding="utf-8")
        for block in FENCE.finditer(text):
            language, words, code = block[1], block[2].strip(), block[3]
            place = f"{file.name}:{text[:block.start()].count(chr(10)) + 1}"
            counts[language if not words else "not run"] += 1
            if words:
                problem = "" if re.fullmatch(r"not run: \S.{9,}", words) else f"says no reason: {words}"
            elif language == "console":
                problem = ""
            elif hasattr(Runner, language) and language != "answer":
                try:
                    problem = getattr(runner, language)(file.name, code)
                except ValueError as error:
                    problem = str(error)
            else:
                problem = "neither run nor a reason why not"
            if problem:
                wrong += 1
                print(f"{place}: {language}: {problem}")
    if not counts:
        sys.exit("no block found")
    print(f"{counts.total()} blocks ({', '.join(f'{n} {name}' for name, n in sorted(counts.items()))}), {wrong} wrong")
    sys.exit(wrong > 0)


main()
