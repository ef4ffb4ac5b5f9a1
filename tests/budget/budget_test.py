#!/usr/bin/env python3
"""The built program writes for five maps exactly what table.tsv says: bytes, triangles, instances, stated errors; instructions within 3 %.

Prints both tables side by side where they differ. tests/budget/update writes the table anew.
"""
import sys
import tempfile
import unittest
from pathlib import Path

import table
from measure import DATA, measured


class Budget(unittest.TestCase):
    def test_five_maps_are_as_the_table_says(self):
        expected, _ = table.parse(table.TABLE.read_text())
        with tempfile.TemporaryDirectory(prefix="citykiln_budget_") as scratch:
            found = measured(Path(scratch))
        if not DATA.exists():
            print(f"{DATA} is missing: the real map is not compared", file=sys.stderr)
            expected = {key: value for key, value in expected.items() if key[0] in {name for name, *_ in found}}
        if table.differences(expected, found):
            self.fail(table.whole_comparison(expected, found) + "\n\nIf the change is meant: tests/budget/update")


if __name__ == "__main__":
    unittest.main()
