"""pytest --morula, and the fixture golden."""
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest



@pytest.fixture
def project(tmp_path):
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "scenarios/four.yaml").write_text(
        "morula: 1\nname: four\nseed: 1\ndna: |\n  START: a\n  g(divide|a)\n  k(a|a)\nstop: {cycles: 2}\ncheck: {}\n")
    (tmp_path / "test_numbers.py").write_text(
        "def test_radius(golden):\n    golden({'radius': 0.5, 'nan': float('nan')}, rel=1e-9)\n")
    return tmp_path


def pytest_in(project, *words, ci=False, anonymous=False):
    environment = {k: v for k, v in os.environ.items() if k not in ("CI", "PYTEST_XDIST_WORKER", "PYTEST_CURRENT_TEST")}
    if ci:
        environment["CI"] = "true"
    if anonymous:
        environment = {k: v for k, v in environment.items() if k != "USER"}
    return subprocess.run([sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *words], cwd=project,
                          capture_output=True, text=True, env=environment)


def test_from_nothing_to_accepted_to_different(project):
    told = pytest_in(project, "--morula")
    assert told.returncode == 1 and "2 failed" in told.stdout and "no numbers are accepted" in told.stdout
    assert pytest_in(project, "--morula", "--morula-accept", " ").returncode == 4
    refused = pytest_in(project, "--morula", "--morula-accept", "because", ci=True)
    assert refused.returncode == 4 and "nothing is accepted in CI" in refused.stderr
    assert not (project / "golden").exists() or not list((project / "golden").glob("*.json"))
    told = pytest_in(project, "scenarios", "--morula", "--morula-accept", "the first results", anonymous=True)
    assert told.returncode == 1 and "Give --morula-by NAME, too" in told.stdout
    told = pytest_in(project, "--morula", "--morula-accept", "the first results", "--morula-by", "tests")
    assert told.returncode == 0, told.stdout
    assert "the first results" in (project / "golden/four.golden").read_text()
    told = pytest_in(project, "--morula", "--junitxml=junit.xml", "-n", "2")
    assert told.returncode == 0 and "2 passed" in told.stdout
    cases = ElementTree.parse(project / "junit.xml").iter("testcase")
    assert {case.get("name") for case in cases} == {"check", "test_radius"}

    scenario, numbers = project / "scenarios/four.yaml", project / "test_numbers.py"
    scenario.write_text(scenario.read_text().replace("cycles: 2", "cycles: 3"))
    numbers.write_text(numbers.read_text().replace("0.5", "0.6"))
    told = pytest_in(project, "--morula", "--junitxml=junit.xml")
    assert "nan: accepted" not in told.stdout  # it has not changed
    assert told.returncode == 1 and "2 failed" in told.stdout
    assert "radius: accepted 0.5, now 0.6" in told.stdout and "stop.cycles" in told.stdout
    failures = [f.get("message") or f.text for f in ElementTree.parse(project / "junit.xml").iter("failure")]
    assert len(failures) == 2
    told = pytest_in(project)
    assert told.returncode == 1 and "1 failed" in told.stdout  # without --morula scenarios are no tests
