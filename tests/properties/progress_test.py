#!/usr/bin/env python3
"""Verbs that take more than a second show on a terminal what they do, how far and how long; they are quiet in pipes and with --quiet.
Ctrl-C ends each with one line and leaves folders as they were."""
import os
import pty
import re
import signal
import subprocess
import time
import unittest

from citykiln_program import PROGRAM, ROOT, TOWN, ProgramTest, run, sha256

MANY_SAMPLES = ["--size", "320x240", "--spp", "512"]


def files_below(folder):
    return {str(path.relative_to(folder)): sha256(path) for path in folder.rglob("*") if path.is_file()}


class OnTerminal:
    """A command whose standard error is a terminal."""

    def __init__(self, *arguments):
        self.side, terminal = pty.openpty()
        self.process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=terminal, cwd=ROOT)
        os.close(terminal)
        self.text = ""

    def read_until(self, pattern, seconds=120):
        """Reads what is shown until a pattern is there or the command has ended."""
        end = time.monotonic() + seconds
        while not re.search(pattern, self.text) and time.monotonic() < end:
            try:
                self.text += os.read(self.side, 4096).decode()
            except OSError:  # the command has ended
                break
        return re.search(pattern, self.text)

    def kill(self):
        """Ends the command if a test has failed before its end."""
        self.process.kill()
        self.process.wait()

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)
        self.read_until(r"(?!)")
        os.close(self.side)
        return self.process.wait()


class Progress(ProgramTest):
    def on_terminal(self, *arguments):
        shown = OnTerminal(*arguments)
        self.addCleanup(shown.kill)
        return shown

    def town(self):
        return self.compiled_once("--spec", TOWN / "spec.json", "--lods", "2.5,12.5", "--emit", "kiln,glb")

    def commands(self):
        """Commands that take seconds, and the line that each says when it is interrupted."""
        town, own = self.town(), self.folder
        run_stays = "the output folder holds the earlier run, if there was one, and the same command goes on with the tiles baked so far"
        return [
            (["compile", "--spec", TOWN / "spec.json", "--lods", "0.1", "-o", own / "run"], run_stays),
            (["bake", town, "--lods", "0.1", "-o", own / "run"], run_stays),
            (["bake", town, "--tolerance", "0.1", "-o", own / "one.glb"], "nothing was written"),
            (["check", town], "the run is as before"),
            (["invent", "--kind", "city", "--size", "16384", "-o", own / "world"], "nothing was written"),
        ]

    def test_a_terminal_shows_stage_and_share_and_ctrl_c_leaves_folders_as_they_were(self):
        before = files_below(self.town())
        for words, line in self.commands():
            with self.subTest(verb=words[0]):
                shown = self.on_terminal(*words)
                self.assertTrue(shown.read_until(r"\r[a-z ]+ +\[[#.]{30}\] +\d+ %|\r[a-z ]+ \d+:\d\d so far"), shown.text)
                self.assertEqual(shown.interrupt(), 130, shown.text)
                last = shown.text.replace("\r\n", "\n").rsplit("\x1b[K", 1)[1]
                self.assertEqual(last, f"citykiln: interrupted; {line}\n")
                self.assertEqual(files_below(self.town()), before)
                self.assertEqual([path for path in self.folder.rglob("*") if path.is_file() and ".new" not in path.parts], [])

    def test_a_picture_shows_the_time_left_and_ctrl_c_writes_it_so_far(self):
        picture = self.folder / "town.png"
        shown = self.on_terminal("preview", self.town(), "--level", 1, *MANY_SAMPLES, "-o", picture)
        self.assertTrue(shown.read_until(r"render +\[[#.]{30}\] +\d+ %, \d+:\d\d left"), shown.text)
        self.assertEqual(shown.interrupt(), 0, shown.text)
        self.assertEqual(shown.text.count("interrupted"), 1, shown.text)
        self.assertTrue(picture.exists())

    def test_pipes_and_quiet_show_nothing(self):
        words = ["compile", "--spec", TOWN / "spec.json", "--lods", "2.5", "-o", self.folder / "run"]
        self.assertEqual(run(*words).stderr, "")
        shown = self.on_terminal(*words, "--quiet")
        self.assertFalse(shown.read_until(r"."), shown.text)
        shown.process.wait()
        os.close(shown.side)


if __name__ == "__main__":
    unittest.main()
