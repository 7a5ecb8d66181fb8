"""Configuration of Sphinx for the site. docs/site/build calls Sphinx after stage.py and generate.py have written the pages."""

import os
import sys
from pathlib import Path

here = Path(__file__).parent
sys.path[:0] = [str(here), os.environ["STEADYSLIDE_PYTHON"]]

project = "steadyslide"
author = "The steadyslide contributors"
copyright = "the steadyslide contributors; GPL-3.0-or-later"
release = os.environ["STEADYSLIDE_VERSION"]

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "typeset", "mend"]
root_doc = "index"
highlight_language = "none"

# Anchors have the form of GitHub's; formulas stand between dollars.
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath"]
myst_dmath_double_inline = True

breathe_projects = {"steadyslide": os.environ["STEADYSLIDE_DOXYGEN"]}
breathe_default_project = "steadyslide"
autodoc_member_order = "bysource"
autodoc_typehints = "none"

html_theme = "furo"
html_title = f"steadyslide {release}"
templates_path = [str(here / "templates")]
html_static_path = [str(here / "static")]
html_css_files = ["katex/katex.min.css", "site.css"]
html_favicon = str(here / "static/favicon.svg")
html_copy_source = False
html_show_sourcelink = False
pygments_style = "xcode"
