"""Describes the package that was built: describe.py PACKAGE DIST-INFO PYPROJECT.

Writes _morula.pyi, the types of the compiled module, from the signatures that pybind11 puts into docstrings; and the
folder by which installers and pytest know the package, from pyproject.toml.
"""
import inspect
import re
import sys
import sysconfig
import tomllib
from pathlib import Path

package, about, project = map(Path, sys.argv[1:])
sys.path.insert(0, str(package.parent))
from morula import _morula


def signature(name, function, indent=""):
    first = (function.__doc__ or "").split("\n")[0].replace("morula._morula.", "")
    return f"{indent}def {re.sub(r'(?<=[(])self: [^,)]+', 'self', first) or name + '(*args) -> object'}: ..."


lines = ["from typing import *", "import numpy", ""]
for name, thing in sorted(vars(_morula).items()):
    if inspect.isclass(thing) and issubclass(thing, Exception):
        lines.append(f"class {name}({thing.__base__.__name__}): ...")
    elif inspect.isclass(thing):
        lines.append(f"class {name}:")
        for member, value in sorted(vars(thing).items()):
            if isinstance(value, property):
                result = re.search(r"-> (.+)", value.fget.__doc__ or "-> object").group(1)
                lines += ["    @property", f"    def {member}(self) -> {result}: ..."]
            elif isinstance(value, staticmethod):
                lines += ["    @staticmethod", signature(member, getattr(thing, member), "    ")]
            elif member == "__init__" or (callable(value) and not member.startswith("_")):
                lines.append(signature(member, value, "    "))
    elif callable(thing) and not name.startswith("_"):
        lines.append(signature(name, thing))
(package / "_morula.pyi").write_text("\n".join(lines + ["orders: Dict[str, str]", "__version__: str", ""]))

told = tomllib.loads(project.read_text())["project"]
about.mkdir(exist_ok=True)
(about / "METADATA").write_text(
    f"Metadata-Version: 2.1\nName: {told['name']}\nVersion: {_morula.__version__}\nSummary: {told['description']}\n"
    f"License: {told['license']['text']}\nRequires-Python: {told['requires-python']}\n"
    + "".join(f"Requires-Dist: {needed}\n" for needed in told["dependencies"]))
(about / "entry_points.txt").write_text("".join(
    f"[{group}]\n" + "".join(f"{key} = {value}\n" for key, value in points.items())
    for group, points in told["entry-points"].items()))
tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
(about / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: morula\nRoot-Is-Purelib: false\n"
                             f"Tag: {tag}-{tag}-{re.sub('[-.]', '_', sysconfig.get_platform())}\n")
