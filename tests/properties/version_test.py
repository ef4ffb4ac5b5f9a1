#!/usr/bin/env python3
"""--version names the commit of the source, or the version alone where there is none; outputs do not name it."""
import re
import shutil
import subprocess
import unittest

from citykiln_program import ROOT, TOWN, TOWN_MIDDLE, ProgramTest, report_of, run

SCRIPT = ROOT / "compiler/commands/manual/built_commit.cmake"


def call(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True, **options).stdout.strip()


class Version(ProgramTest):
    def commit_of(self, source):
        """The commit that the build writes for a source folder."""
        out = self.folder / "built_commit.cpp"
        call("cmake", f"-DSOURCE={source}", f"-DOUT={out}", "-P", SCRIPT)
        return re.search(r'kBuiltCommit = "(.*)";', out.read_text())[1]

    def repository(self, name):
        folder = self.folder / name
        folder.mkdir()
        author = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
        call("git", "init", "-q", cwd=folder)
        call("git", *author, "commit", "-q", "--allow-empty", "-m", "first", cwd=folder)
        return folder

    def test_the_program_names_a_commit_of_its_source(self):
        version = run("--version").stdout
        self.assertRegex(version, r"^citykiln \d+\.\d+\.\d+( \(\S+\))?\n$")
        if shutil.which("git") and (ROOT / ".git").exists():
            named = re.search(r"\((?:.*-g)?([0-9a-f]+|v[0-9.]+)\)", version)[1]
            self.assertTrue(call("git", "rev-parse", "--verify", f"{named}^{{commit}}", cwd=ROOT))

    def test_a_build_names_the_commit_or_the_tag_before_it(self):
        source = self.repository("source")
        self.assertEqual(self.commit_of(source), f" ({call('git', 'rev-parse', '--short=8', 'HEAD', cwd=source)})")
        call("git", "tag", "v1.0", cwd=source)
        self.assertEqual(self.commit_of(source), " (v1.0)")

    def test_a_tarball_has_no_commit_even_within_another_repository(self):
        tarball = self.repository("other") / "citykiln-0.1.0"
        tarball.mkdir()
        self.assertEqual(self.commit_of(tarball), "")
        alone = self.folder / "alone"
        alone.mkdir()
        self.assertEqual(self.commit_of(alone), "")

    def test_outputs_have_the_version_alone(self):
        out = self.compiled("out", "--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--emit", "kiln,glb", "--lods", "12.5")
        self.assertRegex(report_of(out)["program"], r"^citykiln \d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
