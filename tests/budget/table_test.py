#!/usr/bin/env python3
"""The budget's table: what counts as a difference, which rise is too high, and that the changelog argues for the last change."""
import unittest

import table

BYTES, TRIANGLES = ("town", "glb", "L0", "bytes"), ("town", "glb", "L0", "triangles of roads")
SMALL, COUNT = ("town", "glb", "L0", "triangles of water"), ("town", "one thread", "", "instructions")
ERROR = ("town", "glb", "L0", "error_m")
ROWS = {BYTES: 1000, TRIANGLES: 5000, SMALL: 20, COUNT: 100_000, ERROR: 0.09}


class Table(unittest.TestCase):
    def test_printed_rows_are_read_again(self):
        self.assertEqual(table.parse(table.printed(ROWS, "Roads are wider.")), (ROWS, "Roads are wider."))

    def test_one_byte_more_differs_and_three_percent_of_instructions_do_not(self):
        self.assertEqual(table.differences(ROWS, ROWS | {BYTES: 1001, COUNT: 103_000}), [BYTES])
        self.assertEqual(table.differences(ROWS, ROWS | {ERROR: 0.090001, COUNT: 96_900}), [COUNT, ERROR])

    def test_a_row_that_is_gone_or_new_differs(self):
        without = {key: value for key, value in ROWS.items() if key != SMALL}
        self.assertEqual(table.differences(ROWS, without), [SMALL])
        self.assertEqual(table.differences(without, ROWS), [SMALL])

    def test_rows_rise_by_a_tenth_and_small_ones_to_a_hundredth_of_their_kind(self):
        self.assertEqual(table.rises(ROWS, ROWS | {BYTES: 1100, TRIANGLES: 5500, SMALL: 50}), [])
        self.assertEqual(table.rises(ROWS, ROWS | {BYTES: 1101, TRIANGLES: 5501, SMALL: 51}), [BYTES, TRIANGLES, SMALL])
        self.assertEqual(table.rises(ROWS, ROWS | {ERROR: 0.165}), [ERROR])
        self.assertEqual(table.rises(ROWS, ROWS | {("town", "usd", "L0", "bytes"): 9}), [])

    def test_a_comparison_names_the_row_and_both_values(self):
        text = table.whole_comparison(ROWS, ROWS | {TRIANGLES: 5012})
        self.assertIn("rows that differ: 1", text)
        self.assertIn("| town | glb | L0 | triangles of roads | 5,000 | 5,012 | 1.002 |", text)

    def test_items_under_bytes_are_found_in_all_versions(self):
        log = "## 0.2\n### Added\n- a\n### Bytes\n- newest\n  goes on\n- older\n## 0.1\n### Bytes\n- oldest\n### Fixed\n- b\n"
        self.assertEqual(table.items_of_bytes(log), ["newest", "older", "oldest"])

    def test_the_changelog_argues_for_the_last_change_of_the_table(self):
        _, argued = table.parse(table.TABLE.read_text())
        self.assertIn(argued, table.items_of_bytes(table.CHANGELOG.read_text()))


if __name__ == "__main__":
    unittest.main()
