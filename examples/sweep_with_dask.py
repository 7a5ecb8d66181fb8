"""A sweep from Python over the workers of a Dask cluster, here two processes of this machine (python3-distributed).

    python3 examples/sweep_with_dask.py
"""

import steadyslide as ss
from dask.distributed import Client, LocalCluster


def main():
    base = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    vary = {"friction.values[1]": ["0.4", "0.5"], "friction.jumps[0]": ["-0.5", "0", "0.5"]}
    with LocalCluster(n_workers=2, threads_per_worker=1) as cluster, Client(cluster) as client:
        table = ss.sweep(base, vary=vary, columns=["effective_friction"], executor=client.get_executor())
    for friction, jump, effective_friction, failed_condition in table:
        print(friction, jump, effective_friction, failed_condition or "solved")


if __name__ == "__main__":
    main()
