import json
import math

from program import ProgramTest, main

# A block at rest under its own weight: the softer it is, the more it sags.
CASE = """dimension = 2
method = "total_lagrangian"
[discretisation]
spacing = 0.25
[total_lagrangian]
damping = 3
[time]
end = 2
step = 0.01
[output]
every = 0
measure_every = 0.1
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "linear", youngs_modulus = 120, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "load"
kind = "pressure"
geometry = { shape = "box", lower = [-1, 0.5], upper = [2, 2] }
pressure = "5*t"
[[measurement]]
name = "height"
kind = "extent"
axis = "y"
reference = 1
"""


class Calibrating(ProgramTest):
    def write_fit(self, **changes):
        fit = {"measurement": "height", "key": "body.block.material.youngs_modulus", "lower": 20, **changes}
        (self.folder / "fit.toml").write_text(f"""case = "case.toml"
[[curve]]
measurement = "{fit['measurement']}"
file = "curve.csv"
error = 1e-4
[[parameter]]
key = "{fit['key']}"
start = 60
lower = {fit['lower']}
upper = 500
scale = "log"
""")

    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE)
        status, _, err = self.pliant("run", "case.toml", "--out", "truth", "--threads", "1")
        self.assertEqual(0, status, err)
        value = json.loads((self.folder / "truth/summary.json").read_text())["measurements"]["height"]["value"]
        (self.folder / "curve.csv").write_text(f"time,height\n2,{value}\n")
        self.write_fit()

    def test_a_modulus_is_found_from_one_height_and_resuming_runs_nothing_again(self):
        status, out, err = self.pliant("calibrate", "fit.toml", "--out", "fit", "--json")
        self.assertEqual(0, status, err)
        found = json.loads(out)
        self.assertEqual(found, json.loads((self.folder / "fit/fit.json").read_text()))
        self.assertTrue(math.isclose(120, found["parameters"][0]["value"], rel_tol=0.01), found)
        self.assertLess(found["runs"], 20)
        curves = (self.folder / "fit/curves.csv").read_text().splitlines()
        self.assertEqual("measurement,time,data,deviation,fit", curves[0])
        self.assertEqual(2, len(curves))
        summaries = {path: path.stat().st_mtime_ns for path in self.folder.glob("fit/round-*/runs/*/summary.json")}
        self.assertEqual(found["runs"], len(summaries))
        self.assertEqual((0, out), self.pliant("calibrate", "fit.toml", "--out", "fit", "--json", "--resume")[:2])
        self.assertEqual(summaries, {path: path.stat().st_mtime_ns for path in summaries})
        status, _, err = self.pliant("calibrate", "fit.toml", "--out", "fit")
        self.assertEqual(2, status)
        self.assertIn("continue it with --resume", err)

    def test_wrong_fit_files_are_refused_before_anything_runs(self):
        for changes, text in (({"measurement": "width"}, "has no measurement `width`; name one"),
                              ({"key": "body.block.material.youngs"}, "youngs"),
                              ({"lower": 70}, "fit.toml:6: the bounds of `body.block.material.youngs_modulus` do not "
                                              "enclose its start; give lower < start < upper")):
            self.write_fit(**changes)
            status, out, err = self.pliant("calibrate", "fit.toml", "--out", "fit")
            self.assertEqual((2, ""), (status, out), err)
            self.assertIn(text, err)
            self.assertFalse((self.folder / "fit").exists())


if __name__ == "__main__":
    main()
