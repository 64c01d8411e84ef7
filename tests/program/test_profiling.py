import json

from program import CASE, ProgramTest, main

SMALL = ["--set", "discretisation.spacing=0.1", "--set", "time.step=0.001", "--threads", "2", "--frame-time", "5ms"]


class Profiling(ProgramTest):
    def profile(self, *arguments):
        return self.pliant("profile", CASE, *SMALL, *arguments)

    def test_the_exit_status_says_whether_the_budget_is_held(self):
        status, out, err = self.profile("--frames", "20", "--budget", "1h")
        self.assertEqual((0, ""), (status, err))
        self.assertIn("budget 3.6e+03 s at p99: HELD", out)
        self.assertIn("20 frames of 5 ms simulated time in 100 steps, after a warm-up of 10 frames", out)
        status, out, err = self.profile("--frames", "20", "--budget", "0.001us")
        self.assertEqual((1, ""), (status, err))
        self.assertIn("missed deadlines: 20 of 20 frames (100.0 %), at most 20 in a row", out)

    def test_every_method_is_profiled(self):
        for method in ("sph", "total_lagrangian"):
            case = {"sph": [CASE.parent / "tensile_instability"],
                    "total_lagrangian": [CASE.parent / "liver_aspiration", "--frame-time", "2ms"]}[method]
            status, out, err = self.pliant("profile", *case, "--frames", "2", "--warm-up", "1", "--json",
                                           "--budget", "1h")
            self.assertEqual((0, ""), (status, err))
            report = json.loads(out)
            self.assertEqual(method, report["method"])
            shares = sum(part["share"] for part in report["parts"].values())
            self.assertAlmostEqual(1, shares, places=6)

    def test_the_report_and_the_trace_are_json(self):
        trace, report = self.folder / "trace.json", self.folder / "report.json"
        self.profile("--frames", "3", "--trace", trace, "--report", report)
        names = {event["name"] for event in json.loads(trace.read_text())}
        self.assertLessEqual({"frame", "step", "advance[0]", "advance[3]"}, names)
        self.assertEqual(3, len(json.loads(report.read_text())["frames"]["seconds"]))

    def test_the_finest_spacing_that_holds_a_budget_is_found(self):
        status, out, _ = self.pliant("profile", CASE, "--set", "discretisation.spacing=0.2", "--threads", "1",
                                     "--frame-time", "1ms", "--frames", "4", "--warm-up", "1", "--fit", "--json",
                                     "--budget", "20ms", "--at", "50")
        self.assertEqual(0, status)
        fit = json.loads(out)
        self.assertEqual(max(row["particles"] for row in fit["tries"] if row["held"]), fit["best"]["particles"])

    def test_wrong_arguments_are_refused_with_a_remedy(self):
        for arguments, text in ((["--budget", "16"], "--budget 16: not a duration; give a positive number with its "
                                                      "unit"),
                                (["--frame-time", "2h"], "give a shorter --frame-time, or --frames"),
                                (["--fit", "--trace", "x"], "--trace: not with --fit")):
            status, out, err = self.pliant("profile", CASE, *arguments)
            self.assertEqual((2, ""), (status, out))
            self.assertIn(text, err)


if __name__ == "__main__":
    main()
