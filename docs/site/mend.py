"""What Debian's furo and Sphinx leave to mend: pages that are opened as files, read with a keyboard or by a screen reader."""

import re
from pathlib import Path

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")


def mend_page(_app, _page, _template, context, _doctree):
    # A module of JavaScript, which a browser does not load as a plain script. It only turns colours by hand and marks headings.
    context["script_files"] = [script for script in context["script_files"] if "furo.js" not in script]
    # A heading has a level; what scrolls sideways can be reached with the keyboard.
    if "furo_navigation_tree" in context:
        context["furo_navigation_tree"] = context["furo_navigation_tree"].replace('role="heading"', 'role="heading" aria-level="2"')
    if "body" in context:
        body = context["body"].replace("<pre>", '<pre tabindex="0">')
        context["body"] = re.sub(r'<div class="([^"]*\b(?:equation|table-wrapper)\b)', r'<div tabindex="0" class="\1', body)


def mend_styles(app, exception):
    # A sheet is asked for under a web server's /javascript: it comes along.
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
