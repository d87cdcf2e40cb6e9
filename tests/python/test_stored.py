"""morula.open: databases of runs and studies."""
import shutil
import subprocess

import morula
import numpy as np
import pytest

from conftest import scenarios

STUDY = """morula-study: 1
name: drag
base: four.yaml
vary:
  drag: {low: {physics.drag: 10}, high: {physics.drag: 20}}
seeds: 1..2
measures: [outermost, energy]
"""


def test_surfaces(tmp_path, program):
    words = ["--set=record.meshes=1", "--set=stop.cycles=2", "--no-pictures", "--no-check", "--quiet", f"--out={tmp_path}"]
    subprocess.run([program, "run", scenarios / "thesis/unique-four.yaml", *words], check=True, capture_output=True)
    (file,) = tmp_path.rglob("*.db")
    run = morula.run(scenarios / "thesis/unique-four.yaml", set={"record.meshes": 1, "stop.cycles": 2})
    results = morula.open(file)
    stored, now = results.surfaces(), run.surface
    assert np.abs(stored.vertices - now.vertices).max() < 1e-4
    for part in ("triangles", "cell", "start"):
        assert np.array_equal(getattr(stored, part), getattr(now, part))
    assert len(results.surfaces(time=0.5).start) == 2
    assert results.sql("SELECT count(*) AS n FROM cell WHERE fate = ?", ["alive"]).n[0] == 4
    assert "cell_sample" in results.tables and "1 runs" in repr(results)
    with pytest.raises(morula.FileError, match="no such column"):
        results.sql("SELECT weight FROM cell")
    with pytest.raises(morula.FileError, match="readonly|read-only"):
        results.sql("DELETE FROM cell")
    with pytest.raises(AttributeError, match="no table 'weights'"):
        results.weights
    with pytest.raises(morula.InputError, match="keeps no surfaces"):
        results.surfaces(time=-1)
    wrong = [(lambda: results.sql(5), TypeError, "query: 5 is not a str"),
             (lambda: results.sql("SELECT ?"), morula.FileError, "bindings"),
             (lambda: results.sql("SELECT 1; SELECT 2"), morula.FileError, "one statement"),
             (lambda: results.surfaces(time="x"), TypeError, "time: 'x' is not a number"),
             (lambda: results.surfaces(run=5), TypeError, "run: 5 is not a str"),
             (lambda: results.surfaces(run="zz"), morula.InputError, "no run whose id begins with 'zz'"),
             (lambda: results.tidy("cells"), morula.InputError, "but of no study"),
             (lambda: results.tidy(5), TypeError, "rows: 5 is not a str")]
    closed = [lambda: results.cell, lambda: results.sql("SELECT 1"), results.surfaces, lambda: results.tables]
    for call, error, text in wrong + [(call, morula.FileError, "closed") for call in closed]:
        if error is morula.FileError and text == "closed":
            results.close()
        with pytest.raises(error) as told:
            call()
        assert text in str(told.value)
    assert "closed" in repr(results)


def test_changed_rows_are_found(stored, tmp_path):
    import sqlite3
    file = tmp_path / "run.db"
    shutil.copy(stored("thesis/unique-four"), file)
    with sqlite3.connect(file) as db:
        db.execute("UPDATE cell_sample SET volume = 1 WHERE path = 'AA'")
    with pytest.raises(morula.FileError, match="cell_sample"):
        morula.open(file)
    assert len(morula.open(file, check=False).cell) == 7


def test_study(tmp_path, program):
    shutil.copy(scenarios / "thesis/unique-four.yaml", tmp_path / "four.yaml")
    (tmp_path / "drag.study.yaml").write_text(STUDY)
    words = ["study", "run", "drag.study.yaml", "--quiet"]
    subprocess.run([program, *words], check=True, cwd=tmp_path, capture_output=True)
    (file,) = tmp_path.rglob("study.db")
    study = morula.open(file)
    assert len(study.run) == 2 and len(study.condition) == 2
    assert set(study.result.measure) >= {"outermost", "energy"}
    assert any("drag" in column for column in study.condition.columns)
    tidy = study.tidy()
    assert len(tidy) == 8 and any("drag" in column for column in tidy.columns)
    with pytest.raises(morula.InputError):
        study.tidy("weights")
