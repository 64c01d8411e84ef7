"""The launcher, with a compiler's part played by small scripts: what it builds is a program that
prints its arguments and ends with the status that the first one asks for."""

import os
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = """#!/bin/bash
printf '[%s]' "$@"
[[ $1 == wait ]] && { echo; exec sleep 60; }
exit "$1"
"""
CMAKE = """#!/bin/bash
echo configured
mkdir -p build/release && touch build/release/build.ninja
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > build/release/CMakeCache.txt
"""
NINJA = """#!/bin/bash
cd "$2"
[[ -e engine/cli/pliant ]] && { echo "ninja: no work to do."; exit; }
[[ $3 == -n ]] && exit
echo built
[[ -e ../../broken ]] && exit 1
echo "$*" >> ../builds
sleep 0.2
mkdir -p engine/cli && cp ../../program engine/cli/pliant
"""
CTEST = """#!/bin/bash
echo "ctest $*"
exit 8
"""


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


class Launcher(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.root = Path(self.scratch.name).resolve() / "a folder"
        self.root.mkdir()
        shutil.copy(SOURCE / "pliant", self.root / "pliant")
        write(self.root / "cmake/install-packages", "#!/bin/bash\n")
        write(self.root / "program", PROGRAM)
        for name, text in {"cmake": CMAKE, "ninja": NINJA, "ctest": CTEST}.items():
            write(self.root / "tools" / name, text)
        self.environment = dict(os.environ, PATH=f"{self.root}/tools:{os.environ['PATH']}")

    def start(self, *arguments, launcher=None):
        return subprocess.Popen([launcher or self.root / "pliant", *arguments], cwd="/", text=True,
                                env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def launch(self, *arguments, **how):
        process = self.start(*arguments, **how)
        out, err = process.communicate()
        return process.returncode, out, err

    def test_arguments_and_status_pass_through_and_stdout_is_the_programs_alone(self):
        status, out, _ = self.launch("3", "two words", "*")
        self.assertEqual((3, "[3][two words][*]"), (status, out))

    def test_a_second_launch_builds_nothing_and_says_nothing(self):
        self.launch("0")
        self.assertEqual((0, "[0]", ""), self.launch("0"))

    def test_it_runs_through_a_symbolic_link(self):
        link = self.root / "link"
        link.symlink_to("pliant")
        self.assertEqual(4, self.launch("4", launcher=link)[0])

    def test_a_tree_that_was_moved_is_configured_again(self):
        self.launch("0")
        self.root = self.root.rename(self.root.parent / "moved")
        self.environment["PATH"] = f"{self.root}/tools:{os.environ['PATH']}"
        self.assertIn("configuring", self.launch("0")[2])

    def test_launches_at_the_same_time_build_once(self):
        launches = [self.start("0") for _ in range(4)]
        for launch in launches:
            launch.communicate()
        self.assertEqual([0] * 4, [launch.returncode for launch in launches])
        self.assertEqual(1, len((self.root / "build/builds").read_text().splitlines()))

    def test_a_signal_reaches_the_program(self):
        process = self.start("wait")
        process.stdout.readline()
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(-signal.SIGTERM, process.returncode)

    def test_a_failed_build_runs_nothing_and_ends_with_1(self):
        (self.root / "broken").touch()
        status, out, err = self.launch("0")
        self.assertEqual((1, ""), (status, out))
        self.assertIn("built", err)

    def test_missing_packages_end_with_2(self):
        write(self.root / "cmake/install-packages", "#!/bin/bash\nexit 2\n")
        self.assertEqual((2, ""), self.launch("0")[:2])

    def test_the_verb_test_is_ctest_with_its_arguments_and_status(self):
        status, out, _ = self.launch("test", "-R", "a b")
        self.assertEqual(8, status)
        self.assertRegex(out, r"^ctest --preset release --parallel \d+ -R a b$")


if __name__ == "__main__":
    unittest.main()
