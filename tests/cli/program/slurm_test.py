#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The scripts of tools/slurm on a Slurm of this one machine: a picture by windows, of which one is killed and tried again, and a
sequence by ranges. Skipped where Slurm is not installed (Debian: slurm-wlm, munge). A hard limit of time ends it, servers too.

  slurm_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
import slurm

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRIPTS = ROOT / "tools/slurm"
MODEL = ROOT / "data/spot/spot_slab5.glb"
LIMIT_S = 400

# Stands for the program: the first try of one task waits until it is killed.
KILLED_ONCE = """#!/bin/bash
if [ "$1" = render ] && [ "$SLURM_ARRAY_TASK_ID" = 3 ] && [ ! -e {folder}/killed ]; then
    echo $$ > {folder}/number.new && mv {folder}/number.new {folder}/number
    exec sleep 300
fi
exec {program} "$@"
"""


def end_in_time(*_):
    raise TimeoutError(f"the test took more than {LIMIT_S} s")


def stop_at_signal(*_):
    raise SystemExit("ended by a signal")


@unittest.skipUnless(slurm.is_installed(), "Slurm is not installed")
class Slurm(program.Case):
    def setUp(self):
        super().setUp()
        for number, handler in ((signal.SIGALRM, end_in_time), (signal.SIGTERM, stop_at_signal)):
            self.addCleanup(signal.signal, number, signal.signal(number, handler))
        self.addCleanup(signal.alarm, 0)
        signal.alarm(LIMIT_S)
        (self.folder / "slurm").mkdir()
        self.slurm = slurm.Cluster(self.folder / "slurm")
        self.addCleanup(self.slurm.stop)
        self.slurm.start()

    def wait_for_job(self, job, state="COMPLETED"):
        def has_ended():
            now = self.slurm.job(job)["JobState"]
            if now not in ("PENDING", "CONFIGURING", "RUNNING", "COMPLETING", state):
                self.fail(f"job {job} is {now}\n{self.logs()}")
            return now == state
        self.slurm.wait_for(has_ended, f"job {job}", 120)

    def logs(self):
        return "\n".join(f"{log}: {log.read_text(errors='replace')}" for log in sorted(self.folder.glob("**/*.log")))[-8000:]

    def test_windows_are_joined_to_the_whole_though_a_task_is_killed(self):
        stand_in = self.write("rakelight", KILLED_ONCE.format(folder=self.folder, program=program.PROGRAM))
        stand_in.chmod(0o755)
        out = self.slurm.run(SCRIPTS / "submit_windows.sh", "--resolution", "603,401", "--grid", "3x2", "-o", "joined.png",
                             "--", stand_in, "render", MODEL, cwd=self.folder)
        _, array, _, join = out.split()
        # Task 3 is killed, by its number, when it runs.
        self.slurm.wait_for((self.folder / "number").exists, "the task that is to be killed")
        (self.folder / "killed").touch()
        os.kill(int((self.folder / "number").read_text()), signal.SIGKILL)
        # Its exit code is 137, so that it waits for its next try; Slurm puts that off, and the join waits for it.
        task = f"{array}_3"
        self.slurm.wait_for(lambda: self.slurm.job(task).get("Restarts") == "1" and self.slurm.job(task)["JobState"] == "PENDING", "the second try")
        self.assertEqual(self.slurm.job(join)["JobState"], "PENDING")
        self.assertFalse((self.folder / "joined.png").exists())
        self.slurm.run("scontrol", "update", f"jobid={task}", "starttime=now")
        self.wait_for_job(join)
        self.assertEqual(self.slurm.job(task)["JobState"], "COMPLETED")
        self.assertEqual(len(list((self.folder / "joined-parts").glob("*.png"))), 6)
        self.draw(MODEL, "--resolution", "603,401", "-o", "whole.png")
        self.assertEqual((self.folder / "joined.png").read_bytes(), (self.folder / "whole.png").read_bytes())
        self.keep("joined.png")

    def test_a_task_that_fails_ends_the_join_and_what_is_missing_can_be_rendered(self):
        stand_in = self.write("rakelight", f'#!/bin/bash\n[ "$1" = render ] && [ "$SLURM_ARRAY_TASK_ID" = 1 ] && [ ! -e mended ] && exit 4\nexec {program.PROGRAM} "$@"\n')
        stand_in.chmod(0o755)
        words = ("--resolution", "90,60", "--grid", "2x1", "-o", "joined.exr", "--", stand_in, "render", MODEL)
        _, _, _, join = self.slurm.run(SCRIPTS / "submit_windows.sh", *words, cwd=self.folder).split()
        self.wait_for_job(join, "CANCELLED")
        self.assertFalse((self.folder / "joined.exr").exists())
        with self.assertRaisesRegex(RuntimeError, "--resume"):
            self.slurm.run(SCRIPTS / "submit_windows.sh", *words, cwd=self.folder)
        self.write("mended", "")
        _, _, _, join = self.slurm.run(SCRIPTS / "submit_windows.sh", "--resume", *words, cwd=self.folder).split()
        self.wait_for_job(join)
        self.draw(MODEL, "--resolution", "90,60", "-o", "whole.exr")
        self.assertEqual((self.folder / "joined.exr").read_bytes(), (self.folder / "whole.exr").read_bytes())

    def test_frames_go_out_by_ranges(self):
        """Any command with a range: here one that only writes down what it is told."""
        out = self.slurm.run(SCRIPTS / "submit_frames.sh", "--frames", "5:14", "--chunk", "4", "--logs", "logs", "--then", "cat logs/frames-*.log > all",
                             "--", "echo", "--frames", "{first}:{last}", "-o", "out/{n}.png", "two words", cwd=self.folder)
        _, array, _, after = out.split()
        self.wait_for_job(after)
        lines = (self.folder / "all").read_text().splitlines()
        self.assertEqual([line.split(" --threads ")[0] for line in lines],
                         [f"--frames {words} -o out/{{n}}.png two words" for words in ("5:8", "9:12", "13:14")])
        self.assertEqual(self.slurm.job(f"{array}_2")["JobState"], "COMPLETED")

    def test_frames_of_a_model_are_those_of_one_run(self):
        if "--frames" not in self.run_program("render", "--help").out:
            self.skipTest("render has no --frames")
        walk = (MODEL, "--turntable", "6", "--resolution", "80,60")
        _, _, _, after = self.slurm.run(SCRIPTS / "submit_frames.sh", "--frames", "0:5", "--chunk", "2", "--then", "true", "--", program.PROGRAM, "render", *walk,
                                        "--frames", "{first}:{last}", "-o", "array/{n}.png", "--skip-existing", cwd=self.folder).split()
        self.wait_for_job(after)
        self.draw(*walk, "-o", "whole/{n}.png")
        whole = {p.name: p.read_bytes() for p in (self.folder / "whole").iterdir()}
        self.assertEqual(len(whole), 6)
        self.assertEqual({p.name: p.read_bytes() for p in (self.folder / "array").iterdir()}, whole)

    def draw(self, *words):
        """As the tasks do it: in the default look."""
        done = subprocess.run([program.PROGRAM, "render", *map(str, words)], cwd=self.folder, timeout=100, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def keep(self, name):
        """For people who want to look: RAKELIGHT_KEEP names a folder."""
        if os.environ.get("RAKELIGHT_KEEP"):
            shutil.copy(self.folder / name, os.environ["RAKELIGHT_KEEP"])


class Refusals(program.Case):
    def refused(self, script, *words):
        done = subprocess.run([SCRIPTS / script, *words], cwd=self.folder, capture_output=True, text=True, timeout=20)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertEqual(self.files(), [])
        return done.stderr

    def test_wrong_words_are_one_line_and_start_nothing(self):
        right = {"--resolution": "90,60", "--grid": "2x1", "-o": "a.png"}
        for option, wrong in (("--resolution", "90"), ("--resolution", "0,60"), ("--grid", "2"), ("--grid", "91x1"), ("-o", "a.jpg"), ("-o", "")):
            words = [word for pair in {**right, option: wrong}.items() for word in pair]
            self.refused("submit_windows.sh", *words, "--", "rakelight", "render", "a.glb")
        words = [word for pair in right.items() for word in pair]
        for rest in ((), ("--",), ("--", "rakelight", "a.glb"), ("--", "render", "a.glb"), ("--fast", "--", "rakelight", "render")):
            self.refused("submit_windows.sh", *words, *rest)
        command = ("--", "rakelight", "render", "a.glb", "--frames", "{first}:{last}")
        for words in (("--frames", "1:2"), ("--chunk", "2"), ("--frames", "3:2", "--chunk", "2"), ("--frames", "1:2", "--chunk", "0"), ("--frames",)):
            self.refused("submit_frames.sh", *words, *command)
        self.assertIn("{first}", self.refused("submit_frames.sh", "--frames", "1:2", "--chunk", "1", "--", "rakelight", "render"))


if __name__ == "__main__":
    program.main()
