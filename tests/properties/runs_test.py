#!/usr/bin/env python3
"""The folder of a run holds a finished run at every moment: after kill -9, Ctrl-C, a full disk, a run with other levels, and among files
of someone else. A run that was interrupted goes on, and ends with the bytes of one that was not."""
import json
import resource
import shutil
import signal
import subprocess
import time
import unittest

from citykiln_program import IS_FULL, PROGRAM, ROOT, TOWN, TOWN_MIDDLE, ProgramTest, report_of, run, sha256

MOMENTS = 12 if IS_FULL else 5
LEVELS = "1,2.5,5" if IS_FULL else "12.5,25,50"


def town():
    spec = json.loads((TOWN / "spec.json").read_text())
    return [TOWN / "town.osm", "--dem", spec["dem"], "--tile", "128", *TOWN_MIDDLE]


def contents(folder):
    """Name to hash of all files of a run, without the times and what is not finished."""
    return {str(path.relative_to(folder)): sha256(path) for path in sorted(folder.rglob("*"))
            if path.is_file() and path.name != "timing.json" and ".new" not in path.parts}


class Runs(ProgramTest):
    def town(self, name, levels, *arguments, **options):
        return self.compiled(name, *town(), "--lods", levels, *arguments, **options)

    def whole(self, levels=LEVELS):
        """A run that was not disturbed, for all tests to read."""
        return self.compiled_once(*town(), "--lods", levels)

    def command(self, out, levels=LEVELS):
        return [PROGRAM, "compile", *map(str, town()), "--lods", levels, "-o", str(out)]

    def killed_after(self, seconds, out, how=signal.SIGKILL):
        process = subprocess.Popen(self.command(out), cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.send_signal(how)
        return process.communicate()[1], process.returncode

    def killed_with_tiles(self, out, how=signal.SIGKILL, tiles=3):
        """Ends a run after some tiles are whole, and returns its last words and exit code."""
        process = subprocess.Popen(self.command(out), cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and len(list(out.glob(".new/glb/*.glb"))) < tiles:
            time.sleep(0.002)
        process.send_signal(how)
        return process.communicate()[1], process.returncode

    def assertChecked(self, out):
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    # ---- interruptions

    def test_a_kill_at_any_moment_leaves_a_whole_run_and_the_next_goes_on(self):
        begin = time.monotonic()
        new = contents(self.town("timed", LEVELS))
        seconds = time.monotonic() - begin
        self.assertGreater(len(new), 8)
        old = self.town("out", "12")
        (old / "notes.txt").write_text("mine")
        before = contents(old)
        ends = set()
        for moment in range(MOMENTS):
            # every fourth run goes on with what the one before left
            if moment % 4:
                shutil.rmtree(old / ".new", ignore_errors=True)
            # SIGABRT: how a failed assertion ends a run
            self.killed_after(seconds * (moment + 0.5) / MOMENTS, old, signal.SIGABRT if moment % 2 else signal.SIGKILL)
            # reading the folder finishes a commit that was interrupted
            self.assertEqual(run("inspect", old).returncode, 0)
            now = contents(old)
            self.assertIn(now, (before, {**new, "notes.txt": before["notes.txt"]}), f"moment {moment}")
            ends.add(now == before)
            if now != before:
                self.town("out", "12")
        self.assertIn(True, ends)
        self.town("out", LEVELS)
        self.assertEqual(contents(old), {**new, "notes.txt": before["notes.txt"]})
        self.assertFalse((old / ".new").exists())
        self.assertChecked(old)

    def test_whole_tiles_are_not_baked_again_and_bytes_are_those_of_one_run(self):
        new = contents(self.whole())
        out = self.folder / "out"
        self.killed_with_tiles(out)
        whole = {path.name: path.stat().st_mtime_ns for path in out.glob(".new/glb/*.glb")}
        self.assertTrue(whole)
        done = subprocess.run(self.command(out), cwd=ROOT, capture_output=True, text=True, check=True)
        self.assertRegex(done.stdout, r"note: \d+ of \d+ tile files were whole")
        self.assertEqual(contents(out), new)
        same = [name for name, at in whole.items() if (out / "glb" / name).stat().st_mtime_ns == at]
        # the last file may have been whole without an entry in the journal
        self.assertGreaterEqual(len(same), len(whole) - 1)

    def test_tiles_of_other_settings_are_baked_again(self):
        out = self.folder / "out"
        self.killed_with_tiles(out)
        other = LEVELS + ",100"
        self.town("out", other)
        self.assertEqual(contents(out), contents(self.town("whole", other)))

    def test_a_damaged_tile_of_an_interrupted_run_is_baked_again(self):
        new = contents(self.whole())
        out = self.folder / "out"
        self.killed_with_tiles(out)
        tile = sorted(out.glob(".new/glb/*.glb"))[0]
        tile.write_bytes(bytes(tile.stat().st_size))
        self.town("out", LEVELS)
        self.assertEqual(contents(out), new)

    def test_ctrl_c_is_one_line_and_exit_130(self):
        out = self.town("out", "12")
        before = contents(out)
        words, status = self.killed_with_tiles(out, signal.SIGINT)
        self.assertEqual(status, 130)
        self.assertEqual(len(words.splitlines()), 1, words)
        self.assertIn("goes on", words)
        self.assertEqual(contents(out), before)

    def test_a_full_disk_leaves_the_earlier_run(self):
        out = self.town("out", "12")
        before = contents(out)
        largest = max(path.stat().st_size for path in (self.whole() / "glb").iterdir())
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (largest - 1, largest - 1))
        done = subprocess.run(self.command(out), cwd=ROOT, capture_output=True, text=True, check=False, preexec_fn=limit)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertEqual(contents(out), before)
        self.assertChecked(out)
        self.town("out", LEVELS)
        self.assertEqual(contents(out), contents(self.whole()))

    def test_a_full_small_disk_leaves_the_earlier_run(self):
        disk = self.folder / "disk"
        disk.mkdir()
        command = " ".join(self.command(disk / "out", "1,2.5,5"))
        coarse = " ".join(self.command(disk / "out", "12"))
        script = (f"mount -t tmpfs -o size=3m none {disk} && {coarse} && sha256sum {disk}/out/*.* >{self.folder}/before && "
                  f"{{ {command}; echo status $?; sha256sum -c --quiet {self.folder}/before && echo unchanged; "
                  f"{PROGRAM} check {disk}/out && echo checked; }}")
        done = subprocess.run(["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True, cwd=ROOT, check=False)
        if "unshare" in done.stderr or "mount" in done.stderr:
            self.skipTest("no right to mount a small disk")
        for word in ("status 1", "unchanged", "checked"):
            self.assertIn(word, done.stdout, done.stderr)
        self.assertIn("No space left", done.stderr)

    def test_two_runs_do_not_write_one_folder(self):
        out = self.folder / "out"
        first = subprocess.Popen(self.command(out), cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (out / ".new").exists():
            time.sleep(0.002)
        second = run("compile", *town(), "-o", out)
        first.wait()
        self.assertEqual(second.returncode, 1)
        self.assertIn("another run", second.stderr)
        self.assertEqual(first.returncode, 0)
        self.assertChecked(out)

    # ---- what stays and what goes

    def test_levels_of_an_earlier_run_are_gone(self):
        out = self.town("out", "1,2,4")
        self.town("out", "2.5")
        self.assertEqual({path.name.split("_L")[-1] for path in (out / "glb").iterdir()}, {"0.glb", "surroundings.glb"})
        self.assertEqual(contents(out), contents(self.whole("2.5")))

    def test_strange_files_stay_and_are_named(self):
        out = self.folder / "out"
        (out / "glb").mkdir(parents=True)
        for name in ("notes.txt", "glb/mine.glb"):
            (out / name).write_text("mine")
        for levels in ("2.5", "5"):
            done = subprocess.run(self.command(out, levels), cwd=ROOT, capture_output=True, text=True, check=True)
            self.assertIn("they stay: glb/mine.glb, notes.txt", done.stdout)
        self.assertEqual((out / "notes.txt").read_text() + (out / "glb" / "mine.glb").read_text(), "minemine")
        self.assertChecked(out)

    def test_check_finds_what_is_missing_broken_or_stale(self):
        def fails(out, *words):
            done = run("check", out)
            self.assertEqual(done.returncode, 1, done.stdout)
            for word in words:
                self.assertIn(word, done.stderr)

        out = self.town("out", "2.5")
        self.assertChecked(out)
        tile = sorted((out / "glb").iterdir())[0]
        whole = tile.read_bytes()
        tile.write_bytes(whole[:-4] + b"\1\2\3\4")
        fails(out, f"glb/{tile.name}", "another size or hash")
        tile.unlink()
        fails(out, f"glb/{tile.name}", "is missing")
        tile.write_bytes(whole)
        stale = out / "glb" / tile.name.replace("_L0", "_L7")
        stale.write_bytes(whole)
        fails(out, f"glb/{stale.name}", "not in files.json")
        stale.unlink()
        (out / "files.json").unlink()
        fails(out, "files.json is missing")

    # ---- findings, places and errors

    def test_findings_are_those_that_the_report_counts(self):
        out = self.town("out", "0.5,12.5")
        findings = json.loads((out / "findings.json").read_text())["features"]
        counts = {}
        for finding in findings:
            code = finding["properties"]["code"]
            counts[code] = counts.get(code, 0) + 1
        self.assertEqual(counts, {code: row["count"] for code, row in report_of(out)["diagnoses"].items()})
        self.assertTrue(counts)
        for finding in findings:
            if finding["properties"]["id"] is not None:
                self.assertIsNotNone(finding["geometry"], finding)
        layer = self.folder / "findings.geojson"
        for path in (out, out / "scene.kiln"):
            self.assertEqual(run("inspect", path, "--layer", "findings", "--geojson", layer).returncode, 0)
            self.assertEqual(layer.read_bytes(), (out / "findings.json").read_bytes())

    def test_every_verb_takes_the_folder_or_its_manifest(self):
        out = self.whole("2.5")
        for path in (out, out / "scene.kiln"):
            self.assertEqual(run("check", path).returncode, 0)
            self.assertEqual(run("inspect", path).returncode, 0)
            self.assertEqual(run("preview", path, "--tolerance", "5", "--size", "64x36", "--spp", "1", "-o",
                                 self.folder / "p.png").returncode, 0)
            baked = self.folder / "baked"
            self.assertEqual(run("bake", path, "--lods", "2.5", "-o", baked).returncode, 0)
            self.assertEqual(sorted(p.name for p in (baked / "glb").iterdir()), sorted(p.name for p in (out / "glb").iterdir()))

    def test_preview_of_a_run_without_tiles_is_that_of_its_manifest(self):
        out = self.town("recipes", "12.5", "--emit", "kiln")
        pictures = [self.folder / f"{name}.png" for name in ("folder", "manifest")]
        for path, picture in zip((out, out / "scene.kiln"), pictures):
            done = run("preview", path, "--size", "32x18", "--spp", "1", "-o", picture)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(*map(sha256, pictures))

    def test_a_file_without_a_tolerance_is_refused(self):
        out = self.whole("2.5")
        done = run("bake", out, "-o", self.folder / "x.glb")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("--tolerance", done.stderr)
        self.assertFalse((self.folder / "x.glb").exists())

    def test_strict_counts_the_codes_that_it_names(self):
        # small objects are left out when tiles are baked, after the map was compiled
        found = sorted(set(report_of(self.whole("2.5"))["diagnoses"]) - {"BelowTolerance"})[0]
        for codes, status in ((found, 2), (f"BrokenArea,{found}", 2), ("CoastlineOpen", 0)):
            done = run("compile", *town(), "--lods", "12.5", f"--strict={codes}", "-o", self.folder / "strict")
            self.assertEqual(done.returncode, status, done.stderr)
        done = run("compile", *town(), "--strict=Nonsense", "-o", self.folder / "none")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Nonsense", done.stderr)

    def test_errors_are_json_under_json(self):
        broken = self.folder / "broken.json"
        broken.write_text('{"map": \n  nonsense}')
        for arguments, file, place in ((["compile", "--spec", broken], str(broken), "2:4"),
                                       (["inspect", self.folder / "none.kiln"], str(self.folder / "none.kiln"), None),
                                       (["compile", "x.osm", "--tile", "1", "-o", "x"], None, "--tile")):
            done = run(*arguments, "--json")
            self.assertEqual(done.returncode, 1)
            error = json.loads(done.stdout)["error"]
            self.assertEqual((error["file"], error["place"]), (file, place))
            self.assertIn(error["message"], done.stderr)


if __name__ == "__main__":
    unittest.main()
