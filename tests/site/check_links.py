"""check_links.py FOLDER: every link, picture, stylesheet and script of the pages must lead to a file in FOLDER, and to an anchor in
this file. Addresses elsewhere must be well formed. No page may load anything from elsewhere. --control checks pages with faults."""

import re
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loaded, self.without_words = set(), [], [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if "id" in given:
            self.ids.add(given["id"])
        if tag == "a" and "name" in given:
            self.ids.add(given["name"])
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag in ("img", "script", "iframe") and "src" in given or tag == "link" and given.get("rel") == "stylesheet":
            self.loaded.append(given["src"] if "src" in given else given["href"])
        if tag == "img" and not given.get("alt"):
            self.without_words.append(given.get("src"))


def check(folder):
    """Returns the number of links, and one line for each wrong one."""
    folder = folder.resolve()
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    count, wrong = 0, []
    for sheet in folder.rglob("*.css"):
        for address in re.findall(r"url\(['\"]?([^)'\"]+)", sheet.read_text(encoding="utf-8")):
            first = not address.endswith((".woff", ".ttf"))  # a browser uses the first font of several, a .woff2
            if first and not address.startswith(("data:", "#")) and not (sheet.parent / address.split("?")[0]).is_file():
                wrong.append(f"{sheet.relative_to(folder)}: leads nowhere: {address}")
    for path, page in pages.items():
        name = path.relative_to(folder)
        wrong += [f"{name}: a picture without words: {picture}" for picture in page.without_words]
        for link in page.links + page.loaded:
            count += 1
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loaded and parts.scheme != "data":
                    wrong.append(f"{name}: loaded from elsewhere: {link}")
                elif parts.scheme not in ("https", "http", "mailto", "data") or parts.scheme in ("https", "http") and not (
                        "." in parts.netloc and " " not in link):
                    wrong.append(f"{name}: no address: {link}")
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file() or folder not in target.parents:
                wrong.append(f"{name}: leads nowhere: {link}")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].ids:
                wrong.append(f"{name}: no such anchor: {link}")
    return count, wrong


def control():
    """Checks that each fault of a bad page is noticed."""
    bad = {"missing.html": "leads nowhere", "#missing": "no such anchor", "index.html#a": "", "https://nowhere": "no address",
           "../index.html": "leads nowhere", "https://example.org/a": ""}
    with tempfile.TemporaryDirectory() as folder:
        for link, fault in bad.items():
            (Path(folder) / "index.html").write_text(f'<p id="a"><a href="{link}">x</a></p>', encoding="utf-8")
            wrong = check(Path(folder))[1]
            if bool(fault) != bool(wrong) or wrong and fault not in wrong[0]:
                sys.exit(f"control: {link}: {wrong}")
        (Path(folder) / "index.html").write_text('<script src="https://example.org/a.js"></script><img src="">', encoding="utf-8")
        if len(check(Path(folder))[1]) < 2:
            sys.exit("control: a script from elsewhere, a picture without words")


if sys.argv[1] == "--control":
    control()
else:
    number, faults = check(Path(sys.argv[1]))
    if number == 0:
        faults = ["no link found"]
    print(*faults, f"{number} links, {len(faults)} wrong", sep="\n")
    sys.exit(bool(faults))
