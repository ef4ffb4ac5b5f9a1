#!/usr/bin/env python3
"""format_test.py CLANG_FORMAT [--update]: fails if clang-format would change a source, or a table in an .inc file; --update changes them.

Rows of tables stay on one line, however long they are. A table whose rows are in columns by hand begins with "clang-format off".
"""
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOPS = ("compiler", "exporters", "preview", "grammars", "lsystems", "tests")
TABLE_STYLE = "--style={BasedOnStyle: Google, ColumnLimit: 0, ReflowComments: false}"


def files(*endings):
    return [str(path) for top in TOPS for path in sorted((ROOT / top).rglob("*")) if path.suffix in endings and "node_modules" not in path.parts]


def formatted(paths, *options):
    """True if all are, or have been changed."""
    assert paths
    mode = ["-i"] if "--update" in sys.argv else ["--dry-run", "-Werror"]
    return subprocess.run([sys.argv[1], *mode, *options, *paths], cwd=ROOT, check=False).returncode == 0


are_formatted = [formatted(files(".h", ".cpp")), formatted(files(".inc"), TABLE_STYLE)]
sys.exit(0 if all(are_formatted) else 1)
