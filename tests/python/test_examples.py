"""The notebooks in runner/python/examples run from their first cell to their last, and stay short."""
import ast
import json
import os
import subprocess
import sys

import pytest

from conftest import sources

NOTEBOOKS = sorted((sources / "runner/python/examples").glob("*.ipynb"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_notebook(file, tmp_path):
    cells = ["".join(c["source"]) for c in json.loads(file.read_text())["cells"] if c["cell_type"] == "code"]
    code = "\n\n".join(cells)
    assert len([line for line in code.splitlines() if line.strip()]) <= 60
    assert max(map(len, code.splitlines())) <= 120 and ast.parse(code)
    picture = tmp_path / "figure.png"
    script = tmp_path / "notebook.py"
    script.write_text(f"{code}\n\nfigure.savefig({str(picture)!r})\n")
    told = subprocess.run([sys.executable, str(script)], cwd=sources, capture_output=True, text=True,
                          env={**os.environ, "MPLBACKEND": "Agg"})
    assert told.returncode == 0, told.stderr
    assert picture.stat().st_size > 10000
    if file.stem == "fit":
        found, measured = (float(part.split(" µm")[0]) for part in told.stdout.split("distance ")[1].split("14 µm: "))
        assert found < measured < 6


def test_there_are_three():
    assert len(NOTEBOOKS) == 3
