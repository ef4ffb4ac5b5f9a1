#!/usr/bin/env python3
"""preview --interactive shows a picture in a window, moves by keys, writes pictures, and says one line without a display.

The display is Xvfb's; its screen is read from the file that it is kept in (X window dump).
"""
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from citykiln_program import PROGRAM

ROOT = Path(__file__).resolve().parents[2]
SKIPPED = 77


def screen(path):
    """The bytes of blue, green and red of all pixels of an X window dump of 32 bits a pixel."""
    data = path.read_bytes()
    header = struct.unpack(">25I", data[:100])
    height, row_bytes, colours = header[5], header[12], header[19]
    begin = header[0] + colours * 12
    return data[begin:begin + row_bytes * height]


def run_in_display(folder, command):
    """Starts a virtual display with its screen in a file, and runs a shell command in it."""
    return subprocess.run(["xvfb-run", "-a", "-s", f"-screen 0 640x480x24 -fbdir {folder}", "sh", "-c", command],
                          capture_output=True, text=True, timeout=240, check=False)


class Window(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="citykiln_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def test_shows_a_picture_that_keys_move(self):
        out = self.folder / "out"
        made = subprocess.run([PROGRAM, "compile", "--spec", ROOT / "examples/town/spec.json", "--emit", "kiln", "-o", out,
                               "--only", "0_0"], capture_output=True, text=True, check=False, cwd=ROOT)
        self.assertEqual(made.returncode, 0, made.stderr)
        picture = self.folder / "p.png"
        command = f"""
            timeout 200 {PROGRAM} preview {out}/scene.kiln --tolerance 2.5 --view low --size 320x180 --spp 4 --interactive -o {picture} &
            pid=$!
            window=$(timeout 150 sh -c 'until xdotool search --name "^citykiln$" 2>/dev/null; do sleep 0.3; done' | tail -1)
            sleep 8
            cp {self.folder}/Xvfb_screen0 {self.folder}/before
            xdotool windowfocus $window
            xdotool keydown --window $window w; sleep 3; xdotool keyup --window $window w
            sleep 8
            cp {self.folder}/Xvfb_screen0 {self.folder}/after
            xdotool key --window $window p
            sleep 4
            xdotool key --window $window Escape 2>/dev/null
            wait $pid"""
        done = run_in_display(self.folder, command)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        before, after = screen(self.folder / "before"), screen(self.folder / "after")
        # the window covers 3/16 of the screen
        bright = sum(1 for i in range(0, len(before), 4) if before[i + 1] > 30)
        self.assertGreater(bright, 0.5 * 320 * 180)
        moved = sum(1 for i in range(0, len(before), 4) if abs(before[i + 1] - after[i + 1]) > 8)
        self.assertGreater(moved, 0.05 * 320 * 180)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def test_without_a_display_is_one_clear_line(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([PROGRAM, "preview", "absent.kiln", "--interactive"], capture_output=True, text=True,
                              env=environment, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("--interactive", done.stderr)


if __name__ == "__main__":
    if not shutil.which("xvfb-run") or not shutil.which("xdotool"):
        print("skipped: needs xvfb-run and xdotool")
        sys.exit(SKIPPED)
    unittest.main()
