#!/usr/bin/env python3
"""Executes the notebooks of docs/notebooks, and compares what they print with what they hold, or writes it.

    python scripts/notebooks.py            # exit status 1 where a text differs
    python scripts/notebooks.py --write

Needs mdr, numpy and matplotlib, and no Jupyter: a cell is Python, its result the value of its last expression. Pictures are drawn
anew by --write; otherwise it is only compared whether there is one, since their bytes depend on the version of matplotlib.
"""

import ast
import base64
import contextlib
import io
import json
import pathlib
import sys

import matplotlib

matplotlib.use("agg")
from matplotlib import pyplot

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "docs" / "notebooks"


def lines(text):
    return text.splitlines(keepends=True)


def run(source, namespace, count):
    """The outputs of a cell."""
    tree = ast.parse(source)
    last = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, f"cell {count}", "exec"), namespace)
        value = eval(compile(last, f"cell {count}", "eval"), namespace) if last else None
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines(printed.getvalue())})
    for number in pyplot.get_fignums():
        picture = io.BytesIO()
        pyplot.figure(number).savefig(picture, format="png", dpi=80, bbox_inches="tight", metadata={"Software": None})
        data = {"image/png": base64.b64encode(picture.getvalue()).decode(), "text/plain": ["<Figure>"]}
        outputs.append({"data": data, "metadata": {}, "output_type": "display_data"})
    pyplot.close("all")
    if value is not None:
        data = {"text/plain": lines(repr(value))}
        if hasattr(value, "_repr_svg_"):
            data["image/svg+xml"] = lines(value._repr_svg_())
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def texts(outputs):
    """What is compared."""
    return ["".join(output.get("text") or output["data"]["text/plain"]) for output in outputs]


def main():
    write, differ = "--write" in sys.argv[1:], 0
    for path in sorted(FOLDER.glob("*.ipynb")):
        notebook, namespace, count = json.loads(path.read_text("utf-8")), {"__name__": "__main__"}, 0
        for cell in notebook["cells"]:
            if cell["cell_type"] != "code":
                continue
            count += 1
            outputs = run("".join(cell["source"]), namespace, count)
            if texts(outputs) != texts(cell["outputs"]):
                differ += not write
                print(f"{path.name}, cell {count}:", *texts(outputs), "is not what the notebook holds", sep="\n")
            if write:
                cell["outputs"], cell["execution_count"] = outputs, count
        if write:
            path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", "utf-8")
        print(f"{path.name}: {count} cells")
    return differ > 0


if __name__ == "__main__":
    sys.exit(main())
