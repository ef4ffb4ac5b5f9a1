#!/usr/bin/env python3
"""Comments and pages are plain: they use the terms of the glossary in ARCHITECTURE.md, begin sentences with their subject, say what a
function does, and fit a screen.

Prints one line for each violation.
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WIDEST_PAGE = 120

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

# A sentence that begins so hides its subject.
START = re.compile(r"^(Of|What|As|Those|That|The same|Likewise|Whoever)\b")
SENTENCE_END = re.compile(r"(?<=[.!?])\s+|(?<=[.!?][)\"])\s+")
# A function's docstring: a verb in the third person, or what the function returns.
DOCSTRING_START = re.compile(r"^(The|A|An|True|(?!This\b|Its\b|As\b|Always\b|Unless\b)[A-Z][a-z]+s)\b")
DECLARES_NO_FUNCTION = re.compile(r"\s*(struct|class|enum|union|using|typedef|(inline |static )?constexpr|"
                                  r"template\s*<[^>]*>\s*(struct|class))\b")

SLASHES, HASH = r"//+[/<]?", r"#+"
COMMENT = {".h": SLASHES, ".cpp": SLASHES, ".inc": SLASHES, ".fbs": SLASHES, ".mjs": SLASHES, ".cga": SLASHES, ".lsys": SLASHES,
           ".py": HASH, ".sh": HASH, ".txt": HASH, ".cmake": HASH}
TRAILING = re.compile(r"[;,){}\w]\s+//+<?\s(.*)$")
# CHANGELOG.md tells what things were called, osm_testdata.md quotes texts of others, and this file lists the words
EXEMPT = {"CHANGELOG.md", "LICENSE", "tests/words_test.py", "compiler/source/osm_testdata.md"}


def files():
    """Name and lines of each file with prose."""
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    for name in names:
        suffix = Path(name).suffix
        if (suffix in COMMENT or suffix == ".md") and name not in EXEMPT and (ROOT / name).exists():
            yield name, (ROOT / name).read_text(encoding="utf-8").splitlines()


def joined(numbered):
    """Joins neighbouring lines of text; None ends a block. Yields the number of the first line and the text."""
    block, first = [], 0
    for number, text in [*numbered, (0, None)]:
        if text and not block:
            first = number
        if text:
            block.append(text)
        elif block:
            yield first, " ".join(block)
            block = []


def lines_of_comments(lines, mark):
    """The text of each comment, None between blocks; a @param begins a block."""
    whole = re.compile(rf"^\s*{mark}\s?(.*)$")
    for number, line in enumerate(lines, 1):
        found, trailing = whole.match(line), TRAILING.search(line)
        if found is None:
            yield from ((number, None), (number, trailing and trailing[1]), (number, None))
            continue
        text = re.sub(r"^@(param\s+\S+|returns?)\s*", "", found[1].strip())
        if text != found[1].strip():
            yield number, None
        yield number, text or None


def lines_of_page(lines):
    """The text of each line of a page, None between paragraphs, items and cells."""
    is_code = False
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if text.startswith("```"):
            is_code = not is_code
        if is_code or text.startswith("```"):
            yield number, None
        elif text.startswith("|"):
            for cell in text.strip("|").split("|"):
                yield from ((number, cell.strip()), (number, None))
        else:
            item = re.sub(r"^([-*]|\d+\.|#+) ", "", text)
            if item != text:
                yield number, None
            yield number, item or None


def blocks_of(name, lines):
    """The first line and the text of each comment or paragraph."""
    suffix = Path(name).suffix
    if suffix == ".md":
        yield from joined(lines_of_page(lines))
        return
    yield from joined(lines_of_comments(lines, COMMENT[suffix]))
    if suffix == ".py":
        text = "\n".join(lines)
        for found in re.finditer(r'"""(.*?)"""', text, re.DOTALL):
            yield text[:found.start()].count("\n") + 1, " ".join(found[1].split())


def private_words(name, lines):
    for number, text in blocks_of(name, lines):
        for pattern, term, folders in PATTERNS:
            found = pattern.search(text)
            if found and not any(name.startswith(folder + "/") for folder in folders):
                yield f"{name}:{number}: \"{found[0]}\"; use: {term}"


def hidden_subjects(name, lines):
    for number, text in blocks_of(name, lines):
        for sentence in SENTENCE_END.split(text):
            if START.match(sentence):
                yield f"{name}:{number}: the sentence does not begin with its subject: {sentence[:60]}"


def wide_lines(name, lines):
    if name.endswith(".md"):
        for number, line in enumerate(lines, 1):
            if len(line) > WIDEST_PAGE:
                yield f"{name}:{number}: {len(line)} columns; a page has {WIDEST_PAGE}"


def unclear_docstrings(name, lines):
    """Docstrings of functions that say neither what the function does nor what it returns."""
    for number, line in enumerate(lines if name.endswith(".h") else [], 1):
        begins = re.match(r"\s*///\s+(\S.*)", line) and (number == 1 or not lines[number - 2].lstrip().startswith("///"))
        if not begins:
            continue
        rest = [code for code in lines[number - 1:] if not code.lstrip().startswith("///")]
        declaration = re.split(r"[;{]", " ".join(rest[:12]))[0]
        text = line.split("///", 1)[1].strip()
        is_function = "(" in declaration and "decltype" not in declaration and not DECLARES_NO_FUNCTION.match(declaration)
        if is_function and not text.startswith("@") and not DOCSTRING_START.match(text):
            yield f"{name}:{number}: says neither what the function does nor what it returns: {text[:60]}"


def violations(rule):
    return [line for name, lines in files() for line in rule(name, lines)]


class Words(unittest.TestCase):
    def assertNone(self, found):
        if found:
            self.fail("\n" + "\n".join(found) + f"\n{len(found)} violations")

    def test_the_prose_is_found(self):
        self.assertGreater(sum(len(list(blocks_of(*file))) for file in files()), 4000)

    def test_private_words_are_not_used(self):
        self.assertNone(violations(private_words))

    def test_sentences_begin_with_their_subject(self):
        self.assertNone(violations(hidden_subjects))

    def test_pages_fit_a_screen(self):
        self.assertNone(violations(wide_lines))

    def test_docstrings_say_what_a_function_does(self):
        self.assertNone(violations(unclear_docstrings))

    def test_each_rule_finds_a_violation(self):
        self.assertEqual(len(list(private_words("a.h", ["// Fires the clay.", "", "// Bakes the recipe."]))), 2)
        self.assertEqual(len(list(hidden_subjects("a.h", ["// Counts. Of", "// a tile.", "int a;  ///< What it is.", "int b;  // As."]))), 3)
        self.assertEqual(len(list(hidden_subjects("a.md", ["| Those | a |", "- That is.", "Ends here. The same", "```", "As", "```"]))), 3)
        self.assertEqual(len(list(wide_lines("a.md", ["x" * 121, "x" * 120]))), 1)
        self.assertEqual(len(list(unclear_docstrings("a.h", ["/// Whether it is.", "bool f();", "/// Splits it.", "void g();", "/// Of it.",
                                                             "struct A {"]))), 1)


if __name__ == "__main__":
    sys.exit(unittest.main())
