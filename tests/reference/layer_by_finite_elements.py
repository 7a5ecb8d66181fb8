"""Contact on a layer, with a friction jump, by finite elements and by steadyslide: the difference falls with the first order.

It compares the load share under the first coating. Exit code 77 without GetFEM (python3-getfem++).
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
    share = solved["resultants"]["load_share"][0]["value"]
    script = os.path.join(PEERS, "finite_element.py")
    off = [abs(output_of(sys.executable, script, str(n), THICKNESS)["share"] - share) for n in MESHES]
    for n, error in zip(MESHES, off):
        print(f"{n:4} elements under [-1, 1]: {error:.2e} from {share}")
    orders = [math.log2(a / b) for a, b in zip(off, off[1:])]
    print("orders", [round(order, 2) for order in orders])
    half_plane = abs(output_of(sys.executable, script, str(MESHES[-1]))["share"] - share)
    print(f"without a layer: {half_plane:.2e}")
    return 0 if off[-1] < 3e-4 and all(0.8 < order < 1.5 for order in orders) and half_plane > 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
