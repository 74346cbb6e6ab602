#!/usr/bin/env python3
"""Certified enclosures beside Arb, in one run: prints a table of ratios.

    python3 -m venv venv && venv/bin/pip install python-flint
    cargo build --release -p mdr-analytic --example stopwatch
    venv/bin/python scripts/beside_arb.py target/release/examples/stopwatch [ROUNDS]

Both sides work at the bits of the digits asked for, give an enclosure and no decimals, and are timed by processor time,
taking turns: the least of ROUNDS (default 7) rounds of five series each. Arb is asked as a good user would: by
gamma_fmpq for a rational n, which uses its short numbers and constants kept from earlier calls, by gamma otherwise; the
critical state with a power by a rational number where there is a faster one. The time of an operation includes the
0.1 microseconds or so that a call from Python takes.
"""

import subprocess
import sys
import time

import flint
from flint import arb, ctx, fmpq

RATIONALS = ["3/10", "7/5", "1/4", "1/3"]
DIGITS = {50: 2000, 200: 500, 1000: 40, 10000: 2}


def gammas(n):
    return arb.gamma_fmpq((n + 2) / 2) / arb.gamma_fmpq((n + 1) / 2) * arb.pi().sqrt()


def irrational(n):
    return (n / 2 + 1).gamma() / ((n + 1) / 2).gamma() * arb.pi().sqrt()


def power(x, q):
    """x^q by the fastest of Arb's functions."""
    numerator, denominator = int(q.p), int(q.q)
    if denominator > 64:
        return x ** arb(q)
    x = x ** numerator
    return x if denominator == 1 else x.sqrt() if denominator == 2 else x.root(denominator)


def critical(n, c, e, w):
    kappa = gammas(n)
    edge = arb.pi() * (w / (2 * e))
    root = power((edge / (kappa * (n * c)) ** 2), 1 / (2 * n - 1))
    product = (edge * root).sqrt()
    return kappa, root, product * ((1 - 2 * n) / n), product * root * (-2 * (2 * n + 1) / (n + 1) * e)


def tasks(n):
    exact = fmpq(*map(int, n.split("/")))
    inputs = fmpq(3, 2), fmpq(10**6), fmpq(1, 20)
    upper = (exact + 2) / 2
    root = arb(2).sqrt() * exact
    return {
        "kappa": lambda: gammas(exact),
        "one gamma": lambda: arb.gamma_fmpq(upper),
        "critical": lambda: critical(exact, *inputs),
        "irrational": lambda: irrational(root),
    }


def timed(work, loops):
    best = float("inf")
    for _ in range(5):
        begin = time.thread_time()
        for _ in range(loops):
            work()
        best = min(best, (time.thread_time() - begin) / loops)
    return best * 1e6


def main():
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    ours = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def asked(task, n, digits, loops):
        print(task, n, digits, loops, file=ours.stdin, flush=True)
        return float(ours.stdout.readline())

    print(f"python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}; microseconds, and Arb's over ours")
    print("task | n | digits | ours | Arb | ratio | over one gamma of Arb | with decimals")
    for digits, loops in DIGITS.items():
        ctx.prec = -(-digits * 3402 // 1024)
        for n in RATIONALS:
            arbs = tasks(n)
            for task in ["kappa", "critical"] + (["irrational"] if n == RATIONALS[0] else []):
                few = max(1, loops // 20) if task == "irrational" and digits > 1000 else loops
                here = there = one = decimals = float("inf")
                for _ in range(rounds if digits < 10000 else 3):
                    here = min(here, asked(task, n, digits, few))
                    there = min(there, timed(arbs[task], few))
                    one = min(one, timed(arbs["one gamma"], few))
                    if task != "irrational":
                        decimals = min(decimals, asked(f"{task}-decimals", n, digits, few))
                print(f"{task} | {n} | {digits} | {here:.2f} | {there:.2f} | {there / here:.2f}"
                      f" | {one / here:.2f} | {decimals:.2f}", flush=True)
    ours.stdin.close()
    ours.wait()


if __name__ == "__main__":
    main()
