"""Runs of the program beside runs of the package."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

os.environ.setdefault("PYTHONDONTWRITEBYTECODE", "1")
sources = Path(__file__).resolve().parents[2]
scenarios = sources / "scenarios"


@pytest.fixture(scope="session")
def program():
    import morula
    return morula.program()


@pytest.fixture(scope="session")
def stored(program, tmp_path_factory):
    """stored("thesis/unique-four", "--seed=2") runs the scenario with the program and returns its database."""
    known = {}

    def run(name, *words):
        if (name, words) not in known:
            folder = tmp_path_factory.mktemp("run")
            words_ = ["--no-pictures", "--no-check", "--quiet", f"--out={folder}", *words]
            subprocess.run([program, "run", scenarios / f"{name}.yaml", *words_], check=True, capture_output=True)
            (known[name, words],) = folder.rglob("*.db")
        return str(known[name, words])
    return run
