#!/usr/bin/env python3
"""Every relative link of the documents at the top leads to a file."""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        dead = []
        for document in sorted(ROOT.glob("*.md")):
            for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text()):
                if not (ROOT / target).exists():
                    dead.append(f"{document.name}: {target}")
        self.assertEqual(dead, [], "\n" + "\n".join(dead))

    def test_every_setting_is_in_the_walk(self):
        settings = re.findall(r'^    \{"([a-z-]+)", ', (ROOT / "compiler" / "spec.cpp").read_text(), re.MULTILINE)
        self.assertGreater(len(settings), 10)
        walk = (ROOT / "ARCHITECTURE.md").read_text()
        self.assertEqual([name for name in settings if f"| {name} |" not in walk], [])


if __name__ == "__main__":
    sys.exit(unittest.main())
