#!/usr/bin/env python3
"""Fails when a module includes one that it may not see. Lower layers never look up."""
import pathlib
import re
import sys

SEES = {
    "core": set(),
    "config": {"core"},
    "par": {"core"},
    "grid": {"core", "par"},
    "geom": {"core", "par", "grid"},
    "flow": {"core", "par", "grid"},
    "mobility": {"core", "par", "flow"},
    "surface": {"core"},
    "dem": {"core", "par", "grid", "geom"},
    "io": {"core", "par", "grid"},
    "analysis": {"core", "par", "grid", "geom", "io"},
    "report": {"core", "config", "io", "analysis", "geom"},
    "study": {"core", "config", "io", "analysis", "report"},
    "scale": {"core", "par", "io", "report"},
    "vision": {"core", "config", "io", "report"},
    "sim": {"core", "config", "par", "grid", "geom", "flow", "dem", "io", "analysis", "report"},
    "interop": {"core", "config", "par", "geom", "flow", "sim"},
    "page": {"core", "config", "geom", "dem", "io", "sim"},
    "validate": {"core", "io", "surface", "mobility", "page"},
}


def main() -> int:
    bad = []
    for path in sorted(pathlib.Path("src").rglob("*.[ch]pp")):
        module = path.parts[1]
        if module not in SEES:
            bad.append(f"{path}: module '{module}' is not listed in tools/check_layers.py")
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = re.match(r'#include "(\w+)/', line)
            if match and match[1] != module and match[1] not in SEES[module]:
                bad.append(f"{path}:{number}: {module} may not include {match[1]}")
    print("\n".join(bad) if bad else "layers: ok")
    return bool(bad)


sys.exit(main())
