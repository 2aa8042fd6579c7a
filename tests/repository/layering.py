#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every include points down the dependency order, and every source names its licence."""

import pathlib
import re
import sys

BELOW = {
    "core": set(),
    "learning": {"core"},
    "sim": {"core"},
    "hw": {"core"},
    "dataset": {"core"},
    "scenarios": {"core", "learning", "sim", "hw", "dataset"},
    "runs": {"core", "learning", "sim", "hw", "dataset", "scenarios"},
    "studies": {"core", "learning", "sim", "hw", "dataset", "scenarios", "runs"},
    "apps": {"core", "learning", "sim", "hw", "dataset", "scenarios", "runs", "studies"},
}
INCLUDE = re.compile(r'^#include "([a-z]+)/')
LICENCE = "SPDX-License-Identifier: Apache-2.0"


def faults(root):
    for module, allowed in BELOW.items():
        for path in sorted((root / module).rglob("*")):
            if path.suffix not in {".h", ".cc"}:
                continue
            lines = path.read_text().splitlines()
            name = path.relative_to(root)
            if LICENCE not in "".join(lines[:2]):
                yield f"{name}:1: names no licence; the first line is // {LICENCE}"
            for number, line in enumerate(lines, 1):
                found = INCLUDE.match(line)
                if found and found[1] in BELOW and found[1] not in allowed | {module}:
                    yield f"{name}:{number}: {module} may not include {found[1]}"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every include points down")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
