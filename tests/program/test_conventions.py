import json
import os
import pty
import re
import shutil
import subprocess
import tomllib
import unittest

from program import CASE, PROGRAM, SMALL, SOURCE, ProgramTest, main

try:
    import jsonschema
except ImportError:
    jsonschema = None

COMMANDS = ("run", "check", "list", "new", "graph", "reference", "bench", "profile", "batch", "calibrate", "report", "schema", "completion",
            "manual", "help")


class Conventions(ProgramTest):
    def printed(self, *arguments):
        status, out, err = self.pliant(*arguments)
        self.assertEqual((0, ""), (status, err))
        return out

    def options_of(self, *command):
        return set(re.findall(r"^ +(?:-h,)?(--[a-z-]+)", self.printed("help", *command), re.MULTILINE))

    def on_terminal(self, *arguments, **environment):
        """What the program writes to a terminal."""
        master, slave = pty.openpty()
        process = subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.DEVNULL, stderr=slave, cwd=self.folder,
                                   env={**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment})
        os.close(slave)
        text = b""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError:
                break
            if not part:
                break
            text += part
        process.wait()
        os.close(master)
        return text.decode(errors="replace")

    def test_help_names_every_command(self):
        listed = self.printed("help").split("Commands:")[1]
        self.assertEqual(set(COMMANDS), set(re.findall(r"^  ([a-z]+) ", listed, re.MULTILINE)))

    def bash_completes(self, *words):
        script = ("compopt() { :; }; source completion; COMP_WORDS=(pliant %s); COMP_CWORD=%d; _pliant; "
                  "printf '%%s\\n' \"${COMPREPLY[@]}\"" % (" ".join(f"'{word}'" for word in words), len(words)))
        (self.folder / "completion").write_text(self.printed("completion", "bash"))
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        return set(done.stdout.split("\n")) - {""}

    def test_bash_completes_commands_options_and_files(self):
        self.assertEqual(set(COMMANDS), self.bash_completes(""))
        self.assertEqual({"run", "reference", "report"}, self.bash_completes("r"))
        for command in COMMANDS:
            self.assertEqual(self.options_of(command) | {"-h"}, self.bash_completes(command, "-") | {"-h"}, command)
        (self.folder / "a case").mkdir()
        (self.folder / "file").touch()
        self.assertEqual({"a case", "file", "completion"}, self.bash_completes("run", ""))
        self.assertEqual({"a case"}, self.bash_completes("run", "--out", ""))
        self.assertEqual({"json"}, self.bash_completes("graph", "--format", "j"))
        self.assertEqual({"status"}, self.bash_completes("batch", "sta"))
        self.assertIn("--json", self.bash_completes("batch", "status", "-"))
        self.assertEqual({"bash"}, self.bash_completes("completion", "b"))

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish_completes_commands_and_options(self):
        (self.folder / "pliant.fish").write_text(self.printed("completion", "fish"))

        def completes(line):
            out = subprocess.run(["fish", "-N", "-c", f"source pliant.fish; complete -C '{line}'"], cwd=self.folder,
                                 env={**os.environ, "HOME": str(self.folder)}, capture_output=True, text=True,
                                 check=True).stdout
            return {one.split("\t")[0] for one in out.splitlines()}

        self.assertEqual(set(COMMANDS), completes("pliant "))
        for command in ("run", "profile"):
            self.assertEqual(self.options_of(command), {one for one in completes(f"pliant {command} -")
                                                        if one.startswith("--")})

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_completion(self):
        script = self.folder / "_pliant"
        script.write_text(self.printed("completion", "zsh"))
        subprocess.run(["zsh", "-n", script], check=True)
        for option in self.options_of("run"):
            self.assertIn(f"'{option}[" if option != "--set" else "'*--set[", script.read_text())

    def test_the_manual_page_has_every_command_and_option(self):
        page = self.printed("manual")
        for command in COMMANDS:
            self.assertIn(f"\\fBpliant {command}\\fR", page)
            for option in self.options_of(command):
                self.assertIn(option.replace("-", "\\-"), page)
        if shutil.which("man") and shutil.which("groff"):
            (self.folder / "pliant.1").write_text(page)
            done = subprocess.run(["man", "--warnings", "./pliant.1"], cwd=self.folder, capture_output=True, text=True)
            self.assertEqual("", done.stderr)

    def test_check_and_list_print_json(self):
        found = json.loads(self.printed("check", CASE, *SMALL[:-2], "--json"))
        self.assertEqual(("rotating_cylinder", 2, 0.1), (found["name"], found["dimension"], found["spacing"]))
        self.assertIn("energy_ratio", found["measurements"])
        rows = json.loads(self.printed("list", SOURCE / "cases", "--json"))
        self.assertEqual(sorted(path.parent.name for path in SOURCE.glob("cases/*/case.toml")),
                         [row["name"] for row in rows])

    def test_a_new_case_runs_and_is_never_written_over(self):
        self.printed("new", "jelly")
        status, _, err = self.pliant("run", "jelly", "--set", "time.end=0.01", "--threads", "2")
        self.assertEqual(0, status, err)
        summary = json.loads((self.folder / "results/jelly/summary.json").read_text())
        # It falls freely from 0.005 m above the floor: 10.5 mm in 0.01 s, so that it has reached
        # the floor.
        self.assertGreater(summary["measurements"]["largest_force"]["value"], 0)
        status, _, err = self.pliant("new", "jelly")
        self.assertEqual(2, status)
        self.assertIn("jelly/case.toml: exists already; give another name", err)

    def test_a_new_case_says_where_its_results_will_be(self):
        for name in ("my/jelly", "my/other/", str(self.folder / "far/away")):
            self.printed("new", name)
            text = (self.folder / name / "case.toml").read_text()
            self.assertIn(f"writes results/{name.rstrip('/').split('/')[-1]}; open result.xdmf", text)

    def test_check_warns_of_a_cut_by_few_spacings(self):
        coarse = ("check", SOURCE / "cases/edge_cut", "--set", "discretisation.spacing=1/10")
        status, _, err = self.pliant(*coarse)
        self.assertEqual(0, status, err)
        self.assertIn("warning: the cut `blade` advances by 5.5 spacings only", err)
        self.assertIn("5.5 spacings only", json.loads(self.pliant(*coarse, "--json")[1])["warnings"][0])

    def test_a_copied_case_has_its_mesh(self):
        self.printed("new", "liver", "--from", SOURCE / "cases/organ")
        self.assertEqual((SOURCE / "cases/organ/organ.ply").read_bytes(), (self.folder / "liver/organ.ply").read_bytes())
        self.assertIn("liver: ", self.printed("check", "liver"))

    def test_colour_is_for_terminals_that_want_it(self):
        self.assertIn("\x1b[31mpliant rnu: no such command", self.on_terminal("rnu"))
        self.assertNotIn("\x1b[31m", self.on_terminal("rnu", NO_COLOR="1"))
        self.assertNotIn("\x1b[31m", self.on_terminal("rnu", TERM="dumb"))
        self.assertNotIn("\x1b", self.pliant("rnu")[2])

    def test_a_run_on_a_terminal_says_what_it_sets_up_and_where_it_starts(self):
        text = self.on_terminal(*self.arguments_of_run())
        self.assertRegex(text, "^rotating_cylinder: setting up about [0-9]+ particles in .* steps; 2 threads")
        self.assertIn("  0 %  t = 0 s  step 0", text)


@unittest.skipUnless(jsonschema, "python3-jsonschema is not installed")
class SchemaOfCases(ProgramTest):
    def setUp(self):
        super().setUp()
        schema = json.loads(self.pliant("schema")[1])
        jsonschema.Draft7Validator.check_schema(schema)
        self.validator = jsonschema.Draft7Validator(schema)

    def case(self, name):
        return tomllib.loads((SOURCE / "cases" / name / "case.toml").read_text())

    def test_it_admits_every_shipped_case(self):
        files = [*SOURCE.glob("cases/*/case.toml"), *SOURCE.glob("docs/**/*.toml")]
        self.assertGreater(len(files), 20)
        for file in files:
            case = tomllib.loads(file.read_text())
            if "sweep" in case or "discretisation" not in case:
                continue
            with self.subTest(case=file):
                self.assertEqual([], [error.message for error in self.validator.iter_errors(case)])

    def test_it_refuses_what_the_program_refuses(self):
        changes = {
            "discretisation.spacing": -1, "discretisation.kernel": "cubic", "discretisation.spacingg": 1,
            "time.end": [1], "dimension": 4, "method": "fem", "gravity": [1], "checks.mass": "ignore",
            "body.0.material.youngs_moduls": 3, "body.0.geometry.shape": "cone", "body.0.geometry.radius": 0,
            "measurement.0.kind": "colour", "measurement.0.when": 1, "remeshing.every": 0.5, "remeshing.filter": 2,
        }
        for key, value in changes.items():
            case = self.case("rotating_cylinder")
            *tables, last = key.split(".")
            table = case
            for name in tables:
                table = table[int(name)] if name.isdigit() else table.setdefault(name, {})
            table[last] = value
            with self.subTest(key=key):
                self.assertFalse(self.validator.is_valid(case))
                status, _, err = self.pliant("check", CASE, "--set", f"{key}={json.dumps(value)}")
                self.assertEqual(2, status, err)

    def test_it_knows_which_keys_a_kind_has(self):
        case = self.case("bouncing_ball")
        wall = next(one for one in case["boundary"] if one["kind"] == "contact_wall")
        wall["pressure"] = 3
        self.assertFalse(self.validator.is_valid(case))
        del wall["pressure"], wall["geometry"]
        self.assertFalse(self.validator.is_valid(case))


if __name__ == "__main__":
    main()
