"""pytest --morula: each scenario of a project is a test; the fixture `golden` holds your own numbers."""
from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Iterator, Mapping

import pytest

from .stored import program


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("morula")
    group.addoption("--morula", action="store_true", help="check the scenarios in folders `scenarios`")
    group.addoption("--morula-accept", metavar="WHY", help="accept results that differ, for this reason; never in CI")
    group.addoption("--morula-by", metavar="NAME", help="who accepts; default: as `morula review --accept` says")


def pytest_configure(config: pytest.Config) -> None:
    why = config.getoption("morula_accept")
    if why is not None and not why.strip():
        raise pytest.UsageError("--morula-accept needs a reason")
    if why is not None and os.environ.get("CI"):
        raise pytest.UsageError("--morula-accept: nothing is accepted in CI; accept where you can look at the results")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if (not parent.config.getoption("morula") or file_path.suffix != ".yaml" or "scenarios" not in file_path.parts
            or file_path.name.endswith(".study.yaml")):
        return None
    return ScenarioFile.from_parent(parent, path=file_path)


class ScenarioFile(pytest.File):
    def collect(self) -> Iterator[pytest.Item]:
        yield Check.from_parent(self, name="check")


class Different(Exception):
    """A result that is not the accepted one; its text is the program's."""


class Check(pytest.Item):
    def runtest(self) -> None:
        parts = self.path.parts
        project = Path(*parts[:len(parts) - 1 - parts[::-1].index("scenarios")])
        file, why = self.path.relative_to(project), self.config.getoption("morula_accept")

        def tell(*words: str) -> subprocess.CompletedProcess:
            return subprocess.run([program(), *words], cwd=project, capture_output=True, text=True)
        told = tell("check", str(file))
        if told.returncode == 1 and why:
            by = self.config.getoption("morula_by")
            told = tell("review", str(file), "--accept", "--why", why, *(["--by", by] if by else []))
        if told.returncode:
            raise Different((told.stdout + told.stderr).strip().replace("Give --by", "Give --morula-by"))
        self.add_report_section("call", "morula", told.stdout)

    def repr_failure(self, excinfo: Any, style: Any = None) -> Any:
        return str(excinfo.value) if excinfo.errisinstance(Different) else super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple:
        return self.path, None, f"morula check {self.path.name}"


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Any:
    """Compares numbers with those accepted for this test: golden({"radius": r}, rel=1e-9). The file
    golden/TESTFILE-TEST.json lies beside the test; --morula-accept WHY writes it."""
    name = f"{request.path.stem}-{request.node.name}.json"
    file = request.path.parent / "golden" / "".join(c if c.isalnum() or c in "-_.[]" else "_" for c in name)

    def compare(numbers: Mapping[str, float], *, rel: float = 1e-12, abs: float = 0.0) -> None:
        now = {key: float(value) for key, value in numbers.items()}
        before = json.loads(file.read_text())["numbers"] if file.exists() else None
        why = request.config.getoption("morula_accept")
        same = before is not None and now == pytest.approx(before, rel=rel, abs=abs, nan_ok=True)
        if not same and why:
            file.parent.mkdir(exist_ok=True)
            draft = file.with_suffix(f".{os.getpid()}")
            draft.write_text(json.dumps({"why": why, "numbers": now}, indent=1) + "\n")
            os.replace(draft, file)
        elif before is None:
            pytest.fail(f"no numbers are accepted: {file}; --morula-accept WHY accepts these: {now}", pytrace=False)
        elif not same:
            lines = [f"{key}: accepted {before.get(key)}, now {now.get(key)}" for key in sorted({*before, *now})
                     if key not in before or key not in now or now[key] != pytest.approx(before[key], rel=rel, abs=abs,
                                                                                                nan_ok=True)]
            pytest.fail(f"{file} differs (rel {rel}, abs {abs}):\n" + "\n".join(lines), pytrace=False)
    return compare
