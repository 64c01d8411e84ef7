"""The Python package: what it computes is what the program computes."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PACKAGES, PROGRAM, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(PACKAGES))

try:
    import h5py  # noqa: F401
    import numpy
except ImportError as error:
    print("skipped: cmake/install-packages python installs what is missing:", error)
    sys.exit(77)

import pliant  # noqa: E402

BLOCK = {
    "method": "total_lagrangian",
    "dimension": 2,
    "discretisation": {"spacing": 0.02},
    "time": {"end": 0.05},
    "body": [{"name": "block", "geometry": {"shape": "box", "lower": [0, 0], "upper": [0.2, 0.1]},
              "material": {"model": "reduced_polynomial", "coefficients": [5000], "compressibility": 2e-5, "density": 1000}}],
    "boundary": [
        {"name": "ground", "kind": "fixed", "geometry": {"shape": "half_space", "point": [0, 0], "normal": [0, 1]}},
        {"name": "load", "kind": "pressure", "pressure": 0,
         "geometry": {"shape": "box", "lower": [-1, 0.05], "upper": [1, 0.2]}}],
    "measurement": [{"name": "top", "kind": "point_displacement", "point": [0.1, 0.1], "axis": "y"}],
    "output": {"every": 0.01},
}


class Module(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def run_cylinder(self):
        out = self.folder / "out"
        subprocess.run([PROGRAM, "run", SOURCE / "cases/rotating_cylinder", "--quiet", "--threads", "1", "--out", out,
                        "--set", "discretisation.spacing=0.1", "--set", "time.step=0.001", "--set", "time.end=0.02",
                        "--set", "output.every=0.01", "--set", "output.surface=true"], check=True)
        return out

    def test_results_are_those_of_the_file(self):
        with pliant.open_result(self.run_cylinder()) as result:
            numpy.testing.assert_allclose(result.times, [0, 0.01, 0.02])
            frame = result[-1]
            self.assertEqual(result.summary["particles"]["end"], len(frame.positions))
            self.assertEqual((len(frame.positions), 3), frame["velocity"].shape)
            self.assertEqual("m/s", frame.unit("velocity"))
            times, values = result.history("energy_ratio")
            self.assertEqual(result.summary["measurements"]["energy_ratio"]["value"], values[-1])
            self.assertEqual(len(times), len(values))
            surface = result.surface(0)
            self.assertLess(surface.pieces.max(), len(surface.positions))
            self.assertIn("[time]", result.settings)
            with self.assertRaises(IndexError):
                result[3]

    def test_a_simulation_goes_where_the_program_goes_to_the_bit(self):
        (self.folder / "block.toml").write_text(pliant.read_case(BLOCK).text)
        out, load = self.folder / "out", {"boundary.load.pressure": 500}
        subprocess.run([PROGRAM, "run", self.folder / "block.toml", "--quiet", "--threads", "1", "--out", out,
                        "--set", "boundary.load.pressure=500"], check=True)
        simulation = pliant.Simulation(self.folder / "block.toml", load, threads=1)
        with pliant.open_result(out) as result:
            for frame in result:
                simulation.advance(frame.time)
                numpy.testing.assert_array_equal(frame["velocity"][:, :2], simulation.field("velocity"))
                numpy.testing.assert_array_equal(frame.positions, simulation.positions())

    def test_a_case_is_built_from_a_dictionary_and_its_load_is_changed(self):
        simulation = pliant.Simulation(BLOCK, threads=1)
        self.assertEqual((["block"], 2), (simulation.bodies, simulation.dimension))
        self.assertEqual(0, simulation.measurement("top"))
        simulation.set_pressure("load", 500)
        simulation.advance(0.02)
        self.assertAlmostEqual(0.02, simulation.time)
        self.assertLess(simulation.measurement("top"), -1e-4)
        self.assertAlmostEqual(20, simulation.totals()["mass"])

    def test_components_are_views_of_the_memory_of_the_solver(self):
        simulation = pliant.Simulation(BLOCK, threads=1)
        slots = simulation.slots()
        self.assertEqual(simulation.particle_count, len(slots))
        first, second = (simulation.components(0, "velocity")[1] for _ in range(2))
        self.assertEqual(first.__array_interface__["data"], second.__array_interface__["data"])
        self.assertFalse(first.flags.owndata)
        with self.assertRaises(ValueError):
            first[slots[0]] = 1
        simulation.set_pressure("load", 500)
        simulation.step()
        present = simulation.components(0, "velocity")[1][slots]
        numpy.testing.assert_array_equal(present, simulation.field("velocity")[:, 1])
        self.assertLess(present.min(), 0)
        self.assertIn("velocity", simulation.fields())

    def test_a_view_outlives_the_name_of_its_simulation(self):
        simulation = pliant.Simulation(BLOCK, threads=1)
        view = simulation.components(0, "velocity")[0]
        del simulation
        self.assertTrue(numpy.isfinite(view).any())

    def test_a_blade_in_the_hand_of_the_caller_cuts_and_its_session_plays_again(self):
        # The scalpel of the case waits; the caller moves it through the block until that is in two
        # parts.
        settings = {"discretisation.spacing": 0.01, "cut.scalpel.start": 99, "cut.scalpel.end": 100}
        first, second = (pliant.Simulation(SOURCE / "cases/block_cut", settings, threads=1) for _ in range(2))
        for y in numpy.linspace(-0.04, 0.04, 17):
            first.move_blade("scalpel", [0, y, -0.01], [0, y, 0.05])
            first.step()
        first.lift_blade("scalpel")
        self.assertEqual(2, first.measurement("parts"))
        self.assertEqual(["blade", "advance"], [one.kind.name for one in first.session[:2]])
        numpy.testing.assert_allclose([0, -0.04, -0.01], first.session[0].first)
        pliant.write_inputs(self.folder / "session.csv", first.session)
        second.play(pliant.read_inputs(self.folder / "session.csv"))
        numpy.testing.assert_array_equal(first.positions(), second.positions())

    def test_inputs_are_taken_at_their_time_and_budgets_are_kept(self):
        simulation = pliant.Simulation(BLOCK, threads=1)
        simulation.enter(pliant.Input(pliant.InputKind.pressure, time=0.01, name="load", value=500))
        simulation.advance(0.01)
        self.assertEqual(0, simulation.measurement("top"))
        progress = simulation.advance(0.02, 1e-9)
        self.assertEqual(1, progress.steps)
        self.assertAlmostEqual(0.02 - simulation.time, progress.lag)
        simulation.advance(0.03)
        self.assertLess(simulation.measurement("top"), -1e-4)

    def test_saved_states_are_restored_to_the_bit(self):
        simulation, other = pliant.Simulation(BLOCK, threads=1), pliant.Simulation(BLOCK, threads=2)
        simulation.set_pressure("load", 500)
        simulation.advance(0.01)
        simulation.save(self.folder / "state.h5")
        other.restore(self.folder / "state.h5")
        for one in (simulation, other):
            one.advance(0.02)
        numpy.testing.assert_array_equal(simulation.positions(), other.positions())

    def test_mistakes_are_named(self):
        with self.assertRaisesRegex(pliant.InputError, "spacing"):
            pliant.Simulation({**BLOCK, "discretisation": {"spacing": -1}})
        with self.assertRaisesRegex(pliant.InputError, "velocity"):
            pliant.Simulation(BLOCK).field("speed")
        with self.assertRaisesRegex(pliant.InputError, "a case holds"):
            pliant.Simulation({**BLOCK, "time": {"end": object()}})


if __name__ == "__main__":
    del sys.argv[1:4]
    unittest.main()
