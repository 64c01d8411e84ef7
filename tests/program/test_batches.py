"""Sweeps as people run them: kills at random moments, failures, interrupts."""

import contextlib
import csv
import io
import json
import os
import random
import signal
import sqlite3
import subprocess
import time
from pathlib import Path

from program import CASE, PROGRAM, ProgramTest, main

SETTINGS = ["discretisation.spacing=0.1", "output.every=0.005", "time.step=0.001"]
KEY = "body.cylinder.material.poissons_ratio"


class Batches(ProgramTest):
    def sweep(self, values, *more, end=0.02):
        file = self.folder / "sweep.toml"
        settings = json.dumps([*SETTINGS, f"time.end={end}"])
        file.write_text("\n".join([f'case = "{CASE}"', f"set = {settings}", *more,
                                   "[[design]]", f'parameters."{KEY}" = {values}', ""]))
        return file

    def batch(self, file, *more, **how):
        return self.pliant("batch", file, "--out", self.out, *more, **how)

    def rows(self):
        status, text, err = self.pliant("batch", "status", self.out, "--json")
        self.assertEqual(0, status, err)
        return json.loads(text)

    def results(self):
        return {row["name"]: row["measurements"] for row in self.rows()}

    def test_every_run_has_a_row_with_its_measurements(self):
        status, out, err = self.batch(self.sweep([0.2, 0.3, 0.4]))
        self.assertEqual((0, ""), (status, out), err)
        self.assertIn("3 runs: 3 done, 0 running, 0 pending, 0 failed", err)
        table = list(csv.DictReader(io.StringIO(self.pliant("batch", "export", self.out)[1])))
        self.assertEqual(["0.2", "0.3", "0.4"], [row[KEY] for row in table])
        for row in table:
            summary = json.loads((self.out / "runs" / row["name"] / "summary.json").read_text())
            for name, one in summary["measurements"].items():
                column = next(key for key in row if key.split(" [")[0] == name)
                self.assertEqual(one["value"], float(row[column]) if row[column] else None)
            self.assertGreater(int(row["peak_memory_bytes"]), 10**6)

    def test_more_values_run_only_what_is_new(self):
        self.batch(self.sweep([0.3]), "--quiet")
        before = self.rows()
        self.assertEqual(2, self.batch(self.sweep([0.2, 0.3]))[0])
        self.assertEqual(0, self.batch(self.sweep([0.2, 0.3]), "--resume", "--quiet")[0])
        after = {row["name"]: row for row in self.rows()}
        self.assertEqual(2, len(after))
        self.assertEqual(before[0], after[before[0]["name"]])

    def test_another_base_case_is_no_resume(self):
        self.batch(self.sweep([0.3]), "--quiet")
        status, _, err = self.batch(self.sweep([0.3], end=0.03), "--resume")
        self.assertEqual(2, status)
        self.assertIn("have changed since the batch began", err)

    def test_a_run_that_cannot_be_is_one_failed_row(self):
        status, _, err = self.batch(self.sweep([0.3, 0.7]), "--quiet")
        self.assertEqual(3, status, err)
        failed = [row for row in self.rows() if row["status"] == "failed"]
        self.assertEqual([2], [row["exit_status"] for row in failed])
        self.assertIn("poissons_ratio", failed[0]["message"])

    def test_the_time_limit_stops_an_attempt_and_retries_continue_it(self):
        status, _, err = self.batch(self.sweep([0.3], "time_limit = 0.5", "retries = 1", end=1000), "--quiet")
        self.assertEqual(3, status, err)
        row, = self.rows()
        self.assertEqual(2, row["attempts"])
        self.assertIn("stopped by the time limit", row["message"])
        self.assertTrue((self.out / "runs" / row["name"] / "checkpoint.h5").exists())

    def start_batch(self, file, *more):
        process = subprocess.Popen([PROGRAM, "batch", file, "--out", self.out, "--quiet", "--threads", "1", *more],
                                   cwd=self.folder, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        return process

    def test_an_interrupt_leaves_checkpoints_and_resume_finishes(self):
        file = self.sweep([0.2, 0.3, 0.4], end=0.4)
        process = self.start_batch(file)
        self.wait_for(lambda: any(self.out.glob("runs/*/checkpoint.h5")), process)
        process.send_signal(signal.SIGINT)
        self.assertEqual(4, process.wait(60))
        self.assertLessEqual({row["status"] for row in self.rows()}, {"pending", "done"})
        self.assertEqual(0, self.batch(file, "--resume", "--quiet")[0])
        self.assertEqual({"done"}, {row["status"] for row in self.rows()})

    def children(self, process):
        text = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        return [int(child) for child in text.read_text().split()] if text.exists() else []

    def test_kills_at_random_moments_change_nothing(self):
        kills = int(os.environ.get("PLIANT_KILLS", "8"))
        file = self.sweep([0.1, 0.2, 0.3, 0.4], "retries = 100", end=0.1)
        self.assertEqual(0, self.batch(file, "--quiet")[0])
        undisturbed = self.results()
        chance = random.Random(1)
        self.out = self.folder / "disturbed"
        done = 0
        while done < kills:
            process = self.start_batch(file, "--resume")
            time.sleep(chance.uniform(0, 0.4))
            children = self.children(process)
            victim = chance.choice([process.pid, *children])
            try:
                os.kill(victim, signal.SIGKILL)
                done += 1
            except ProcessLookupError:
                pass
            if victim != process.pid:
                time.sleep(chance.uniform(0, 0.2))
                process.kill()
            process.wait()
            if (self.out / "batch.sqlite").exists():
                with contextlib.closing(sqlite3.connect(self.out / "batch.sqlite")) as ledger:
                    self.assertEqual([("ok",)], ledger.execute("PRAGMA integrity_check").fetchall())
                if {row["status"] for row in self.rows()} == {"done"}:
                    self.assertEqual(undisturbed, self.results())
                    self.out = self.folder / f"disturbed{done}"
        self.assertEqual(0, self.batch(file, "--resume", "--quiet")[0])
        self.assertEqual(undisturbed, self.results())


if __name__ == "__main__":
    main()
