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
mkdir -p build/release && : > build/release/build.ninja
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > build/release/CMakeCache.txt
"""
NINJA = """#!/bin/bash
cd "$2"
grep -q damaged build.ninja && { echo "ninja: error: build.ninja:1: expected '='"; exit 1; }
[[ -e engine/cli/pliant ]] && { echo "ninja: no work to do."; exit; }
[[ $3 == -n ]] && exit
echo "[1/3] Building a"; echo "[2/3] Building b"; echo "[3/3] Linking c"
[[ -e ../../broken ]] && { echo "FAILED: a"; echo "a.cpp:1: error"; }
[[ -e ../../broken ]] && exit 1
echo "$*" >> ../builds
sleep 0.2
mkdir -p engine/cli && cp ../../program engine/cli/pliant
"""
LONG = "runs/Precisions.a_restored_solver_of_single_precision_continues_to_the_same_bits/compression_hyperelastic"
CTEST = f"""#!/bin/bash
echo "ctest $*"
echo "        Start  999: {LONG}_twice"
echo " 999/1200 Test  #999: {LONG} {'.' * 30}   Passed    0.14 sec"
echo "1000/1200 Test #1000: hdf5.is_short {'.' * 110}***Failed    0.01 sec"
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
        self.assertIn("a.cpp:1: error", err)
        self.assertIn("remove", err)

    def test_without_a_terminal_a_build_shows_how_far_it_is_in_few_lines(self):
        lines = [line for line in self.launch("0")[2].splitlines() if "/3]" in line]
        self.assertEqual(["pliant: building [1/3]"], lines)

    def test_a_damaged_build_folder_is_configured_again(self):
        self.launch("0")
        (self.root / "build/release/build.ninja").write_text("damaged")
        status, out, err = self.launch("0")
        self.assertEqual((0, "[0]"), (status, out))
        self.assertIn("damaged", err)
        self.assertEqual((0, "[0]", ""), self.launch("0"))

    # A folder in place of the lock stops root too, as a read-only tree stops everybody.
    def lock_out(self):
        (self.root / "build/.lock").unlink(missing_ok=True)
        (self.root / "build/.lock").mkdir(parents=True)

    def test_a_tree_that_cannot_be_written_runs_what_is_built(self):
        self.launch("0")
        self.lock_out()
        self.assertEqual((3, "[3]", ""), self.launch("3"))

    def test_a_tree_that_cannot_be_written_and_is_not_built_says_what_to_do(self):
        self.lock_out()
        status, out, err = self.launch("0")
        self.assertEqual((1, ""), (status, out))
        self.assertIn("let its owner run ./pliant once", err)

    def test_missing_packages_end_with_2(self):
        write(self.root / "cmake/install-packages", "#!/bin/bash\nexit 2\n")
        self.assertEqual((2, ""), self.launch("0")[:2])

    def test_the_verb_test_is_ctest_with_its_arguments_and_status(self):
        status, out, _ = self.launch("test", "-R", "a b")
        self.assertEqual(8, status)
        self.assertRegex(out.splitlines()[0], r"^ctest --preset release --parallel \d+ -R a b$")

    def test_without_a_terminal_lines_about_tests_have_at_most_120_columns(self):
        lines = self.launch("test")[1].splitlines()[1:]
        self.assertEqual(3, len(lines))
        for line in lines:
            self.assertLessEqual(len(line), 120)
        self.assertRegex(lines[1], r"a_restored_solver_of_single_precision.*~ \.\.   Passed    0\.14 sec$")
        self.assertTrue(lines[2].endswith("Test #1000: hdf5.is_short ..***Failed    0.01 sec"))

    def test_nightly_tests_have_a_preset_of_their_own(self):
        status, out, _ = self.launch("test", "--nightly", "-R", "ball")
        self.assertEqual((8, "ctest --preset nightly -R ball"), (status, out.splitlines()[0]))


APT = """#!/bin/bash
echo "$*" >> "$APT_LOG"
[[ $* == *install* ]] || exit 0
echo "Reading package lists..."
echo "pmstatus:libx:37.5000:Unpacking libx (amd64)"
echo "pmstatus:libx:62.5000:Configuring libx (amd64)"
[[ -n ${APT_FAILS-} ]] && { echo "E: no such package"; exit 100; }
exit 0
"""


class Packages(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.root = Path(self.scratch.name)
        (self.root / "cmake").mkdir()
        shutil.copy(SOURCE / "cmake/install-packages", self.root / "cmake")
        (self.root / "cmake/debian-packages.txt").write_text("build libx\nbuild liby\n")
        write(self.root / "tools/dpkg-query", "#!/bin/bash\necho liby installed\n")
        write(self.root / "tools/apt-get", APT)
        write(self.root / "tools/sudo", '#!/bin/bash\n[[ $1 == -n ]] && shift\nexec "$@"\n')

    def install(self, *sections, **variables):
        tools = f"{self.root}/tools:{os.environ['PATH']}"
        environment = dict(os.environ, PATH=tools, APT_LOG=str(self.root / "log"), **variables)
        done = subprocess.run([self.root / "cmake/install-packages", *sections], env=environment,
                              capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def test_installing_says_what_and_how_far_it_is(self):
        status, out, err = self.install("build")
        self.assertEqual((0, ""), (status, out))
        self.assertEqual(["pliant: installing libx",
                          "pliant: [37 %] Unpacking libx (amd64)"], err.splitlines())

    def test_a_failed_installation_shows_the_messages_and_ends_with_2(self):
        status, _, err = self.install("build", APT_FAILS="yes")
        self.assertEqual(2, status)
        self.assertIn("E: no such package", err)

    def test_sections_that_do_not_exist_are_answered_with_those_that_do(self):
        usage = "usage: cmake/install-packages SECTION..., with sections of build"
        self.assertEqual((2, "", usage + "\n"), self.install())
        status, _, err = self.install("build", "bild")
        self.assertEqual(2, status)
        self.assertIn("has no section `bild`\n" + usage, err)
        self.assertFalse((self.root / "log").exists())


if __name__ == "__main__":
    unittest.main()
