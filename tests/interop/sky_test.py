#!/usr/bin/env python3
"""The rows of tests/compiler/sky/almanac.inc, which the sky is tested against, are those of astronomy-engine."""
import subprocess
import sys
import unittest

from readers import HERE, has_npm

ROWS = HERE.parent / "compiler" / "sky" / "almanac.inc"


@unittest.skipUnless(has_npm("astronomy-engine"), "astronomy-engine is not installed: npm ci in tests/interop")
class Almanac(unittest.TestCase):
    def test_rows_are_those_of_astronomy_engine(self):
        printed = subprocess.run(["node", HERE / "almanac.mjs"], capture_output=True, text=True, check=True).stdout
        kept = [line for line in ROWS.read_text().splitlines() if not line.startswith("//")]
        self.assertEqual(len(kept), 20)
        self.assertEqual(printed.splitlines(), kept)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
