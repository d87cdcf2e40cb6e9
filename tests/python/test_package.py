"""What people get, and what they are told."""
import gc
import inspect
import os
import pickle
import subprocess
import sys
import threading
import time

import morula
import numpy as np
import pandas
import pytest

from conftest import scenarios

FOUR = scenarios / "thesis/unique-four.yaml"
GENES = ("morula: 1\nname: genes\nseed: 1\ndna: |\n  START: a\n  g(divide|a)\n  k(a|a)\n"
         "cycle: {length: 1}\nstop: {cycles: 3}\n")


@pytest.fixture(scope="module")
def four():
    return morula.run(FOUR)


def test_tables_and_surface(four):
    cells = four.cells
    assert list(cells.path) == ["AA", "AB", "BA", "BB"] and cells.attrs["units"]["volume"] == "length³"
    assert cells.neighbours.dtype == np.int64 and cells.volume.dtype == float
    assert list(four.lineage.fate) == ["divided"] * 3 + ["alive"] * 4
    assert four.lineage.parent[0] is None and four.lineage.parent[1] == ""
    vertices, triangles, cell, start = four.surface
    assert vertices.shape == (4 * 162, 3) and triangles.shape == (4 * 320, 3) and triangles.dtype == np.int32
    assert list(start) == [0, 162, 324, 486, 648] and list(np.bincount(cell)) == [162] * 4
    corners = vertices[triangles]
    volumes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert np.bincount(cell[triangles[:, 0]], volumes) == pytest.approx(cells.volume.to_numpy(), rel=1e-9)
    assert four.measure("cell.volume") == pytest.approx(cells.volume.to_numpy(), rel=0, abs=0)
    assert four.measure("cells") == 4 and four.measure("count of a4") == 1
    assert np.isnan(four.measure("volume of a4")).sum() == 3
    assert list(four.measures("energy").columns) == ["time", "energy"] and len(four.measures()) == 25
    assert set(four.contacts.columns) >= {"time", "a", "b", "area"}


def test_cells_by_name():
    named = FOUR.read_text() + "\nnames: {cells: {A: AB, B: P1}, daughters: [a, p]}\n"
    run = morula.run(named)
    volumes = run.measure("cell.volume")
    assert list(run.cells.path) == ["AA", "AB", "BA", "BB"]
    assert run.measure("count of clone P1") == 2 and run.measure("count of cell ABa") == 1
    by_name = run.measure("cell.volume of cell ABp")
    assert by_name[1] == volumes[1] and np.isnan(np.delete(by_name, 1)).all()
    x = run.cells[["x", "y", "z"]].to_numpy()
    assert run.measure("distance cell ABa cell P1p") == pytest.approx(np.linalg.norm(x[0] - x[3]), rel=1e-12)
    over_time = run.measures("count of clone P1")
    assert over_time["count of clone P1"].iloc[-1] == 2 and over_time["count of clone P1"].notna().all()
    for wrong, why in (("count of cell Q", "no cell is called 'Q'"), ("count of skni", "'skni' is neither")):
        with pytest.raises(morula.InputError, match=why):
            run.measure(wrong)


def test_copies(four):
    before = four.measure("cell.volume")
    four.surface.vertices[:] = 0
    four.measure("cell.volume")[:] = 0
    four.cells["volume"] = 0
    assert np.array_equal(four.measure("cell.volume"), before)


def test_arrays_outlive_their_organism():
    run = morula.Simulator(FOUR).step(8)
    surface, volumes = run.surface, run.cells
    del run
    gc.collect()
    assert np.isfinite(surface.vertices).all() and volumes.volume[0] > 0


def test_genes_alone():
    run = morula.run(GENES)
    assert len(run.lineage) == 15 and run.cells.empty and run.surface.vertices.shape == (0, 3)
    assert list(run.cells.columns)[:2] == ["time", "path"]
    assert run._repr_png_().startswith(b"\x89PNG")


def test_measures_that_are_not_recorded():
    run = morula.run(FOUR, set={"record.measures": ["membrane_energy"], "stop.cycles": 1})
    table = run.measures("membrane_energy", "cells")
    assert table.membrane_energy.notna().all() and len(table) == 5 and list(table.cells) == [1, 1, 1, 1, 2]
    again = morula.run(FOUR, set={"stop.cycles": 1}).measures("cells", "membrane_energy", "count of a4")
    assert np.array_equal(again.membrane_energy, table.membrane_energy) and again["count of a4"].sum() == 0
    assert again.attrs["units"]["membrane_energy"] == "force·length"


def test_measures_beside_those_that_a_reference_needs(tmp_path):
    (tmp_path / "a.yaml").write_text(
        "morula: 1\nname: a\nseed: 1\ndna: |\n  START: a\n  g(a|a)\nstop: {time: 1}\n"
        "cells: [{at: [0, 0, 0]}, {at: [3, 0, 0]}, {at: [0, 3, 0]}]\nphysics: {time_step: 0.0078125, cell: {model: sphere}}\n"
        "check: {reference: {positions: {AA: [0, 0, 0], AB: [3, 0, 0], B: [0, 3, 0]}}}\n"
        "record: {every: 0.5, measures: [position_rmsd]}\n")
    table = morula.run(tmp_path / "a.yaml").measures("mean_overlap", "position_rmsd")
    assert len(table) == 3 and table.mean_overlap.notna().all() and table.position_rmsd.notna().all()


def test_picture(four, tmp_path):
    assert four.picture(tmp_path / "a.png", colour="clone", size=128) is None
    assert four.picture(colour="clone", size=128) == (tmp_path / "a.png").read_bytes()
    assert four._repr_png_()[:4] == b"\x89PNG" and four._repr_png_() == four._repr_png_()


def test_help():
    public = [f for owner in (morula, morula.Simulator, morula.Stored) for n, f in vars(owner).items()
              if not n.startswith("_") and (inspect.isfunction(f) or isinstance(f, property) or inspect.isclass(f))]
    assert len(public) > 30 and all(inspect.getdoc(f) for f in public)
    stub = open(os.path.join(os.path.dirname(morula.__file__), "_morula.pyi")).read()
    compile(stub, "stub", "exec")
    assert "def measure(self, arg0: str) -> object" in stub


WRONG = [  # call, error, part of the text
    (lambda: morula.run("no.yaml"), morula.FileError, "no.yaml"),
    (lambda: morula.run(scenarios), morula.FileError, "scenarios"),
    (lambda: morula.run(""), morula.FileError, ""),
    (lambda: morula.run(None), TypeError, "scenario: None is not a str or bytes or PathLike"),
    (lambda: morula.run(3), TypeError, "scenario: 3 is not a str"),
    (lambda: morula.run("a\0b"), morula.InputError, "the name of a file holds no character 0"),
    (lambda: morula.run("a\udcff.yaml"), morula.FileError, r"'a\xff.yaml' cannot be read"),
    (lambda: morula.run(), TypeError, "scenario"),
    (lambda: morula.run(FOUR, 7), TypeError, "positional"),
    (lambda: morula.run(FOUR, sed=7), TypeError, "sed"),
    (lambda: morula.run(FOUR, seed=-1), morula.InputError, "seed: -1 is out of range; needs 0 to 9223372036854775807"),
    (lambda: morula.run(FOUR, seed=1.5), TypeError, "seed: 1.5 is not a whole number"),
    (lambda: morula.run(FOUR, seed="1"), TypeError, "seed: '1' is not a whole number"),
    (lambda: morula.run(FOUR, seed=2**70), morula.InputError, "seed: 1180591620717411303424 is out of range"),
    (lambda: morula.run(FOUR, seed=1, set={"seed": 2}), morula.InputError, "given twice"),
    (lambda: morula.run(FOUR, threads=0), morula.InputError, "threads: 0 is out of range; needs 1 to 1024"),
    (lambda: morula.run(FOUR, threads=10**30), morula.InputError, f"threads: {10**30} is out of range"),
    (lambda: morula.run(FOUR, threads="2"), TypeError, "threads: '2' is not a whole number"),
    (lambda: morula.run(FOUR, set={"physics.drg": 5}), morula.InputError,
     "--set physics.drg: unknown key; did you mean drag?"),
    (lambda: morula.run(FOUR, set={"physics.drag": -5}), morula.InputError, "physics.drag"),
    (lambda: morula.run(FOUR, set={"physics.drag": "fast"}), morula.InputError, "physics.drag"),
    (lambda: morula.run(FOUR, set={"physics.drag": float("nan")}), morula.InputError, "physics.drag"),
    (lambda: morula.run(FOUR, set={"": 5}), morula.InputError, "is not an assignment"),
    (lambda: morula.run(FOUR, set={"stop": {1, 2}}), TypeError, "set stop: {1, 2} is not a number, text, list or dict"),
    (lambda: morula.run(FOUR, set={"stop": {"cycles": 1j}}), TypeError, "is not a number, text"),
    (lambda: morula.run(FOUR, set={"stop.cycles": float("inf")}), morula.InputError, "'Infinity' is not a number"),
    (lambda: morula.run(FOUR, set={"stop.time": np.ones(2)}), morula.InputError, "stop.time: is a list"),
    (lambda: morula.run(FOUR, set={5: 3}), morula.InputError, "--set 5: unknown key"),
    (lambda: morula.run(FOUR, set=["physics.drag"]), TypeError, "set: ['physics.drag'] is not a dict; needs one, as {"),
    (lambda: morula.run(FOUR, set="physics.drag=5"), TypeError, "set: 'physics.drag=5' is not a dict"),
    (lambda: morula.run(FOUR, set={"physics.time_step": 1.0}), morula.InputError, "physics.time_step"),
    (lambda: morula.run("morula: 1\nname: x\n"), morula.InputError, "scenario:"),
    (lambda: morula.run("a: [\n"), morula.InputError, "scenario:"),
    (lambda: morula.run("\0\n\xff"), morula.InputError, ""),
    (lambda: morula.run(scenarios / "policies/clones.study.yaml"), morula.InputError, "is a study, not a scenario"),
    (lambda: morula.run(__file__), morula.InputError, "test_package.py"),
    (lambda: morula.Simulator(GENES).step(-1), morula.InputError, "steps: -1 is out of range; needs 0 to"),
    (lambda: morula.Simulator(GENES).step(0.5), TypeError, "steps: 0.5 is not a whole number"),
    (lambda: morula.Simulator(GENES).step(None), TypeError, "steps: None is not a whole number"),
    (lambda: morula.Simulator(GENES).run(until="end"), TypeError, "until: 'end' is not a number"),
    (lambda: morula.Simulator(GENES).run(until=1j), TypeError, "until: 1j is not a number"),
    (lambda: morula.Simulator(GENES).run(until=float("nan")), morula.InputError, "until: NaN is not a time"),
    (lambda: setattr(morula.Simulator(GENES), "time", 2), AttributeError, "no setter"),
    (lambda: morula.Simulator(GENES).table(3), TypeError, "name: 3 is not a str"),
    (lambda: morula.Simulator(GENES).measure(None), TypeError, "name: None is not a str"),
    (lambda: morula.Simulator(GENES).measure("a\udcff"), morula.InputError, "is not Unicode"),
    (lambda: morula.Simulator(GENES).measures(3), TypeError, "name: 3 is not a str"),
    (lambda: morula.Simulator(GENES).table("cells"), morula.InputError, "there is no table 'cells'; needs one of cell"),
    (lambda: morula.Simulator(GENES).cel, AttributeError, "there is no table 'cel'"),
    (lambda: morula.Simulator(GENES).measure("weight"), morula.InputError, "weight"),
    (lambda: morula.Simulator(GENES).measure("volume of"), morula.InputError, "volume of"),
    (lambda: morula.Simulator(FOUR).measure("contact.area"), morula.InputError, ""),
    (lambda: morula.Simulator(GENES).measures("weight"), morula.InputError, "weight"),
    (lambda: morula.Simulator(FOUR).measures("cell.volume"), morula.InputError, "measures a cell"),
    (lambda: morula.Simulator(GENES).restore(b""), morula.InputError, "no saved state"),
    (lambda: morula.Simulator(GENES).restore(b"SQLite format 3\0" + bytes(4096)), morula.InputError, "no saved state"),
    (lambda: morula.Simulator(GENES).restore(morula.Simulator(FOUR).save()), morula.InputError,
     "another scenario, seed or Morula; needs one of 'genes', seed 1"),
    (lambda: morula.Simulator(GENES).restore(morula.Simulator(GENES).save()[:-700]), morula.InputError,
     "no saved state"),
    (lambda: morula.Simulator(GENES).restore(7), TypeError, "state: 7 is not a bytes or bytearray or memoryview"),
    (lambda: morula.Simulator(GENES).restore("abc"), TypeError, "state: 'abc' is not a bytes"),
    (lambda: pickle.loads(pickle.dumps(morula.Simulator(GENES))[:-50]), pickle.UnpicklingError, "truncated"),
    (lambda: morula.Simulator(FOUR).picture(size=10**6), morula.InputError,
     "size: 1000000 is out of range; needs 64 to 4096"),
    (lambda: morula.Simulator(FOUR).picture(size="big"), TypeError, "size: 'big' is not a whole number"),
    (lambda: morula.Simulator(FOUR).picture(colour=3), TypeError, "colour: 3 is not a str"),
    (lambda: morula.Simulator(FOUR).picture(colour="weight"), morula.InputError, "weight"),
    (lambda: morula.Simulator(FOUR).picture(b"a.png"), TypeError, "file: b'a.png' is not a str or PathLike"),
    (lambda: morula.Simulator(FOUR).picture("a.jpg", size=64), morula.InputError, "ends in .png"),
    (lambda: morula.Simulator(FOUR).picture("/no/folder/a.png", size=64), OSError, "/no/folder/a.png"),
    (lambda: morula.Simulator(FOUR).save_scenario("/no/folder/a.yaml"), OSError, "/no/folder"),
    (lambda: morula.open("no.db"), morula.FileError, "no.db"),
    (lambda: morula.open(3), TypeError, "file: 3 is not a str or PathLike"),
    (lambda: morula.open(scenarios), morula.FileError, "the path is a directory"),
    (lambda: morula.open(FOUR), morula.FileError, "unique-four.yaml"),
    (lambda: repr(morula.Simulator.__new__(morula.Simulator)), AttributeError, "a simulator has no '_organism'"),
    (lambda: morula.Stored.__new__(morula.Stored).cell, AttributeError, "results have no 'tables'"),
]


@pytest.mark.parametrize("call, error, text", WRONG)
def test_wrong_calls(call, error, text):
    with pytest.raises(error) as told:
        call()
    assert text in str(told.value)
    assert "pybind" not in str(told.value) and "arguments. The following" not in str(told.value)
    assert type(pickle.loads(pickle.dumps(told.value))) is type(told.value)


def test_a_scenario_that_fails(program, tmp_path):
    failing = scenarios / "hard/impact-through.yaml"
    run = morula.Simulator(failing)
    with pytest.raises(morula.NumericalError) as told:
        run.run()
    out = subprocess.run([program, "run", str(failing), "--no-pictures", "--no-check", "--out", str(tmp_path)],
                         capture_output=True, text=True)
    assert out.returncode == 4 and str(told.value) in " ".join((out.stderr + out.stdout).split())
    with pytest.raises(morula.NumericalError):
        run.step()
    assert len(run.lineage) >= 1 and len(run.surface.vertices) > 0
    for question in (lambda: run.hash, run.save):
        with pytest.raises(morula.InputError, match="a run that failed"):
            question()


def test_a_second_thread_is_refused():
    run = morula.Simulator(FOUR)
    refused = []

    def insist(action, until):
        while not until():
            try:
                action()
            except RuntimeError as error:
                assert "another thread uses this simulator" in str(error)
                refused.append(error)
    done = []
    thread = threading.Thread(target=insist, args=(lambda: done.append(run.run().hash), lambda: done))
    thread.start()
    insist(lambda: run.hash, lambda: not thread.is_alive())
    thread.join()
    assert refused and run.finished and done == [run.hash]


def test_the_interpreter_may_end_at_any_time():
    for ending in ("", "import os; os.kill(os.getpid(), 9)", "raise SystemExit(3)"):
        code = (f"import morula, threading, time; s = morula.Simulator({str(FOUR)!r})\n"
                f"t = threading.Thread(target=s.run, daemon=True); t.start(); time.sleep(.05)\n{ending}")
        code = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        assert code.returncode in (0, -9, 3) and "terminate" not in code.stderr and "Fatal" not in code.stderr


def test_a_full_disk(four, tmp_path):
    if not os.path.exists("/dev/full"):
        pytest.skip("no /dev/full")
    full = tmp_path / "full.png"
    full.symlink_to("/dev/full")
    for write in (four.save_scenario, four.picture):
        with pytest.raises(OSError, match="No space left"):
            write(full)


def test_warnings():
    stem = ("morula: 1\nname: stem\ndna: |\n  START: s\n  keep(s|s, !B)\n  div(divide|s, !B)\n  gone(die|s, B)\n"
            "stop: {time: 130}\n")
    with pytest.warns(UserWarning, match="on its line of descent"):
        morula.Simulator(stem)


def test_without_pandas(monkeypatch):
    code = (f"import sys; sys.modules['pandas'] = None\nimport morula; r = morula.run({GENES!r})\n"
            "assert type(r.lineage) is dict and len(r.lineage['path']) == 15, r.lineage\n"
            "assert r.measures('cells')['cells'][-1] == 8")
    subprocess.run([sys.executable, "-c", code], check=True)


def test_speed():
    """Bounds are far above what an idle machine takes: runner/python/README.md has the figures."""
    begin = time.perf_counter()
    for _ in range(10):
        morula.Simulator(FOUR)
    assert (time.perf_counter() - begin) / 10 < 0.1
