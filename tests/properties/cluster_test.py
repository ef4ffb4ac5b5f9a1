#!/usr/bin/env python3
"""Plans run by Slurm and by Ninja end whole, with the bytes of an undisturbed run, though tasks, nodes and the controller are killed.

Slurm runs on this machine (small_cluster.py); its tests are skipped without root or without its packages.
"""
import fcntl
import json
import math
import os
import random
import shutil
import subprocess
import time
import unittest
from pathlib import Path

from citykiln_program import PROGRAM, TOWN, ProgramTest, bytes_of_outputs, run
from small_cluster import SmallCluster, kill_process, processes_with, wait_until, why_not


def many_houses(path, houses_a_side, spacing_m):
    """Writes a map of equal houses on a square grid."""
    lat_deg, lon_deg, side_m = 53.5, 13.0, houses_a_side * spacing_m
    north, east = 1 / 111200, 1 / (111200 * math.cos(math.radians(lat_deg)))
    place = lambda x, y: (lat_deg + y * north, lon_deg + x * east)
    nodes, ways = [], []
    for x, y in ((i % houses_a_side, i // houses_a_side) for i in range(houses_a_side ** 2)):
        corners = [place((x + 0.4) * spacing_m + dx, (y + 0.4) * spacing_m + dy) for dx, dy in ((0, 0), (10, 0), (10, 8), (0, 8))]
        ids = range(len(nodes) + 1, len(nodes) + 5)
        nodes += [f'<node id="{i}" lat="{lat:.7f}" lon="{lon:.7f}"/>' for i, (lat, lon) in zip(ids, corners)]
        references = "".join(f'<nd ref="{i}"/>' for i in (*ids, ids[0]))
        ways.append(f'<way id="{len(ways) + 1}">{references}<tag k="building" v="yes"/>'
                    f'<tag k="building:levels" v="{1 + (x + y) % 4}"/></way>')
    bounds = "<bounds minlat='{:.7f}' minlon='{:.7f}' maxlat='{:.7f}' maxlon='{:.7f}'/>".format(*place(0, 0), *place(side_m, side_m))
    path.write_text("\n".join(['<osm version="0.6">', bounds, *nodes, *ways, "</osm>"]))
    return path


class ClusterTest(ProgramTest):
    def planned(self, map_path, *arguments, name="plan"):
        plan = self.folder / name
        done = run("plan", map_path, *arguments, "-o", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.regions = [region["region"] for region in json.loads((plan / "plan.json").read_text())["regions"]]
        return plan

    def assert_whole(self, plan, whole):
        done = run("gather", plan)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr)
        self.assertEqual(bytes_of_outputs(plan / "out"), bytes_of_outputs(whole))
        files = [entry["name"] for entry in json.loads((plan / "out" / "files.json").read_text())["files"]]
        self.assertEqual(len(files), len(set(files)))

    def assert_gather_names_missing(self, plan):
        done = run("gather", plan)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"missing: region -?\d+_-?\d+: (waiting|running|interrupted)")


class SlurmTest(ClusterTest):
    LIMIT_S = 300

    def setUp(self):
        super().setUp()
        if reason := why_not():
            self.skipTest(reason)
        self.cluster = self.enterContext(SmallCluster(self.folder / "cluster"))

    def submit(self, plan, *options):
        done = self.cluster.run(plan / "submit.sh", *options)
        self.assertEqual(done.returncode, 0, done.stderr)

    def tasks(self):
        """Process ids of running tasks."""
        return [process for process, name in self.cluster.processes().items() if name == Path(PROGRAM).name[:15]]

    def tasks_of(self, region):
        return [task for task in self.tasks() if region.encode() in (Path(f"/proc/{task}") / "cmdline").read_bytes().split(b"\0")]

    def kill_task_and_step(self, task):
        """Returns whether both were there. The controller learns of neither."""
        step = self.cluster.step_of(task)
        return step is not None and kill_process(step) and kill_process(task)

    def wait_for_the_end(self):
        """Lets the controller look for lost tasks, which it does every 2 minutes by itself."""
        limit = time.monotonic() + self.LIMIT_S
        while self.cluster.unfinished_tasks() != []:
            self.assertLess(time.monotonic(), limit, self.cluster.unfinished_tasks())
            self.cluster.run("scontrol", "reconfigure")
            for _ in range(10):
                if self.cluster.unfinished_tasks() == []:
                    return
                time.sleep(0.5)


class SlurmCompilesATown(SlurmTest):
    def test_a_task_killed_with_its_step_is_queued_again(self):
        arguments = (TOWN / "town.osm", "--lods", "2.5", "--tile", "256")
        whole = self.compiled("whole", *arguments)
        plan = self.planned(*arguments, "--region", 1024)
        region = self.regions[0]
        (plan / "state").mkdir()
        # the task waits for the lock of its region, so that it is there to be killed
        with open(plan / "state" / f".{region}.lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.submit(plan)
            wait_until(lambda: any(map(self.kill_task_and_step, self.tasks_of(region))), 120)
        self.assert_gather_names_missing(plan)
        self.wait_for_the_end()
        self.assertTrue((plan / "out" / "report.json").exists(), (plan / "log" / "gather.txt").read_text())
        self.assert_whole(plan, whole)


class ManyRegions(ClusterTest):
    """A town of equal houses, one a region."""
    HOUSES_A_SIDE = 32
    ARGUMENTS = ("--lods", "0.5,2.5", "--tile", "256")

    def setUp(self):
        super().setUp()
        self.map_path = many_houses(self.folder / "houses.osm", self.HOUSES_A_SIDE, 256)
        self.whole = self.compiled("whole", self.map_path, *self.ARGUMENTS)
        self.plan = self.planned(self.map_path, *self.ARGUMENTS, "--region", 256, "--halo", 512)
        self.assertGreaterEqual(len(self.regions), self.HOUSES_A_SIDE**2)
        self.draw = random.Random(5)


class SlurmCompilesAThousandRegions(SlurmTest, ManyRegions):
    LIMIT_S = 1800

    def kill_some(self, count):
        """Kills tasks, two in three of them with the step above."""
        killed = 0
        while killed < count and self.cluster.unfinished_tasks() != []:
            for task in self.tasks():
                killed += self.kill_task_and_step(task) if self.draw.random() < 0.67 else kill_process(task)
                time.sleep(self.draw.uniform(0, 0.5))
            self.cluster.run("scontrol", "reconfigure")

    def lose_a_node(self, node):
        """Ends the processes of a node at once, as if its power failed, and brings it back after its tasks were queued again."""
        self.cluster.kill(node)
        for task in self.tasks():
            if self.cluster.node_of(task) == node:
                self.kill_task_and_step(task)
        wait_until(lambda: self.cluster.state_of(node).startswith("down"), 120)
        self.cluster.start(node)
        wait_until(lambda: not self.cluster.state_of(node).startswith("down"), 120)

    def test_slurm_ends_whole_though_tasks_a_node_and_the_controller_are_killed(self):
        self.submit(self.plan)
        self.kill_some(30)
        self.assert_gather_names_missing(self.plan)
        self.lose_a_node("n2")
        self.kill_some(30)
        self.cluster.kill("slurmctld")
        time.sleep(2)
        self.cluster.start("slurmctld")
        wait_until(lambda: self.cluster.unfinished_tasks() is not None, 60)
        self.wait_for_the_end()
        self.assertTrue((self.plan / "out" / "report.json").exists(), (self.plan / "log" / "gather.txt").read_text()[-2000:])
        self.assert_whole(self.plan, self.whole)


class NinjaCompilesAThousandRegions(ManyRegions):
    LEAST_KILLS = 10
    LONGEST_S = 2

    def finished(self):
        """The number of regions that are whole."""
        return len(list((self.plan / "state").glob("*.json")))

    def wait_for_a_moment(self):
        """Waits for a random time, or until so many regions are whole that the kills are spread over half of them."""
        enough = self.finished() + len(self.regions) / 4 / self.LEAST_KILLS
        end = time.monotonic() + self.draw.uniform(0.2, self.LONGEST_S)
        while time.monotonic() < end and self.finished() < enough:
            time.sleep(0.005)

    def test_ninja_ends_whole_though_it_and_its_tasks_are_killed(self):
        if shutil.which("ninja") is None:
            self.skipTest("ninja is missing")
        ninja = ["ninja", "-C", str(self.plan)]
        kills = 0
        # about half of the regions are left for the end
        while kills < 4 * self.LEAST_KILLS and self.finished() < len(self.regions) / 2:
            process = subprocess.Popen(ninja, stdout=subprocess.DEVNULL, env={**os.environ, "TEST_FOLDER": str(self.folder)})
            self.wait_for_a_moment()
            # ninja itself too, every second time; else it reports the task and ends by itself
            kills_ninja = self.draw.random() < 0.5
            for task in processes_with("TEST_FOLDER", self.folder):
                if kills_ninja or task != process.pid:
                    kill_process(task)
            process.wait()
            kills += 1
        self.assertGreaterEqual(kills, self.LEAST_KILLS)
        self.assert_gather_names_missing(self.plan)
        done = subprocess.run(ninja, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assert_whole(self.plan, self.whole)


class NinjaCompilesAFewRegions(NinjaCompilesAThousandRegions):
    HOUSES_A_SIDE = 3
    LEAST_KILLS = 2


if __name__ == "__main__":
    unittest.main(verbosity=2)
