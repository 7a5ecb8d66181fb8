#!/usr/bin/env python3
"""make_certificates.py MAKE_CERTIFICATE: makes the certificates in certificates/ again, from the files in problems/."""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
DIGITS = {"notch_gap": "30", "notch_tiny_gap": "30", "two_bowls": "8"}
LOADS = {
    "parabola_rough_front": ("0.9", "1.1", "5"),
    "two_bumps": ("0.099", "0.101", "2"),
    "lifted_punch": ("0.98", "1.02", "2"),
    "rounded_wedge": ("0.999", "1.001", "1"),
}
CELLS = {"parabola_rough_front": "64"}


def main():
    for problem in sorted((HERE / "problems").glob("*.toml")):
        name = problem.stem
        options = [("everywhere",)] if name.endswith(".refused") else [(DIGITS[name],)] if name in DIGITS else [()]
        options += [LOADS[name]] if name in LOADS else []
        options += [("cells", CELLS[name])] if name in CELLS else []
        for option in options:
            done = subprocess.run([sys.argv[1], problem, *option], stdout=subprocess.PIPE, text=True, check=True)
            kind = {2: ".cells", 3: ".loads"}.get(len(option), "")
            (HERE / "certificates" / f"{name}{kind}.json").write_text(done.stdout)


if __name__ == "__main__":
    main()
