#!/usr/bin/env python3
"""Every link in a page leads to a file and a heading, ARCHITECTURE.md names what exists, compiler/settings.md lists every setting, and
all files that state the version agree with CMakeLists.txt."""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def documents():
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [ROOT / name for name in listed.splitlines()]


def anchors_of(page):
    """The anchors of a page's headings, as GitHub makes them, and those that the page sets itself."""
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    headings = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading) for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)]
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings} | set(re.findall(r'<a id="([^"]+)"', text))


# A file that states the version, and the text around it.
VERSIONS = {"README.md": "citykiln_{}-1_amd64.deb", "package/changelog.Debian": "citykiln ({}-1)",
            "exporters/blender/citykiln/blender_manifest.toml": '\nversion = "{}"', "exporters/godot/godot3/addons/citykiln/plugin.cfg": '\nversion="{}"',
            "exporters/godot/godot4/addons/citykiln/plugin.cfg": '\nversion="{}"', "CHANGELOG.md": "\n## {}"}


class Version(unittest.TestCase):
    def test_is_the_same_in_all_files(self):
        version = re.search(r"project\(citykiln VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
        for name, text in VERSIONS.items():
            self.assertIn(text.format(version), (ROOT / name).read_text(), name)


class Links(unittest.TestCase):
    def test_lead_to_files(self):
        dead = []
        self.assertGreater(len(documents()), 10)
        for document in documents():
            for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text()):
                if not (document.parent / target).exists():
                    dead.append(f"{document.relative_to(ROOT)}: {target}")
        self.assertEqual(dead, [], "\n" + "\n".join(dead))

    def test_anchors_lead_to_headings(self):
        dead = []
        for document in documents():
            for target, anchor in re.findall(r"\]\(([^)#:\s]*)#([^)\s]+)\)", document.read_text()):
                page = document.parent / target if target else document
                if page.suffix == ".md" and anchor not in anchors_of(page):
                    dead.append(f"{document.relative_to(ROOT)}: {target}#{anchor}")
        self.assertEqual(dead, [], "\n" + "\n".join(dead))

    def test_names_in_the_architecture_exist(self):
        page = (ROOT / "ARCHITECTURE.md").read_text()
        listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
        files = set(re.findall(r"[\w/]*\w+\.(?:h|cpp|inc|cga|py|txt|md)\b", page))
        self.assertGreater(len(files), 50)
        self.assertEqual([name for name in files if not any(f"/{path}".endswith(f"/{name}") for path in listed)], [])
        code = "\n".join((ROOT / path).read_text() for path in listed if re.match(r"compiler/.*\.(h|cpp|inc)$", path))
        self.assertEqual([name for name in re.findall(r"`(k[A-Z]\w+)`", page) if not re.search(rf"\b{name}\b", code)], [])

    def test_settings_are_listed_in_their_order(self):
        settings = re.findall(r'^    \{"([a-z-]+)", ', (ROOT / "compiler" / "settings.cpp").read_text(), re.MULTILINE)
        self.assertGreater(len(settings), 10)
        rows = re.findall(r"^\| ([a-z-]+) \|", (ROOT / "compiler" / "settings.md").read_text(), re.MULTILINE)
        self.assertEqual(rows[1:], settings)  # the first row is the head


if __name__ == "__main__":
    sys.exit(unittest.main())
