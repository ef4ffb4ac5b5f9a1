#!/usr/bin/env python3
"""Comments, pages and messages use the terms of the glossary in ARCHITECTURE.md, not the private words that they replaced.

Prints one line for each violation.
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Each row: a pattern of a private word, the term to use, and the folders where the word has its common meaning.
WORDS = [
    (r"clay", "recipe", []),
    (r"fir(e|es|ed|ing)", "bake", ["lsystems"]),
    (r"carv(e|es|ed|ing|ings)", "grade, graded terrain", []),
    (r"imprint(s|ed)?", "facade texture, impostor", []),
    (r"(un)?squeez(e|es|ed|ing)|pinch(es|ed)?", "width limit", []),
    (r"upright faces?|uprights", "vertical face", []),
    (r"christen(s|ed)?|bear(s)? the name|threw|dice", "create, name, random draw", []),
    (r"whoever|whosoever|nobody('s)?|likewise|felt|foretold", "a sentence that names its subject", []),
    (r"what is there twice|at the door|knows nothing of|is told of", "a sentence that says what happens", []),
]
PATTERNS = [(re.compile(rf"\b({word})\b", re.IGNORECASE), term, folders) for word, term, folders in WORDS]

COMMENT = {
    ".h": re.compile(r"//.*"), ".cpp": re.compile(r"//.*"), ".inc": re.compile(r"//.*"), ".fbs": re.compile(r"//.*"),
    ".mjs": re.compile(r"//.*"), ".cga": re.compile(r"//.*"), ".lsys": re.compile(r"//.*"), ".py": re.compile(r"#.*|\"\"\".*"),
    ".sh": re.compile(r"#.*"), ".txt": re.compile(r"#.*"), ".cmake": re.compile(r"#.*"), ".md": re.compile(r".*"),
}
# CHANGELOG.md tells what things were called, and this file lists the words
EXEMPT = {"CHANGELOG.md", "LICENSE", "tests/words_test.py"}


def prose():
    """Path, line number and text of every comment and every line of a page."""
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    for name in names:
        pattern = COMMENT.get(Path(name).suffix)
        if pattern is None or name in EXEMPT or not (ROOT / name).exists():
            continue
        for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), 1):
            found = pattern.search(line)
            if found:
                yield name, number, found[0]


def violations_in(lines):
    for name, number, text in lines:
        for pattern, term, folders in PATTERNS:
            found = pattern.search(text)
            if found and not any(name.startswith(folder + "/") for folder in folders):
                yield f"{name}:{number}: \"{found[0]}\"; use: {term}"


class Words(unittest.TestCase):
    def test_private_words_are_not_used(self):
        lines = list(prose())
        self.assertGreater(len(lines), 5000)
        violations = list(violations_in(lines))
        if violations:
            self.fail("\n" + "\n".join(violations))

    def test_a_private_word_is_found(self):
        self.assertEqual(len(list(violations_in([("a.h", 1, "// Fires the clay."), ("a.h", 2, "// Bakes the recipe.")]))), 2)


if __name__ == "__main__":
    sys.exit(unittest.main())
