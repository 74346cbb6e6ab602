#!/usr/bin/env python3
"""Times of certified paths over measured tables, of one build of the program or of several side by side.

    python3 scripts/tables.py [--passes N] [--rows 30,100,300] PROGRAM [PROGRAM ...]

Prints the least processor time in seconds of each, in runs that take turns, and whether the answers differ.
"""

import argparse
import pathlib
import resource
import subprocess
import tempfile

SCENE = """
[material]
e_star = "1e9"
work_of_adhesion = "0.1"
[profile]
kind = "table"
file = "table.csv"
columns = "r,f"
[control]
kind = "force"
path = {path}
[output]
want = ["{want}"]
digits = 20
"""

# A path that presses 200 nm into a ball of 2 µm and pulls off; its folds alone; and a path that cannot start.
QUESTIONS = {
    "path": ("path", '["2e-5", "-1e-3"]'),
    "folds": ("folds", '["2e-5", "-1e-3"]'),
    "refusal": ("path", '["-1e-3", "0"]'),
}


def table(rows):
    """A paraboloid with a sawtooth of 30 pm from row to row, as of a digitised trace."""
    lines = ["r,f", "nm,nm"]
    for i in range(rows):
        r = 1000 * i / (rows - 1)
        wave = (i % 7 - 3) * 1e-2 if i else 0
        lines.append(f"{r:.6f},{r * r / 4000 + wave:.6f}")
    return "\n".join(lines) + "\n"


def run(program, folder):
    """Processor seconds and what is printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "solve", "scene.toml", "--format", "json"], cwd=folder, capture_output=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, done.stdout + done.stderr


def main():
    """Prints a line for each question and each number of rows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--passes", type=int, default=3)
    parser.add_argument("--rows", default="30,100,300")
    parser.add_argument("programs", nargs="+")
    options = parser.parse_args()
    programs = [str(pathlib.Path(program).resolve()) for program in options.programs]
    print("question  rows  seconds")
    for rows in map(int, options.rows.split(",")):
        for question, (want, path) in QUESTIONS.items():
            with tempfile.TemporaryDirectory() as folder:
                pathlib.Path(folder, "table.csv").write_text(table(rows), encoding="utf-8")
                pathlib.Path(folder, "scene.toml").write_text(SCENE.format(want=want, path=path), encoding="utf-8")
                least = [float("inf")] * len(programs)
                answers = [b""] * len(programs)
                for _ in range(options.passes):
                    for i, program in enumerate(programs):
                        seconds, answers[i] = run(program, folder)
                        least[i] = min(least[i], seconds)
            times = " ".join(f"{seconds:8.2f}" for seconds in least)
            note = "" if len(set(answers)) == 1 else "  answers differ"
            print(f"{question:8} {rows:5} {times}{note}", flush=True)


if __name__ == "__main__":
    main()
