import shutil

from program import CASE, SMALL, SOURCE, ProgramTest, main


class CommandLine(ProgramTest):
    def refused(self, *arguments):
        status, out, err = self.pliant(*arguments)
        self.assertEqual((2, ""), (status, out), err)
        self.assertEqual(1, err.count("\n"), err)
        return err

    def test_the_resolved_case_of_a_wall_with_a_displacement_is_a_case(self):
        status, _, err = self.pliant("run", SOURCE / "cases/indentation", "--set", "discretisation.spacing=0.005",
                                     "--set", "time.end=0.001", "--quiet", "--threads", "1", "--out", self.out)
        self.assertEqual(0, status, err)
        self.assertEqual(0, self.pliant("check", self.out / "case.resolved.toml")[0])

    def test_a_misspelt_command_is_answered_with_the_nearest(self):
        self.assertIn("pliant rnu: no such command; did you mean `run`?", self.refused("rnu", CASE))
        self.assertIn("did you mean `bench`?", self.refused("help", "bnech"))

    def test_a_misspelt_option_is_answered_with_the_nearest(self):
        self.assertIn("pliant run: there is no option --thread; did you mean `--threads`?",
                      self.refused("run", CASE, "--thread", "2"))
        self.assertIn("did you mean `--out`?", self.refused("run", CASE, "--oud=x"))

    def test_no_command_and_no_case_are_refused_with_a_remedy(self):
        self.assertIn("`pliant help` lists them", self.refused())
        self.assertIn("CASE is required; `pliant help run`", self.refused("run"))
        self.assertIn("one argument too many, `b`", self.refused("check", CASE, "b"))

    def test_more_threads_than_any_machine_has_are_refused_with_the_limit(self):
        for threads in ("100000", "-1"):
            self.assertIn(f"--threads {threads}: give a number from 1 to 1024",
                          self.refused("run", CASE, "--threads", threads))
        for threads in ("99999999999999", "many"):
            self.assertIn(f"pliant run: --threads = {threads} is not a number",
                          self.refused("run", CASE, "--threads", threads))

    def test_an_option_given_twice_is_refused(self):
        self.assertIn("pliant run: --threads is given 2 times; give it once",
                      self.refused("run", CASE, "--threads", "1", "--threads", "2"))
        self.assertIn("pliant run: --quiet is given 3 times", self.refused("run", CASE, *["--quiet"] * 3))
        self.assertEqual(0, self.pliant("check", CASE, "--set", "time.end=0.1", "--set", "time.cfl=0.4")[0])

    def test_the_case_in_the_working_directory_has_the_name_of_its_folder(self):
        here = self.folder / "disc"
        here.mkdir()
        shutil.copy(CASE / "case.toml", here)
        status, _, err = self.pliant("run", ".", *SMALL, "--set", "time.end=0.005", cwd=here)
        self.assertEqual(0, status, err)
        self.assertTrue((here / "results/disc/result.h5").exists())
        self.assertIn("disc: ", self.pliant("check", "../disc/", cwd=here)[1])

    def test_a_run_ends_with_where_its_results_are_and_what_was_measured(self):
        status, out, err = self.run_case()
        self.assertEqual((0, ""), (status, out))
        self.assertIn(f"results in {self.out}; `pliant report {self.out}` shows them in a browser, result.xdmf in ParaView\n", err)
        self.assertRegex(err, r"\n  energy_ratio +(0\.99|1\.00)\d*\n")
        self.assertRegex(err, r"\n  boundary_radius +[0-9.]+ m\n")
        self.assertEqual((0, "", ""), self.run_case("--quiet"))

    def test_a_quiet_run_warns_of_what_is_doubtful_in_its_case(self):
        case = self.folder / "far.toml"
        case.write_text((SOURCE / "cases/rotating_cylinder/case.toml").read_text() + """
[[boundary]]
name = "far"
kind = "fixed"
geometry = { shape = "disc", centre = [50, 0], radius = 1 }
""")
        status, out, err = self.pliant("run", case, "--set", "time.end=0.005", "--quiet", "--out", self.out)
        self.assertEqual((0, ""), (status, out), err)
        self.assertRegex(err, "warning: .*far")

    def test_a_run_may_end_with_its_page(self):
        status, out, err = self.run_case("--report")
        self.assertEqual((0, f"wrote {self.out}/report.html; open it in a browser\n"), (status, out), err)
        self.assertIn("<html", (self.out / "report.html").read_text()[:1000])

    def test_help_speaks_of_commands_and_fits_a_terminal(self):
        texts = [self.pliant("--help")[1], self.pliant("help")[1]]
        texts += [self.pliant("help", command)[1] for command in ("run", "check", "bench", "profile", "batch", "graph", "help")]
        for text in texts:
            self.assertNotRegex(text.lower(), "verb|subcommand")
            self.assertLessEqual(max(map(len, text.splitlines())), 100, text)
        self.assertEqual(texts[0], texts[1])
        self.assertIn("Commands:", texts[0])


if __name__ == "__main__":
    main()
