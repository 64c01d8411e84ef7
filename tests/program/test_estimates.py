"""What `check` says that a run costs, and runs that do not fit."""

import os
import re
import resource

from program import PROGRAM, SOURCE, ProgramTest, main


def peak_of(arguments):
    """Largest resident memory of the program with these arguments [bytes]."""
    child = os.spawnv(os.P_NOWAIT, PROGRAM, [str(argument) for argument in (PROGRAM, *arguments)])
    _, status, usage = os.wait4(child, 0)
    assert status == 0
    return 1024 * usage.ru_maxrss


class Estimates(ProgramTest):
    def test_of_memory_are_within_a_fifth_of_the_measured_peak(self):
        for case, *settings in (
                ("rotating_cylinder", "discretisation.spacing=0.02", "time.end=0.025"),
                ("compression_hyperelastic", "discretisation.spacing=1/96", "time.end=0.001"),
                ("bouncing_ball", "discretisation.spacing=0.03", "time.end=0.0025"),
                ("liver_aspiration", "time.end=0.02"),
                ("block_cut", "discretisation.spacing=0.002", "time.end=0.002"),
                ("edge_cut", "discretisation.spacing=1/200", "time.end=0.01"),
                ("two_spheres", "method=point_based", "discretisation.spacing=1/40", "time.end=0.003")):
            arguments = [SOURCE / "cases" / case]
            for setting in settings:
                arguments += ["--set", setting]
            estimate = re.search(r", (\d+) MB of memory", self.pliant("check", *arguments)[1])
            with self.subTest(case):
                peak = peak_of(["run", *arguments, "--out", self.out, "--quiet"])
                self.assertLess(abs(1e6 * float(estimate[1]) / peak - 1), 0.2)

    def test_a_run_that_does_not_fit_is_refused_before_it_allocates(self):
        limit = 4 * 10**8
        how = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))}
        fine = ["--set", "discretisation.spacing=0.001"]
        status, _, text = self.run_case(*fine, **how)
        self.assertEqual(status, 2)
        self.assertRegex(text, "the run needs about 1.* GB of memory for 314.* particles, and .* MB are available; "
                               "use a coarser discretisation.spacing, or --force to try")
        self.assertFalse(self.out.exists())
        self.assertEqual(self.run_case(*fine, "--force", **how)[0], 3)


if __name__ == "__main__":
    main()
