"""check_names.py INVENTORY HEADER LIBRARY: every public name of the C++ facade and of the Python module must be in the site's index.

The names of C++ are those that the shared library exports (nm) and those that the header declares. The names of Python come from
the module and its classes themselves. None of them comes from Doxygen or Sphinx. The control removes a name from the index.
"""

import re
import subprocess
import sys
from pathlib import Path

from sphinx.util.inventory import InventoryFile

import steadyslide


def exported(library):
    """Returns the names of exported functions and member functions, with namespaces."""
    text = subprocess.run(["nm", "-DC", "--defined-only", library], capture_output=True, check=True, encoding="utf-8").stdout
    names = set(re.findall(r" [TW] (steadyslide::[\w:~]+)\(", text))
    return {name for name in names if "~" not in name and len(set(name.split("::"))) == len(name.split("::"))}


def declared(header):
    """Returns the names without namespace that the public parts of the header declare: types, members, functions."""
    text = re.sub(r"//.*|#(?:.*\\\n)*.*|STEADYSLIDE_QUANTITIES\(.*\)|\bSTEADYSLIDE_API\b", "", header.read_text(encoding="utf-8"))
    text = re.sub(r"private:.*?\n};", "};", text, flags=re.DOTALL)
    types = set(re.findall(r"\b(?:struct|class) (\w+)[^;{]*{", text))
    functions = set(re.findall(r"\b(\w+)\([^;{]*\)[^;{(]*[;{]", text))
    members = set(re.findall(r"^  [\w:<>, ]+ (\w+)(?: = [^;]*|{})?;", text, re.MULTILINE))
    for line in re.findall(r"^  (?:Number|std::optional<Number>) (\w+(?:, \w+)+);", text, re.MULTILINE):
        members |= set(line.split(", "))
    words = {"if", "for", "while", "return", "to_string", "move", "text_", "Whole", "State", "Data"}
    return (types | members | functions) - words


def python_names():
    names = set()
    for name in steadyslide.__all__:
        names.add(f"steadyslide.{name}")
        thing = getattr(steadyslide, name)
        if isinstance(thing, type):
            names |= {f"steadyslide.{name}.{member}" for member in vars(thing)
                      if not member.startswith("_") and (issubclass(thing, tuple) or callable(getattr(thing, member))
                                                         or isinstance(vars(thing)[member], property))}
    # Imported names, and types named in annotations, belong to other modules.
    own = {name for name in dir(steadyslide) if not name.startswith("_")
           and getattr(getattr(steadyslide, name), "__module__", None) == "steadyslide"}
    return names | {f"steadyslide.{name}" for name in own}


def missing(index, header, library):
    cpp, python = index["cpp"], index["py"]
    last = {name.rsplit("::", 1)[-1] for name in cpp}
    return sorted((exported(library) - cpp) | (declared(header) - last) | (python_names() - python))


def main():
    with open(sys.argv[1], "rb") as file:
        found = InventoryFile.load(file, "", lambda base, name: name)
    index = {kind: {name for role, names in found.items() if role.startswith(kind + ":") for name in names} for kind in ("cpp", "py")}
    header, library = Path(sys.argv[2]), sys.argv[3]
    counts = len(exported(library)), len(declared(header)), len(python_names())
    absent = missing(index, header, library)
    print(*(f"not in the site's index: {name}" for name in absent), sep="\n", end="\n" if absent else "")
    print(f"{counts[0]} exported and {counts[1]} declared names of C++, {counts[2]} of Python, {len(absent)} missing")
    if min(counts) < 10:
        sys.exit("hardly any name found: the test sees nothing")
    for name in ("steadyslide::Solution::stress", "steadyslide.Solution.stress", "steadyslide.sweep"):
        without = {kind: names - {name} for kind, names in index.items()}
        if name not in missing(without, header, library):
            sys.exit(f"control: nobody misses {name}")
    sys.exit(bool(absent))


main()
