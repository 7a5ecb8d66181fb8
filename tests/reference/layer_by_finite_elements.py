"""Contact on a layer, with a friction jump, by finite elements and by steadyslide: the difference falls with the first order.

It compares the load share under the first coating, and the approach. Exit code 77 without GetFEM (python3-getfem++).
"""

import json
import math
import os
import subprocess
import sys

PEERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "peers")
THICKNESS, MESHES = "0.5", (20, 40, 80)


def output_of(*command):
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def main():
    try:
        import getfem  # noqa: F401  the other script needs it
    except ImportError:
        print("GetFEM is missing")
        return 77
    solved = output_of(os.environ["STEADYSLIDE"], "solve", os.path.join(PEERS, "layer.toml"), "--format", "json")
    share, approach = solved["resultants"]["load_share"][0]["value"], solved["resultants"]["approach"]["value"]
    script = os.path.join(PEERS, "finite_element.py")
    found = [output_of(sys.executable, script, str(n), THICKNESS) for n in MESHES]
    off = [abs(each["share"] - share) for each in found]
    sunk = [abs(each["approach"] - approach) for each in found]
    for n, error, depth in zip(MESHES, off, sunk):
        print(f"{n:4} elements under [-1, 1]: share {error:.2e} from {share}, approach {depth:.2e} from {approach}")
    orders = [math.log2(a / b) for a, b in zip(off, off[1:])]
    print("orders", [round(order, 2) for order in orders])
    half_plane = abs(output_of(sys.executable, script, str(MESHES[-1]))["share"] - share)
    print(f"without a layer: {half_plane:.2e}")
    return 0 if off[-1] < 3e-4 and sunk[-1] < 2e-6 and sunk[-1] < sunk[-2] / 2 and all(0.8 < order < 1.5 for order in orders) and half_plane > 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
