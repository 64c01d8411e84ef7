import json

from program import ProgramTest, main

ROW = "rotating_cylinder/compact/0.03963/1"


class Comparing(ProgramTest):
    """No speed decides these tests: records are changed by factors that no machine has."""

    def setUp(self):
        super().setUp()
        self.record = self.folder / "record.json"

    def bench(self, *arguments):
        return self.pliant("bench", "--quick", "--rows", ROW, "--repetitions", "1", "--threads", "1", *arguments)

    def change_record(self, factor):
        record = json.loads(self.record.read_text())
        for sample in record["rows"][0]["samples"]:
            sample["particle_stages_per_second"] *= factor
        self.record.write_text(json.dumps(record))

    def test_a_record_is_saved_and_compared_with(self):
        status, out, _ = self.bench("--save", self.record, "--json")
        self.assertEqual(0, status)
        self.assertEqual([ROW], [row["name"] for row in json.loads(out)["rows"]])
        self.assertEqual(json.loads(out), json.loads(self.record.read_text()))
        self.change_record(1e3)
        table = self.folder / "table.md"
        status, out, err = self.bench("--compare", self.record, "--markdown", table)
        self.assertEqual(1, status, err)
        self.assertRegex(out, f"\n{ROW} .* slower\n")
        self.assertRegex(table.read_text(), rf"\| {ROW} \| 2104 \| 1 \|.*\| slower \|\n")
        self.change_record(1e-6)
        self.assertEqual(0, self.bench("--compare", self.record)[0])

    def test_another_program_is_measured_in_turns(self):
        # Does not measure, but reports as a program 1000 times as fast would.
        other = self.folder / "other"
        other.write_text(f"#!/bin/sh\necho other >> {self.folder}/order\nwhile read line; do echo 2e10; done\n")
        other.chmod(0o755)
        status, out, err = self.pliant("bench", "--rows", ROW, "--threads", "1", "--repetitions", "2",
                                       "--against", other)
        self.assertEqual(0, status, err)  # two pairs are too few for a conclusion
        self.assertEqual(2, (self.folder / "order").read_text().count("other"))
        self.assertRegex(out, f"{ROW} +2 +0\\.0")

    def test_growth_is_a_line_for_each_method_and_size(self):
        table = self.folder / "table.md"
        status, out, err = self.pliant("bench", "--growth", "10000", "--rows", "block_2d/double", "--threads", "1",
                                       "--repetitions", "1", "--markdown", table)
        self.assertEqual(0, status, err)
        for method in ("total_lagrangian", "point_based"):
            self.assertRegex(out, rf"{method} +2 +double +1 +10000 +")
            line = next(line for line in table.read_text().splitlines() if method in line).split(" | ")
            self.assertGreater(float(line[5]), 0)  # set-up
            self.assertGreater(float(line[7]), 40)  # at least displacement, velocity and mass

    def test_wrong_arguments_are_refused_with_a_remedy(self):
        (self.folder / "text").write_text("no record")
        silent = self.folder / "silent"
        silent.write_text("#!/bin/sh\nexit 2\n")
        silent.chmod(0o755)
        for arguments, text in ((["--compare", "text"], "text: is no record of a benchmark; give a file"),
                                (["--compare", "missing"], "missing: cannot be read; give a file"),
                                (["--rows", "cube"], "--rows cube: no row of the set has this in its name"),
                                (["--markdown", "x"], "--markdown: is for tables of"),
                                (["--against", "/bin/true", "--save", "x"], "--against: not with"),
                                (["--compare", "text", "--tolerance", "ten"], "--tolerance ten: give a share"),
                                (["--against", silent, "--rows", ROW], "silent: cannot measure the row rotating_cylinder")):
            status, out, err = self.pliant("bench", "--threads", "1", *arguments)
            self.assertEqual((2, ""), (status, out), arguments)
            self.assertIn(text, err)


if __name__ == "__main__":
    main()
