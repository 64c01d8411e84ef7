import json

from program import CASE, ProgramTest, main

LADDERS = f"""
[[problem]]
name = "cylinder"
case = "{CASE}"
set = ["time.end=0.02", "time.step=0.001", "output.every=0"]
rungs = ["discretisation.spacing=0.25", "discretisation.spacing=0.2", "discretisation.spacing=0.1"]
quick = 2
target = [{{ measurement = "angular_momentum_ratio", reference = 1 }}]
series = [{{ name = "compact" }}, {{ name = "single", set = ["precision=single"] }}]
"""


class Accuracy(ProgramTest):
    def setUp(self):
        super().setUp()
        self.ladders = self.folder / "ladders.toml"
        self.ladders.write_text(LADDERS)

    def bench(self, *arguments):
        return self.pliant("bench", "--accuracy", "--ladders", self.ladders, "--threads", "1", "--out", self.out,
                           *arguments)

    def test_each_run_gives_time_particles_and_error(self):
        table, saved = self.folder / "table.md", self.folder / "saved.json"
        status, out, err = self.bench("--quick", "--json", "--save", saved, "--markdown", table)
        self.assertEqual(0, status, err)
        record = json.loads(out)
        self.assertEqual(record, json.loads(saved.read_text()))
        self.assertEqual(["compact", "single"], [row["series"] for row in record["rows"]])
        for row in record["rows"]:
            coarse, fine = row["rungs"]
            self.assertLess(coarse["particles"], fine["particles"])
            self.assertEqual(20, fine["steps"])
            self.assertEqual(1, len(fine["seconds"]))
            self.assertGreater(fine["processor_seconds"][0], 0)
            self.assertAlmostEqual(abs(fine["values"]["angular_momentum_ratio"] - 1), fine["error"])
            self.assertEqual("at_most", row["costs"][0]["certainty"])
        self.assertIn("| cylinder | single | < ", table.read_text())

    def test_runs_are_kept_and_continued(self):
        self.assertEqual(0, self.bench("--rows", "cylinder/compact", "--quick")[0])
        kept = self.out / "1/cylinder/compact/0/summary.json"
        before = kept.stat().st_mtime_ns
        status, _, err = self.bench("--rows", "cylinder/compact")
        self.assertEqual(2, status)
        self.assertIn("holds runs of ladders; continue them with --resume", err)
        status, out, err = self.bench("--rows", "cylinder/compact", "--resume", "--json", "--repetitions", "2")
        self.assertEqual(0, status, err)
        self.assertEqual(before, kept.stat().st_mtime_ns)
        self.assertEqual([2, 2, 2], [len(rung["seconds"]) for rung in json.loads(out)["rows"][0]["rungs"]])
        self.ladders.write_text(LADDERS.replace("0.001", "0.002"))
        self.assertEqual(0, self.bench("--rows", "cylinder/compact", "--resume")[0])
        self.assertNotEqual(before, kept.stat().st_mtime_ns, "another run has the same place")

    def test_a_run_that_takes_too_long_ends_its_series(self):
        self.ladders.write_text(LADDERS.replace("time.end=0.02", "time.end=1000"))
        status, out, err = self.bench("--rows", "compact", "--json", "--time-limit", "0.2")
        self.assertEqual(0, status, err)
        row = json.loads(out)["rows"][0]
        self.assertIn("stopped by the time limit", row["rungs"][0]["message"])
        self.assertIn("not run", row["rungs"][1]["message"])
        self.assertEqual("not_reached", row["costs"][0]["certainty"])

    def test_wrong_ladders_are_refused_with_a_remedy(self):
        self.ladders.write_text(LADDERS.replace("time.step", "time.stop"))
        status, out, err = self.bench()
        self.assertEqual((2, ""), (status, out))
        self.assertIn("--set time.stop=0.001: ", err)
        self.ladders.write_text(LADDERS.replace('"angular_momentum_ratio"', '"momentum"'))
        status, _, err = self.bench("--resume", "--rows", "compact")
        self.assertEqual(2, status)
        self.assertIn("does not measure `momentum`", err)
        for arguments, text in ((["--compare", "x"], "--accuracy: not with"), (["--rows", "cube"], "--rows cube: ")):
            status, out, err = self.bench(*arguments)
            self.assertEqual((2, ""), (status, out), arguments)
            self.assertIn(text, err)
        status, _, err = self.pliant("bench", "--resume")
        self.assertEqual(2, status)
        self.assertIn("are for --accuracy", err)


if __name__ == "__main__":
    main()
