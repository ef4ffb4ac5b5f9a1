#!/usr/bin/env python3
"""Every relative link in a page leads to a file, and ARCHITECTURE.md lists every setting."""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def documents():
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [ROOT / name for name in listed.splitlines()]


class Links(unittest.TestCase):
    def test_lead_to_files(self):
        dead = []
        self.assertGreater(len(documents()), 10)
        for document in documents():
            for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text()):
                if not (document.parent / target).exists():
                    dead.append(f"{document.relative_to(ROOT)}: {target}")
        self.assertEqual(dead, [], "\n" + "\n".join(dead))

    def test_every_setting_is_in_the_architecture(self):
        settings = re.findall(r'^    \{"([a-z-]+)", ', (ROOT / "compiler" / "spec.cpp").read_text(), re.MULTILINE)
        self.assertGreater(len(settings), 10)
        page = (ROOT / "ARCHITECTURE.md").read_text()
        self.assertEqual([name for name in settings if f"| {name} |" not in page], [])


if __name__ == "__main__":
    sys.exit(unittest.main())
