"""Typesets formulas by KaTeX while the site is built. So a page needs no script and no network to show them."""

import json
import re
import shutil
import subprocess
from pathlib import Path

KATEX = Path("/usr/share/javascript/katex")  # Debian's libjs-katex


class Typesetter:
    """One process of node for the whole site. It reads a line and answers with a line."""

    def __init__(self):
        self.process = subprocess.Popen(["node", str(Path(__file__).with_name("typeset.js")), str(KATEX / "katex.js")],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8")

    def html(self, tex, display):
        self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ValueError(f"{answer['error']}; {tex}")
        return answer["html"]


def visit_math(self, node, display=False):
    from docutils import nodes
    if display:
        self.body.append(self.starttag(node, "div", CLASS="equation"))
    self.body.append(self.builder.app.typesetter.html(node.astext(), display))
    if display:
        self.body.append("</div>\n")
    raise nodes.SkipNode


def escape_docstring(_app, _what, _name, _object, _options, lines):
    """Docstrings are plain text: their characters are not reStructuredText."""
    lines[:] = [re.sub(r"([*`|\\]|_\b|(?<=\w):(?=\w))", r"\\\1", line) for line in lines]


def copy_katex(app, exception):
    if exception or app.builder.format != "html":
        return
    target = Path(app.outdir) / "_static" / "katex"
    (target / "fonts").mkdir(parents=True, exist_ok=True)
    shutil.copy(KATEX / "katex.min.css", target)
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "fonts")


def setup(app):
    app.typesetter = Typesetter()
    app.add_html_math_renderer("katex", (visit_math, None), (lambda self, node: visit_math(self, node, True), None))
    app.config.html_math_renderer = "katex"
    app.connect("autodoc-process-docstring", escape_docstring)
    app.connect("build-finished", copy_katex)
    return {"parallel_read_safe": False}
