import json
import shutil
import subprocess

from program import ProgramTest, main

OTHER = ["--set", "body.cylinder.material.youngs_modulus=50"]


class Resuming(ProgramTest):
    def stop(self, process):
        process.kill()
        process.wait()

    def assert_equal_results(self, first, second):
        done = subprocess.run(["h5diff", first / "result.h5", second / "result.h5"], capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stdout))
        for name in ("result.xdmf", "case.resolved.toml"):
            self.assertEqual((first / name).read_text(), (second / name).read_text())

    def test_two_runs_in_one_folder_are_never_mixed(self):
        first = self.start()
        self.wait_for_checkpoint(first)
        self.stop(first)
        second = self.start("--set", "output.checkpoint_every=500", *OTHER)
        self.wait_for(lambda: not (self.out / "checkpoint.h5").exists(), second)
        self.stop(second)
        status, _, err = self.run_case("--resume", end=1000)
        self.assertEqual(2, status, err)
        self.assertIn("there is no checkpoint to continue from", err)

    def test_a_result_of_another_run_beside_the_checkpoint_is_refused(self):
        self.assertEqual(0, self.run_case("--quiet", *OTHER)[0])
        foreign = self.folder / "foreign.h5"
        shutil.copy(self.out / "result.h5", foreign)
        self.assertEqual(0, self.run_case("--quiet")[0])
        shutil.copy(foreign, self.out / "result.h5")
        status, _, err = self.run_case("--resume")
        self.assertEqual(2, status, err)
        self.assertIn("result.h5: belongs to another run than the checkpoint", err)
        self.assertTrue(foreign.read_bytes() == (self.out / "result.h5").read_bytes())

    def test_other_settings_are_refused_by_name(self):
        self.assertEqual(0, self.run_case("--quiet")[0])
        status, _, err = self.run_case("--resume", *OTHER)
        self.assertEqual(2, status)
        self.assertRegex(err, "had `material = .* youngs_modulus = 100,.*, and has .* youngs_modulus = 50,.* now")

    def test_a_changed_mesh_file_is_refused(self):
        case, mesh = self.folder / "case.toml", self.folder / "cube.obj"
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]

        def write_mesh(height):
            mesh.write_text("".join(f"v {x} {y} {z * height}\n" for x, y, z in corners)
                            + "".join(f"f {face}\n" for face in faces))

        case.write_text("""dimension = 3
[discretisation]
spacing = 0.1
[time]
end = 0.02
step = 0.001
[output]
every = 0.005
[[body]]
name = "cube"
geometry = { shape = "mesh", file = "cube.obj" }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
""")
        write_mesh(1)
        arguments = ["run", case, "--out", self.out, "--quiet"]
        self.assertEqual((0, "", ""), self.pliant(*arguments))
        self.assertEqual((0, "", ""), self.pliant(*arguments, "--resume"))
        write_mesh(1.001)
        status, _, err = self.pliant(*arguments, "--resume")
        self.assertEqual(2, status)
        self.assertIn("cube.obj: this file has changed since the checkpoint", err)

    def test_a_finished_run_continues_to_a_later_end_with_the_values_of_one_long_run(self):
        long = self.folder / "long"
        self.assertEqual(0, self.run_case("--quiet", out=long, end=0.03)[0])
        # Not a multiple of the step or of the frame interval: the last step is cut short.
        self.assertEqual(0, self.run_case("--quiet", end=0.0137)[0])
        self.assertEqual((0, "", ""), self.run_case("--quiet", "--resume", end=0.03))
        self.assert_equal_results(long, self.out)
        self.assertEqual(json.loads((long / "summary.json").read_text())["measurements"],
                         json.loads((self.out / "summary.json").read_text())["measurements"])

    def test_an_earlier_end_is_refused(self):
        self.assertEqual(0, self.run_case("--quiet")[0])
        status, _, err = self.run_case("--resume", end=0.012)
        self.assertEqual(2, status)
        self.assertIn("time.end = 0.012 is earlier than 0.02", err)

    def test_a_run_that_is_under_way_has_no_summary(self):
        self.assertEqual(0, self.run_case("--quiet")[0])
        self.assertTrue((self.out / "summary.json").exists())
        for more in (["--resume"], OTHER):
            process = self.start(*more)
            self.wait_for(lambda: not (self.out / "summary.json").exists(), process)
            self.stop(process)


if __name__ == "__main__":
    main()
