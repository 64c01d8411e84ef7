import os
import resource
import signal
import subprocess

from program import CASE, PROGRAM, ProgramTest, main


class Failures(ProgramTest):
    """What may go wrong around a run: streams, signals, disks, and input that libraries refuse."""

    def test_a_run_outlives_its_stderr(self):
        with open("/dev/full", "w") as full:
            self.assertEqual(0, self.run_case(stderr=full, capture_output=False)[0])
        reader, writer = os.pipe()
        os.close(reader)
        self.assertEqual(0, self.run_case(stderr=writer, capture_output=False)[0])
        os.close(writer)

    def test_a_closed_stderr_is_not_taken_for_a_file(self):
        self.assertEqual(0, self.run_case("--quiet")[0])
        expected = (self.out / "result.h5").read_bytes()
        closed = subprocess.run(["bash", "-c", '"$@" 0<&- 1>&- 2>&-', "_", PROGRAM, *self.arguments_of_run()])
        self.assertEqual(0, closed.returncode)
        self.assertTrue(expected == (self.out / "result.h5").read_bytes())

    def test_a_hangup_leaves_a_checkpoint_and_may_come_twice(self):
        process = self.start()
        self.wait_for_checkpoint(process)
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(4, process.wait())
        self.assertFalse((self.out / "summary.json").exists())

    def test_a_hangup_that_is_ignored_stays_ignored(self):
        process = self.start(preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.wait_for_checkpoint(process)
        process.send_signal(signal.SIGHUP)
        with self.assertRaises(subprocess.TimeoutExpired):
            process.wait(0.3)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(4, process.wait())

    def test_a_signal_before_the_first_step_ends_with_4_and_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start("--set", "discretisation.spacing=0.004", "--force", stderr=subprocess.PIPE, text=True)
            self.wait_for(lambda: self.catches(process, number), process)
            process.send_signal(number)
            _, err = process.communicate()
            self.assertEqual(4, process.returncode, err)
            self.assertIn("interrupted before the first step", err)
            self.assertFalse(self.out.exists())

    def catches(self, process, number):
        """Whether the process has a handler for the signal."""
        with open(f"/proc/{process.pid}/status") as status:
            caught = next(line for line in status if line.startswith("SigCgt"))
        return int(caught.split()[1], 16) >> number - 1 & 1 == 1

    def test_a_limit_on_the_size_of_files_is_a_full_disk(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
        status, _, err = self.run_case(preexec_fn=limit)
        self.assertEqual(3, status, err)
        self.assertIn("File too large; raise the limit on file sizes", err.splitlines()[-1])

    def test_a_stdout_that_cannot_be_written_is_a_failure(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "reference"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(3, done.returncode)
        self.assertRegex(done.stderr, "standard output cannot be written; .+\n$")

    def refused(self, *arguments):
        status, _, err = self.pliant("check", *arguments)
        self.assertEqual(2, status, err)
        return err

    def test_formulas_beyond_the_limits_of_the_parser_are_answered_as_formulas(self):
        many = "+".join(["1"] * 20000)
        self.assertIn("it is longer than 20000 characters", self.refused(CASE, "--set", "time.end=" + many))
        name = "x" * 200
        self.assertIn("time.end", self.refused(CASE, "--set", f"time.end={name}+1"))

    def test_paths_that_the_system_refuses_are_answered_as_paths(self):
        self.assertIn("cannot be read; give the path of a case file", self.refused("x" * 5000))
        status, _, err = self.pliant("list", "x" * 5000)
        self.assertEqual(2, status)
        self.assertIn("cannot be listed: File name too long; give a folder that holds cases", err)

    def test_bytes_that_are_no_text_are_answered_with_their_place(self):
        self.assertIn("not UTF-8", self.refused(CASE, "--set", b"title=\xff\xfe"))
        broken = self.folder / "broken.toml"
        broken.write_bytes((CASE / "case.toml").read_bytes() + b'\n# \xff\xfe\n')
        lines = broken.read_bytes().count(b"\n")
        self.assertIn(f"broken.toml:{lines}: not UTF-8 text; save the file as UTF-8", self.refused(broken))

    def test_a_folder_whose_name_is_no_text_can_be_run(self):
        here = os.fsencode(self.folder) + b"/\xff"
        os.mkdir(here)
        with open(here + b"/case.toml", "wb") as file:
            file.write((CASE / "case.toml").read_bytes())
        status, _, err = self.pliant("run", here, *self.arguments_of_run("--quiet")[2:])
        self.assertEqual((0, ""), (status, err))
        self.assertTrue((self.out / "summary.json").exists())


if __name__ == "__main__":
    main()
