"""check_counts.py VERIFY PAGES: the counts on the site's pages must be those of `verify --format json`."""

import json
import re
import sys
from pathlib import Path

found = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
for page, key in (("entries", "counts"), ("statements", "statement_counts")):
    text = Path(sys.argv[2], f"{page}.html").read_text(encoding="utf-8").split("Made by")[0]
    said = {verdict: int(n) for n, verdict in re.findall(r"(\d+) (proved, restricted|proved, as reconstructed|proved|supported|undecided|refuted)\b", text)}
    if not said or found.get(key, said) != said:
        sys.exit(f"{page}.html says {said}, the ledger {found.get(key)}")
