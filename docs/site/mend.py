"""Mends pages of Debian's furo and Sphinx for readers who open them as files, use a keyboard or a screen reader."""

import re
from pathlib import Path

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")


def mend_page(_app, _page, _template, context, _doctree):
    # A browser does not load a JavaScript module from a file. This module only switches colours and marks headings.
    context["script_files"] = [script for script in context["script_files"] if "furo.js" not in script]
    # Headings get a level; boxes that scroll sideways can be reached with the keyboard.
    if "furo_navigation_tree" in context:
        context["furo_navigation_tree"] = context["furo_navigation_tree"].replace('role="heading"', 'role="heading" aria-level="2"')
    if "body" in context:
        body = context["body"].replace("<pre>", '<pre tabindex="0">')
        context["body"] = re.sub(r'<div class="([^"]*\b(?:equation|table-wrapper)\b)', r'<div tabindex="0" class="\1', body)


def mend_styles(app, exception):
    # A page loads a style sheet from a web server's /javascript: copy it.
    if exception or app.builder.format != "html":
        return
    sheet = Path(app.outdir) / "_static" / "styles" / "furo.css"
    text = sheet.read_text(encoding="utf-8")
    asked = "@import url(/javascript/normalize.css/normalize.css);"
    sheet.write_text(text.replace(asked, NORMALIZE.read_text(encoding="utf-8")), encoding="utf-8")


def setup(app):
    app.connect("html-page-context", mend_page, priority=900)
    app.connect("build-finished", mend_styles)
    return {"parallel_read_safe": True}
