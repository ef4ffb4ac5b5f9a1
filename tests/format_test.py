#!/usr/bin/env python3
"""format_test.py CLANG_FORMAT: fails if clang-format would change a source."""
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOPS = ("compiler", "exporters", "preview", "grammars", "lsystems", "tests")

sources = [str(path) for top in TOPS for path in sorted((ROOT / top).rglob("*"))
           if path.suffix in (".h", ".cpp") and "node_modules" not in path.parts]
assert sources
sys.exit(subprocess.run([sys.argv[1], "--dry-run", "-Werror", *sources], cwd=ROOT, check=False).returncode)
