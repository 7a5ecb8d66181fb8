"""stage.py TARGET [--explorer]: the pages of the repository as one tree for Sphinx.

Pages in docs/ move to the root of the tree; other pages keep their places. Links are rewritten to the new places, and files that pages
link to are copied. So the site and a checkout have the same text.
"""

import os
import re
import shutil
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
PAGES = ["README.md", "docs/*.md", "examples/README.md", "examples/reference/README.md", "examples/reference/*/README.md", "tests/bench/README.md",
         "CHANGELOG.md", "CONTRIBUTING.md"]
LINK = re.compile(r"(\]\(|^\[[^\]]+\]: )([^)#\s:]+)(#[^)\s]*)?(?=[)\s])", re.MULTILINE)


def staged(path):
    """Returns the place of a repository file in the tree."""
    return path.removeprefix("docs/")


def relinked(page, text, files):
    """Returns the text with its links rewritten. Adds targets that are not pages to `files`."""
    def rewrite(match):
        target = os.path.normpath(os.path.join(os.path.dirname(page), match[2]))
        if (root / target).is_dir() and (root / target / "README.md").exists():
            target += "/README.md"
        if not (root / target).exists():
            return match[0]
        files.add(target)
        return match[1] + os.path.relpath(staged(target), os.path.dirname(staged(page)) or ".") + (match[3] or "")

    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)  # no link in a block of code
    return "".join(part if part.startswith("```") else LINK.sub(rewrite, part) for part in parts)


def shown(text, explorer):
    """Returns the text with the parts for the site alone. In the repository these parts are comments."""
    kinds = "on the site|with the explorer" if explorer else "on the site"
    return re.sub(rf"^<!-- (?:{kinds}):\n(.*?)^-->\n", r"\1", text, flags=re.MULTILINE | re.DOTALL)


def main(target, explorer):
    shutil.rmtree(target, ignore_errors=True)
    files = set()
    pages = [str(path.relative_to(root)) for pattern in PAGES for path in sorted(root.glob(pattern))]
    for page in pages:
        text = relinked(page, shown((root / page).read_text(encoding="utf-8"), explorer), files)
        if page == "docs/index.md":
            text += "\n" + (root / "docs/site/contents.md").read_text(encoding="utf-8")
        place = target / staged(page)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8")
    for file in sorted(files - set(pages)):
        place = target / staged(file)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / file, place)
    shutil.copytree(root / "docs/site/pages", target, dirs_exist_ok=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), "--explorer" in sys.argv)
