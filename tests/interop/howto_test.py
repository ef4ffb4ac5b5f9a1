#!/usr/bin/env python3
"""The commands on the pages of exporters/gltf/howto write tiles, and the files that the pages name exist."""
import re
import shlex
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import ROOT, ProgramTest, run  # noqa: E402

PAGES = sorted((ROOT / "exporters" / "gltf" / "howto").glob("*.md"))


class HowTo(ProgramTest):
    def test_commands_write_tiles(self):
        commands = 0
        for page in PAGES:
            for line in re.findall(r"^ {4}build/release/citykiln (.*)$", page.read_text(), re.MULTILINE):
                with self.subTest(page=page.name, line=line):
                    words = shlex.split(line)
                    out = self.folder / str(commands)
                    words[words.index("-o") + 1] = out
                    done = run(*words)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertTrue(list(out.glob("*/*.glb")))
                    commands += 1
        self.assertGreaterEqual(commands, 4)

    def test_copied_files_exist(self):
        copied = [name for page in PAGES for name in re.findall(r"^ {4}cp (\S+) ", page.read_text(), re.MULTILINE)]
        self.assertGreaterEqual(len(copied), 2)
        for name in copied:
            self.assertTrue((ROOT / name).exists(), name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
