"""The built program, and what it leaves behind, as tests see them.

CITYKILN names the program (ctest sets it); real data are looked for in ../shared/data, and what needs them is skipped without.
"""
import hashlib
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
DATA = Path(os.environ.get("CITYKILN_DATA", ROOT.parent / "shared" / "data"))
PROGRAM = os.environ.get("CITYKILN", str(ROOT / "build" / "release" / "citykiln"))
TOWN = ROOT / "examples" / "town"


def run(*arguments, **options):
    """One call; never raises for the program's own failure."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT, check=False, **options)


def sha256(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def bytes_of_outputs(folder):
    """Name to hash of everything that must be the same on every run: the manifest and the tiles."""
    folder = Path(folder)
    return {str(path.relative_to(folder)): sha256(path)
            for path in sorted(folder.rglob("*")) if path.suffix in (".kiln", ".glb")}


def report_of(folder):
    return json.loads((Path(folder) / "report.json").read_text())


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="citykiln_")
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)

    def compiled(self, name, *arguments, **options):
        """Compiles into a new folder of that name and returns it."""
        out = self.folder / name
        done = run("compile", *arguments, "-o", out, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def data(self, name):
        path = DATA / name
        if not path.exists():
            self.skipTest(f"{path} is not there")
        return path
