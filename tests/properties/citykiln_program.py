"""Runs the built program and reads its outputs.

The environment variable CITYKILN names the program and CITYKILN_DATA the folder of real data; ctest sets both. Tests that need
real data are skipped without them. Where CITYKILN_FULL is set (./test.sh --full), scripts also run their long tests.
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
if not Path(PROGRAM).exists():
    raise SystemExit(f"{PROGRAM} does not exist: run ./setup.sh")
TOWN = ROOT / "examples" / "town"
# 220 by 180 m of the town, about the corner of four tiles
TOWN_MIDDLE = ["--bbox", "12.2990,48.6992,12.3020,48.7008"]
IS_FULL = "CITYKILN_FULL" in os.environ

# A class or method that takes long; a smaller case of the same claim runs always.
long_test = unittest.skipUnless(IS_FULL, "runs with ./test.sh --full")


def run(*arguments, **options):
    """Runs the program once. Does not raise if it fails."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT, check=False, **options)


def sha256(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def bytes_of_outputs(folder):
    """Name to hash of the files that must be the same on every run, the manifest and the tiles; at least one."""
    folder = Path(folder)
    found = {str(path.relative_to(folder)): sha256(path)
             for path in sorted(folder.rglob("*")) if path.suffix in (".kiln", ".glb")}
    assert found, f"{folder} holds neither a manifest nor a tile"
    return found


def report_of(folder):
    return json.loads((Path(folder) / "report.json").read_text())


class ProgramTest(unittest.TestCase):
    """A test with a temporary folder of its own, and one that the tests of its class share."""

    @classmethod
    def setUpClass(cls):
        cls.shared_scratch = tempfile.TemporaryDirectory(prefix="citykiln_")
        cls.addClassCleanup(cls.shared_scratch.cleanup)
        cls.shared_runs = {}

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

    def compiled_once(self, *arguments):
        """The folder of a run with these arguments that all tests of the class share; they must not change it."""
        words = tuple(map(str, arguments))
        if words not in self.shared_runs:
            self.shared_runs[words] = self.compiled(Path(self.shared_scratch.name) / f"run{len(self.shared_runs)}", *words)
        return self.shared_runs[words]

    def data(self, name):
        """A file of real data; skips the test if it is missing."""
        path = DATA / name
        if not path.exists():
            self.skipTest(f"{path} is missing")
        return path
