"""Runs the built program on a small case, in a temporary folder."""

import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
CASE = SOURCE / "cases/rotating_cylinder"
SMALL = ["--set", "discretisation.spacing=0.1", "--set", "time.step=0.001", "--set", "remeshing.every=10", "--set", "output.every=0.005", "--threads", "2"]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.out = self.folder / "out"

    def pliant(self, *arguments, **how):
        """Status, stdout and stderr of the program with these arguments."""
        how = {"cwd": self.folder, "capture_output": True, "text": True, "errors": "replace", **how}
        done = subprocess.run([PROGRAM, *arguments], **how)
        return done.returncode, done.stdout, done.stderr

    def arguments_of_run(self, *more, end=0.02, out=None):
        return ["run", CASE, *SMALL, "--out", out or self.out, "--set", f"time.end={end}", *more]

    def run_case(self, *more, end=0.02, out=None, **how):
        return self.pliant(*self.arguments_of_run(*more, end=end, out=out), **how)

    def start(self, *more, end=1000, **how):
        """A run that continues until it is stopped."""
        how = {"stderr": subprocess.DEVNULL, **how}
        process = subprocess.Popen([PROGRAM, *self.arguments_of_run(*more, end=end)], cwd=self.folder, **how)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition, process):
        for _ in range(12000):
            if condition():
                return
            self.assertIsNone(process.poll(), "the run ended")
            time.sleep(0.005)
        self.fail("nothing came")

    def wait_for_checkpoint(self, process):
        self.wait_for((self.out / "checkpoint.previous.h5").exists, process)


def main():
    del sys.argv[1:3]
    unittest.main()
