"""An installed program runs, reads the installed cases, and knows nothing of the source tree; programs
over the installed library build and run."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, SOURCE = (os.path.realpath(argument) for argument in sys.argv[1:3])


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.prefix = Path(cls.scratch.name)
        cls.program = cls.prefix / "bin/pliant"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.prefix], check=True,
                       stdout=subprocess.DEVNULL)

    def test_it_says_its_version(self):
        out = subprocess.run([self.program, "--version"], cwd="/", capture_output=True, text=True)
        self.assertEqual(0, out.returncode)
        self.assertRegex(out.stdout, r"\d+\.\d+\.\d+")

    def test_it_accepts_every_installed_case(self):
        cases = sorted(self.prefix.glob("share/pliant/cases/*/case.toml"))
        self.assertTrue(cases)
        for case in cases:
            with self.subTest(case=case.parent.name):
                out = subprocess.run([self.program, "check", case], cwd="/", capture_output=True,
                                     text=True)
                self.assertEqual((0, ""), (out.returncode, out.stderr))

    def test_programs_over_the_installed_library_build_and_run(self):
        build = self.prefix / "examples"
        subprocess.run(["cmake", "-S", Path(SOURCE) / "examples", "-B", build, "-G", "Ninja",
                        f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Werror",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"],
                       check=True, capture_output=True)
        built = subprocess.run(["cmake", "--build", build], capture_output=True, text=True)
        self.assertEqual(0, built.returncode, built.stdout)
        self.assertNotIn("-ffp-contract", (build / "compile_commands.json").read_text())
        hello = subprocess.run([build / "hello"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(hello, r"angular momentum: (1\.00|0\.99)\d+ of its start")
        loads = subprocess.run([build / "moving_load"], capture_output=True, text=True, check=True)
        moved = [float(line.split()[-2]) for line in loads.stdout.splitlines()]
        self.assertEqual(30, len(moved))
        self.assertLess(min(moved), -1e-3)
        session = Path(SOURCE) / "examples/scalpel/session.csv"
        scalpel = subprocess.run([build / "scalpel", session, "0.009"], capture_output=True, text=True, check=True)
        self.assertRegex(scalpel.stdout, r"missed deadlines: \d+ of \d+; simulated time was late by")
        self.assertIn("played again: the same bits", scalpel.stdout)

    def test_what_shells_and_editors_read_is_what_it_prints(self):
        for file, command in (("bash-completion/completions/pliant", ["completion", "bash"]),
                              ("zsh/vendor-completions/_pliant", ["completion", "zsh"]),
                              ("fish/vendor_completions.d/pliant.fish", ["completion", "fish"]),
                              ("man/man1/pliant.1", ["manual"]), ("pliant/case.schema.json", ["schema"])):
            out = subprocess.run([self.program, *command], capture_output=True, text=True, check=True).stdout
            self.assertEqual(out, (self.prefix / "share" / file).read_text(), file)

    @unittest.skipUnless(shutil.which("dpkg-shlibdeps"), "dpkg-dev is not installed")
    def test_the_debian_package_holds_the_program_and_depends_on_its_libraries(self):
        folder = self.prefix / "packages"
        subprocess.run(["cpack", "-G", "DEB", "--config", Path(BUILD) / "CPackConfig.cmake", "-B", folder],
                       check=True, stdout=subprocess.DEVNULL)
        package, = folder.glob("pliant_*.deb")
        depends = subprocess.run(["dpkg-deb", "--field", package, "Depends"], capture_output=True, text=True,
                                 check=True).stdout
        listed = (Path(SOURCE) / "cmake/debian-packages.txt").read_text().splitlines()
        for library in (line.split()[1] for line in listed if line.startswith("run ")):
            self.assertIn(library, depends)
        subprocess.run(["dpkg-deb", "--extract", package, folder / "root"], check=True)
        out = subprocess.run([folder / "root/usr/bin/pliant", "check",
                              folder / "root/usr/share/pliant/cases/rotating_cylinder"], capture_output=True, text=True)
        self.assertEqual((0, ""), (out.returncode, out.stderr))

    @unittest.skipUnless(list(Path(BUILD).glob("python/pliant/_pliant*")), "the Python package is not built")
    def test_the_python_package_is_installed_and_has_a_debian_package(self):
        found, = self.prefix.glob("lib/python3.*/site-packages/pliant")
        self.assertTrue(list(found.glob("_pliant*.so")))
        folder = self.prefix / "python_package"
        subprocess.run(["cpack", "-G", "DEB", "--config", Path(BUILD) / "CPackConfig.cmake", "-B", folder,
                        "-D", "CPACK_COMPONENTS_ALL=python_of_debian", "-D", "CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF",
                        "-D", "CPACK_DEBIAN_PYTHON_OF_DEBIAN_PACKAGE_SHLIBDEPS=OFF"], check=True, stdout=subprocess.DEVNULL)
        package, = folder.glob("python3-pliant_*.deb")
        listed = subprocess.run(["dpkg-deb", "--contents", package], capture_output=True, text=True, check=True).stdout
        self.assertIn("./usr/lib/python3/dist-packages/pliant/__init__.py", listed)
        self.assertRegex(listed, r"dist-packages/pliant/_pliant\S*\.so\n")

    def test_it_holds_no_path_of_the_source_tree(self):
        self.assertFalse(SOURCE.encode() in self.program.read_bytes(), f"{self.program} names {SOURCE}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
