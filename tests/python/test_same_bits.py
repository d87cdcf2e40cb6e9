"""Hash, tables and measures are those of the program's database, however the run came about."""
import concurrent.futures
import contextlib
import copy
import ctypes
import multiprocessing
import os
import pickle
import signal
import subprocess
import threading

import morula
import numpy as np
import pandas
import pytest

from conftest import scenarios

# Bodies, spheres, connections, variation, a start of several cells, genes alone.
SHORT = ["thesis/unique-four", "organisms/spheres", "connections/pairs", "division/variation", "bullet/pressed-pair",
         "worm/lineage"]


def path(name):
    return scenarios / f"{name}.yaml"


def assert_equals_database(run, file):
    results = morula.open(file)
    assert run.hash == results.run.state_hash.iloc[0]
    assert run.steps == results.run.steps.iloc[0] and run.time == results.run.time.iloc[0]
    for name in ("cell", "sample", "cell_sample", "contact", "measure", "mesh_sample", "connection", "division",
                 "time_step", "settling", "experiment"):
        ours, theirs = run.table(name), results.table(name).drop(columns="run_id")
        assert list(ours.columns) == list(theirs.columns), name
        assert len(ours) == len(theirs), name
        if name in ("cell", "measure", "division"):  # rows come in the order in which they were made, not of their keys
            key = ["time", "scope", "name", "a", "b"] if name == "measure" else ["path"]
            ours, theirs = ours.sort_values(key), theirs.sort_values(key)
        for column in ours:
            mine, its = ours[column].to_numpy(), theirs[column].to_numpy()
            same = (mine == its) | (pandas.isna(mine) & pandas.isna(its))
            assert np.all(same), (name, column)


@pytest.mark.parametrize("name", SHORT)
@pytest.mark.parametrize("threads", [1, 2])
def test_program(stored, name, threads):
    if not path(name).exists():
        pytest.skip("no such scenario")
    assert_equals_database(morula.run(path(name), threads=threads), stored(name))


def assert_measures_equal(run, file):
    """What is measured now is what the database holds of the last sample."""
    results = morula.open(file)
    sample, cells = results.sample.iloc[-1], results.cell_sample
    cells = cells[cells.time == sample.time]
    for name, of, demand in zip(*(morula.measures()[column] for column in ("name", "of", "on_demand"))):
        if not demand and of == "world" and name in sample:
            assert run.measure(name) == sample[name] or np.isnan(run.measure(name)) and pandas.isna(sample[name]), name
        elif not demand and of == "cell" and len(cells):
            column = name.removeprefix("cell.")
            assert np.array_equal(run.measure(name), cells[column].to_numpy(float), equal_nan=True), name


@contextlib.contextmanager
def flush_to_zero():
    """What a library built with -ffast-math does to the thread that loads it: tiny numbers become 0."""
    libm = ctypes.CDLL("libm.so.6")
    before, now = (ctypes.c_uint32 * 8)(), (ctypes.c_uint32 * 8)()  # fenv_t of x86-64; its last word is MXCSR
    libm.fegetenv(before)
    now[:] = before
    now[7] |= 0x8040  # results, and operands
    libm.fesetenv(now)
    try:
        tiny = np.array([5e-324])
        assert (tiny + tiny)[0] == 0
        yield
        libm.fegetenv(now)
        assert now[7] & 0x8040 == 0x8040  # given back
    finally:
        libm.fesetenv(before)


x86_64 = pytest.mark.skipif(os.uname().machine != "x86_64", reason="sets the mode of x86-64")
every = pytest.mark.skipif(not os.environ.get("MORULA_TEST_ALL"), reason="MORULA_TEST_ALL is not set")
shipped = sorted(str(p.relative_to(scenarios))[:-5] for p in scenarios.glob("*/*.yaml")
                 if not p.name.endswith(".study.yaml") and p.parent.name not in ("hard", "bullet")
                 and "1024" not in p.name and "128" not in p.name)
LONG = ["urchin/cleavage", "worm/embryo"]  # as long as all others together


@every
@pytest.mark.parametrize("name", shipped)
def test_every_shipped_scenario(stored, name):
    for threads in (1, 2):
        run = morula.run(path(name), threads=threads)
        assert_equals_database(run, stored(name))
        assert_measures_equal(run, stored(name))


def _interrupted(name, threads):
    """Begins a scenario in a child process, where it is interrupted, and pickles it."""
    run = morula.Simulator(path(name), threads=threads)
    signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with flush_to_zero():
            run.run()
    except KeyboardInterrupt:
        pass
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    return pickle.dumps(run)


def _by_detours(begun):
    """Goes to the end from a pickled state, back to a state in between, and to the end again."""
    with flush_to_zero():
        run = pickle.loads(begun)
        state = run.step(50).save()
        return run.run().restore(state).run()


@every
@pytest.mark.parametrize("name", [name for name in shipped if name not in LONG])
@x86_64
def test_every_shipped_scenario_by_detours(stored, name):
    """In threads, after fork, pickle, save, restore and interrupt, and with flush-to-zero set."""
    with multiprocessing.get_context("fork").Pool(2) as children, concurrent.futures.ThreadPoolExecutor(2) as pool:
        begun = children.starmap_async(_interrupted, [(name, 1), (name, 2)]).get(600)
        for run in pool.map(_by_detours, begun):
            assert_equals_database(run, stored(name))


# Balls in a medium become so slow that only denormal numbers hold their speed.
SLOW = ("morula: 1\nname: slow\ndna: |\n  START: a\n  keep(a|a)\nstop: {time: 2}\n"
        "physics: {cell: {model: sphere}, drag: 10, time_step: 0.01}\n"
        "cells: [{at: [-3, 0, 0], velocity: [1e-306, 0, 0]}, {at: [3, 0, 0], velocity: [0, -1e-302, 0]}]\n")


@x86_64
@pytest.mark.parametrize("threads", [1, 2])
def test_flush_to_zero_of_others(program, tmp_path, threads):
    (tmp_path / "slow.yaml").write_text(SLOW)
    words = ["run", "slow.yaml", "--db", "slow.db", "--no-pictures", "--quiet"]
    subprocess.run([program, *words], check=True, cwd=tmp_path, capture_output=True)
    with flush_to_zero():
        run = morula.run(SLOW, threads=threads)
    assert_equals_database(run, tmp_path / "slow.db")
    with flush_to_zero():
        run = morula.Simulator(SLOW, threads=threads).step(50)
        run.run().restore(run.save()).run()
    assert_equals_database(run, tmp_path / "slow.db")


def test_set_and_seed(stored):
    run = morula.run(path("thesis/unique-four"), seed=7, set={"physics.drag": 5, "stop": {"cycles": 2}})
    words = "--seed=7", "--set=physics.drag=5", "--set=stop={cycles: 2}"
    assert_equals_database(run, stored("thesis/unique-four", *words))


@pytest.fixture(scope="module")
def whole():
    return morula.run(path("thesis/unique-four"))


def assert_same(run, whole):
    assert run.finished and run.hash == whole.hash
    for name in ("cell", "sample", "cell_sample", "contact", "division"):
        pandas.testing.assert_frame_equal(run.table(name), whole.table(name))


def test_portions(whole):
    run = morula.Simulator(path("thesis/unique-four"))
    run.step(7)
    assert run.steps == 7
    run.run(until=1.3)
    assert 1.3 <= run.time < 1.31
    while not run.finished:
        run.step(501)
    assert_same(run, whole)
    assert run.step().run().hash == whole.hash


def test_save_and_restore(whole):
    run = morula.Simulator(path("thesis/unique-four")).run(until=2.6)
    state, cells = run.save(), run.cells
    run.run()
    assert_same(run, whole)
    run.restore(state)
    pandas.testing.assert_frame_equal(run.cells, cells)
    assert len(run.table("sample")) == 11
    assert_same(run.run(), whole)
    assert_same(morula.Simulator(path("thesis/unique-four")).restore(run.save()), whole)


def test_pickle_and_copy(whole, tmp_path, monkeypatch):
    run = morula.Simulator(path("thesis/unique-four"), set={"name": "other"}).run(until=1.1)
    monkeypatch.chdir(tmp_path)
    again = pickle.loads(pickle.dumps(run))
    twin = copy.deepcopy(run)
    assert repr(again) == repr(run) and again is not run
    assert_same(again.run(), whole)
    assert_same(twin.run(), whole)
    assert_same(run.run(), whole)
    assert_same(pickle.loads(pickle.dumps(run)), whole)


def test_pickle_holds_files(tmp_path):
    run = morula.Simulator(path("organisms/box-shell")).step(40)
    again = pickle.loads(pickle.dumps(run))
    assert again.step(40).hash == run.step(40).hash


def test_threads_of_python(whole):
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda threads: morula.run(path("thesis/unique-four"), threads=threads), [1, 2, 1, 2]))
    for run in runs:
        assert run.hash == whole.hash


def _hash_in_child(threads):
    return morula.run(path("thesis/unique-four"), threads=threads).hash


def test_fork_and_processes(whole):
    morula.run(path("thesis/unique-four"), threads=2, set={"stop.cycles": 1})
    for method in ("fork", "spawn"):
        with multiprocessing.get_context(method).Pool(2) as pool:
            assert pool.map_async(_hash_in_child, [1, 2]).get(120) == [whole.hash] * 2


def test_interrupt(whole):
    run = morula.Simulator(path("thesis/unique-four"), set={"physics.time_step": 2**-14})
    timer = threading.Timer(0.15, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        run.run()
    timer.join()
    assert 0 < run.time < 6
    state = run.save()
    run.run(until=run.time + 0.05)
    again = morula.Simulator(path("thesis/unique-four"), set={"physics.time_step": 2**-14})
    assert again.run(until=run.time).hash == run.hash
    assert again.restore(state).run(until=run.time).hash == run.hash


def test_rounding_of_others(whole):
    if os.uname().machine != "x86_64":
        pytest.skip("sets the mode of x86-64")
    libm = ctypes.CDLL("libm.so.6")
    towards_zero, nearest = 0xC00, 0
    assert libm.fesetround(towards_zero) == 0
    try:
        run = morula.Simulator(path("thesis/unique-four")).run()
        mode = libm.fegetround()
        hash = run.hash
    finally:
        libm.fesetround(nearest)
    assert mode == towards_zero and hash == whole.hash


def test_saved_scenario(whole, stored, tmp_path):
    for name, changes in (("thesis/unique-four", {"physics.drag": 9}), ("organisms/box-shell", {"stop.time": 0.4})):
        run = morula.Simulator(path(name), seed=5, set=changes)
        run.save_scenario(tmp_path / "saved.yaml")
        assert morula.run(tmp_path / "saved.yaml").hash == run.run().hash


def test_run_of_a_database(stored, whole):
    assert morula.run(stored("thesis/unique-four")).hash == whole.hash
