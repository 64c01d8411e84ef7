"""Batches on a Slurm of one node: arrays, the loss of a node, interrupts, kills. Skipped where Slurm is not installed."""

import json
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "program"))

from one_node import OneNode, missing
from program import CASE, PROGRAM, ProgramTest, main

SKIPPED = 77
KEY = "body.cylinder.material.poissons_ratio"


class Slurm(ProgramTest):
    def setUp(self):
        super().setUp()
        self.how = {"env": NODE.environment}
        NODE.run("scancel", "--me")
        NODE.wait_for(lambda: NODE.node_state() == "idle" and not NODE.queue(), "slurmctld")

    def sweep(self, count, *more, end=0.02, spacing=0.1):
        file = self.folder / "sweep.toml"
        settings = [f"discretisation.spacing={spacing}", "output.every=0.005", "time.step=0.001", f"time.end={end}"]
        file.write_text("\n".join([
            f'case = "{CASE}"', f"set = {json.dumps(settings)}", *more, "[[design]]",
            f'parameters."{KEY}" = {{ from = 0.1, to = 0.4, count = {count} }}', ""]))
        return file

    def command(self, file, *more):
        return ["batch", file, "--executor", "slurm", "--out", self.out, *more]

    def start(self, file, *more):
        process = subprocess.Popen([PROGRAM, *self.command(file, "--quiet", *more)], cwd=self.folder, **self.how)
        self.addCleanup(process.kill)
        return process

    def rows(self, out=None):
        status, text, err = self.pliant("batch", "status", out or self.out, "--json")
        self.assertEqual(0, status, err)
        return json.loads(text)

    def done(self):
        return sum(row["status"] == "done" for row in self.rows()) if (self.out / "batch.sqlite").exists() else 0

    def arrays(self):
        return len(list((self.out / "slurm").iterdir()))

    def test_fifty_runs_survive_the_loss_of_their_node_in_the_middle(self):
        file = self.sweep(50, "[slurm]", "runs_per_task = 5")
        process = self.start(file)
        self.wait_for(lambda: self.done() >= 10, process)
        NODE.lose()
        process.send_signal(signal.SIGINT)
        NODE.wait_for(lambda: "PENDING" not in NODE.queue(), "scancel")
        process.send_signal(signal.SIGINT)  # the node does not answer, so waiting is pointless
        process.wait(120)
        self.assertLess(self.done(), 50)
        NODE.start_node()
        status, _, err = self.pliant(*self.command(file, "--resume"), **self.how)
        self.assertEqual(0, status, err)
        self.assertIn("50 runs: 50 done, 0 running, 0 pending, 0 failed", err)
        here = self.folder / "here"
        self.assertEqual(0, self.pliant("batch", file, "--out", here, "--quiet")[0])
        self.assertEqual({row["name"]: row["measurements"] for row in self.rows(here)},
                         {row["name"]: row["measurements"] for row in self.rows()})
        self.assertTrue(all(row["peak_memory"] > 10**6 for row in self.rows()))

    def test_slurm_starts_a_task_again_that_its_node_has_lost(self):
        process = self.start(self.sweep(2, "[slurm]", "runs_per_task = 1", end=0.5))
        self.wait_for(lambda: any(self.out.glob("runs/*/checkpoint.h5")), process)
        NODE.lose()
        NODE.come_back()
        self.assertEqual(0, process.wait(120), self.rows())
        self.assertEqual([1, 2], [self.arrays(), self.done()])

    def test_an_interrupt_removes_the_tasks_and_leaves_checkpoints(self):
        file = self.sweep(4, "[slurm]", "runs_per_task = 1", end=0.5)
        process = self.start(file)
        self.wait_for(lambda: any(self.out.glob("runs/*/checkpoint.h5")), process)
        process.send_signal(signal.SIGINT)
        self.assertEqual(4, process.wait(120))
        self.assertEqual(set(), {"PENDING", "RUNNING"} & set(NODE.queue()))
        self.assertLessEqual({row["status"] for row in self.rows()}, {"pending", "done"})
        self.assertTrue(any(self.out.glob("runs/*/checkpoint.h5")))
        self.assertEqual(0, self.pliant(*self.command(file, "--resume", "--quiet"), **self.how)[0])
        self.assertEqual(4, self.done())

    def test_tasks_continue_when_the_program_is_killed_and_resume_finds_them(self):
        file = self.sweep(4, "[slurm]", "runs_per_task = 2", end=0.2)
        process = self.start(file)
        self.wait_for(lambda: any(self.out.glob("runs/*.attempt.json")), process)
        process.kill()
        process.wait()
        status, _, err = self.pliant("batch", file, "--out", self.out, "--resume", **self.how)
        self.assertEqual(2, status)
        self.assertIn("Slurm has runs of this batch", err)
        self.assertEqual(0, self.pliant(*self.command(file, "--resume", "--quiet"), **self.how)[0])
        self.assertEqual([1, 4], [self.arrays(), self.done()])
        self.assertEqual({1}, {row["attempts"] for row in self.rows()})

    def test_the_check_says_what_a_task_asks_for(self):
        process = self.start(self.sweep(2, "time_limit = 600", "[slurm]", 'options = ["--hold", "--comment=mine"]'),
                             "--threads", "2")
        self.wait_for(NODE.queue, process)
        asked = NODE.run("squeue", "--noheader", "--format=%C %m %l %k", "--array").splitlines()[0].split()
        self.assertEqual(["2", "mine"], [asked[0], asked[3]])
        text = self.pliant("check", CASE, "--set", "discretisation.spacing=0.1", "--json")[1]
        least = json.loads(text)["memory_bytes"] / 2**20
        self.assertTrue(least < float(asked[1].rstrip("M")) < 2 * least + 150, (asked, least))
        self.assertRegex(asked[2], r"^\d:\d\d$")
        process.send_signal(signal.SIGINT)
        self.assertEqual(4, process.wait(120))

    def test_a_run_that_fails_is_one_row_and_what_slurm_refuses_is_said(self):
        file = self.sweep(2, "time_limit = 0.3", "retries = 1", end=1000)
        status, _, err = self.pliant(*self.command(file, "--quiet"), **self.how)
        self.assertEqual(3, status, err)
        self.assertEqual([(2, "failed")] * 2, [(row["attempts"], row["status"]) for row in self.rows()])
        self.assertIn("stopped by the time limit", self.rows()[0]["message"])
        self.out = self.folder / "refused"
        status, _, err = self.pliant(*self.command(self.sweep(2, "[slurm]", 'options = ["--partition=none"]')), **self.how)
        self.assertEqual(2, status)
        self.assertIn("invalid partition", err)


if __name__ == "__main__":
    if missing():
        print("skipped: Slurm is not installed (cmake/install-packages slurm); missing:", *missing())
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder, OneNode(Path(folder)) as NODE:
        main()
