"""A sweep with Dask: on the processes of this machine, and with the address of a scheduler on a cluster.

    python dask_cluster.py                          # a local cluster
    python dask_cluster.py tcp://scheduler:8786     # a real one, whose workers have mdr installed
"""

import sys

from dask.distributed import Client, LocalCluster

import pool
from pool import curve, fitted, pull_off

import mdr


def sweep(client: Client) -> tuple[list[float], list[mdr.Fit]]:
    """Pull-off forces of cones, and fits of curves: whatever the cluster is."""
    cones = [mdr.Contact(mdr.Cone(slope=slope), e_star=1e6, work_of_adhesion=0.05) for slope in (0.1, 0.2, 0.4)]
    forces = client.map(pull_off, cones, batch_size=100)
    fits = client.map(fitted, [curve(w) for w in (0.03, 0.05)])
    return client.gather(forces), client.gather(fits)


def main() -> None:
    if len(sys.argv) > 1:
        with Client(sys.argv[1]) as client:  # what others run there goes on afterwards
            client.upload_file(pool.__file__)  # its functions, for workers on other machines
            report(*sweep(client))
    else:
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            report(*sweep(client))


def report(forces: list[float], fits: list[mdr.Fit]) -> None:
    print(*(f"{force:.6e} N" for force in forces), *(fit.status for fit in fits))


if __name__ == "__main__":
    main()
