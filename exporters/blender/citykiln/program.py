"""Runs the citykiln program and follows its progress bar. Does not need Blender."""
import os
import re
import shutil
import subprocess
import tempfile
import threading

from .run_folder import RunError

# of a drawn bar: "bake                   [####......]  40 %, 0:12 left"
BAR = re.compile(r"([a-z0-9 ]+?) +\[[#.]+\] +(\d+) %")


def found_program(path):
    """The program's path. Error: there is none. @param path  Of the preferences; "citykiln" is looked for on the PATH."""
    program = shutil.which(path or "citykiln")
    if program is None:
        raise RunError(f"{path or 'citykiln'}: there is no such program; install citykiln, or set its path in Edit > Preferences > "
                       "Add-ons > citykiln")
    return program


def compile_command(program, map_path, heightmaps, box, target, out):
    """The arguments of a compile."""
    command = [program, "compile", map_path, "-o", out, "--target", target]
    if heightmaps:
        command += ["--dem", *heightmaps]
    # = because a box may begin with a minus
    return command + ([f"--bbox={box}"] if box.strip() else [])


class Job:
    """The program while it runs: `stage` and `share` of its bar."""

    def __init__(self, command):
        self.stage, self.share, self.last_line = "", 0.0, ""
        self.output = tempfile.TemporaryFile()
        bar, end = open_terminal()
        try:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.output, stderr=end)
        except OSError as error:
            raise RunError(f"{command[0]}: cannot be run: {error.strerror}") from None
        finally:
            os.close(end)
        self.reader = threading.Thread(target=self._follow, args=(bar,), daemon=True)
        self.reader.start()

    def is_running(self):
        return self.process.poll() is None

    def stop(self):
        """Ends the program as Ctrl-C does: the folder stays as it was."""
        self.process.terminate()
        self.process.wait()

    def check(self):
        """Error: the program failed; its own line says why."""
        code = self.process.wait()
        self.reader.join(timeout=5)
        if code not in (0, 2):
            raise RunError(self.last_line or f"citykiln ended with code {code}")

    def _follow(self, bar):
        """Reads what the program draws, until it ends."""
        rest = ""
        while True:
            try:
                data = os.read(bar, 4096)
            except OSError:  # the terminal of a program that has ended
                break
            if not data:
                break
            *pieces, rest = re.split(r"[\r\n]", rest + data.decode("utf-8", "replace"))
            for piece in pieces + [rest]:
                self._take(piece.replace("\x1b[K", "").strip())
        os.close(bar)

    def _take(self, line):
        drawn = BAR.match(line)
        if drawn:
            self.stage, self.share = drawn[1], int(drawn[2]) / 100
        elif line:
            self.last_line = line.removeprefix("citykiln: ")


def open_terminal():
    """Two ends of a terminal, on which the program draws its bar; of a pipe where the system has no terminals: no bar there."""
    try:
        import pty
        return pty.openpty()
    except ImportError:
        return os.pipe()
