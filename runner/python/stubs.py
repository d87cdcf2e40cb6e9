"""Writes _morula.pyi, the types of the compiled module, from the signatures that pybind11 puts into docstrings."""
import inspect
import re
import sys
from pathlib import Path

from morula import _morula


def signature(name, function, indent=""):
    first = (function.__doc__ or "").split("\n")[0].replace("morula._morula.", "")
    first = re.sub(r"\bself: \w+", "self", first) or f"{name}(*args) -> object"
    return f"{indent}def {first}: ..."


lines = ["from typing import *", "import numpy", ""]
for name, thing in sorted(vars(_morula).items()):
    if inspect.isclass(thing) and issubclass(thing, Exception):
        lines.append(f"class {name}({thing.__base__.__name__}): ...")
    elif inspect.isclass(thing):
        lines.append(f"class {name}:")
        for member, value in sorted(vars(thing).items()):
            if isinstance(value, property):
                result = re.search(r"-> (\S+)", value.fget.__doc__ or "-> object").group(1)
                lines += ["    @property", f"    def {member}(self) -> {result}: ..."]
            elif isinstance(value, staticmethod):
                lines += ["    @staticmethod", signature(member, getattr(thing, member), "    ")]
            elif member == "__init__" or (callable(value) and not member.startswith("_")):
                lines.append(signature(member, value, "    "))
    elif callable(thing) and not name.startswith("_"):
        lines.append(signature(name, thing))
lines += ["__version__: str", ""]
Path(sys.argv[1], "_morula.pyi").write_text("\n".join(lines))
