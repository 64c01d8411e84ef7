"""Each check passes a good tree and names file and line in a bad one."""

import tempfile
import unittest
from pathlib import Path

import equation_tags
import include_arrows
import links
import unwanted_text

TAG = "QQ" ".1"  # split, so that the check of this tree does not find it


class Checks(unittest.TestCase):
    def found(self, check, **tree):
        """Problems in a tree given as name=text, with / written as __ and . as _dot_."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in tree.items():
                path = Path(folder) / name.replace("__", "/").replace("_dot_", ".")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return list(check(Path(folder)))

    def test_includes_along_the_arrows_pass(self):
        self.assertEqual([], self.found(
            include_arrows.check,
            kernels__a_dot_hpp="#include <vector>\n#include <xsimd/xsimd.hpp>\n",
            scheduler__b_dot_cpp="#include <oneapi/tbb/flow_graph.h>\n",
            engine__c_dot_cpp='#include <hdf5.h>\n#include "kernels/a.hpp"\n',
            tests__d_dot_cpp='#include "kernels/a.hpp"\n'))

    def test_includes_against_the_arrows_are_named(self):
        problems = self.found(
            include_arrows.check,
            kernels__a_dot_hpp='\n#include "engine/c.hpp"\n',
            kernels__e_dot_cpp="#include <tbb/tbb.h>\n",
            scheduler__b_dot_cpp='#include "kernels/a.hpp"\n',
            engine__c_dot_hpp='#include "tests/d.hpp"\n',
            tests__d_dot_hpp="")
        places = [problem.split(": ")[0] for problem in problems]
        self.assertEqual(
            ["engine/c.hpp:1", "kernels/a.hpp:2", "kernels/e.cpp:1", "scheduler/b.cpp:1"], places)

    def test_an_include_relative_to_its_own_folder_is_named(self):
        problems = self.found(include_arrows.check, kernels__a_dot_hpp="",
                              kernels__b_dot_cpp='#include "a.hpp"\n')
        self.assertEqual(1, len(problems))

    def test_arrows_between_folders_of_the_engine_are_held(self):
        problems = self.found(
            include_arrows.check,
            engine__case__a_dot_hpp='#include "engine/remeshed/b.hpp"\n',
            engine__remeshed__b_dot_hpp='#include "engine/method/c.hpp"\n',
            engine__method__c_dot_hpp="",
            engine__new__d_dot_hpp='#include "engine/case/a.hpp"\n')
        self.assertEqual(
            ["engine/case/a.hpp:1: engine/remeshed/b.hpp: of engine/, engine/case/ may include geometry only",
             "engine/new/d.hpp:1: engine/case/a.hpp: engine/new/ is not in the table of folders in "
             "cmake/checks/include_arrows.py"], problems)

    def test_a_cycle_through_a_source_file_is_named(self):
        tree = dict(kernels__a_dot_hpp='#include "kernels/b.hpp"\n',
                    kernels__b_dot_hpp="", kernels__c_dot_hpp="")
        self.assertEqual([], self.found(
            include_arrows.check, kernels__b_dot_cpp='#include "kernels/c.hpp"\n', **tree))
        self.assertEqual(
            ["kernels/a: includes itself by way of kernels/b; take out what they share"],
            self.found(include_arrows.check, kernels__b_dot_cpp='#include "kernels/a.hpp"\n', **tree))

    def test_the_table_of_folders_has_no_cycle(self):
        self.assertEqual([], list(include_arrows.check_table()))
        self.assertEqual([["a", "b"]], include_arrows.cycles({"a": ["b"], "b": ["a", "c"], "c": []}))

    def test_a_tag_of_the_tables_passes(self):
        self.assertEqual([], self.found(
            equation_tags.check, docs__equations_dot_md=f"| ({TAG}) | a = b | |\n",
            kernels__a_dot_hpp=f"/// ({TAG})\n"))

    def test_a_tag_of_no_table_is_named(self):
        problems = self.found(equation_tags.check, docs__equations_dot_md="| (QQ" ".2) | a = b | |\n",
                              kernels__a_dot_hpp=f"\n/// by ({TAG})\n")
        self.assertEqual([f"kernels/a.hpp:2: ({TAG}) is not in the equation tables of docs/*.md"],
                         problems)

    def test_a_tag_defined_twice_is_named(self):
        row = f"| ({TAG}) | a = b | |\n"
        self.assertEqual(1, len(self.found(equation_tags.check, docs__equations_dot_md=row + row)))

    def test_marks_and_machine_paths_are_named(self):
        problems = self.found(unwanted_text.check, a_dot_cpp="// TO" "DO later\n",
                              b_dot_md="see \n`/ho" "me/me/x`\n", c_dot_sh="cd ${x}/wo" "rk/y\n")
        places = [problem.split(": ")[0] for problem in problems]
        self.assertEqual(["a.cpp:1", "b.md:2"], places)

    def test_dead_links_are_named(self):
        problems = self.found(links.check, docs__a_dot_md="[b](b.md) [x](x.md)\n[w](https://w.org)\n",
                              docs__b_dot_md="`[code](none)` [a](a.md#part)\n")
        self.assertEqual(["docs/a.md:1: x.md: the link leads nowhere"], problems)

    def test_sources_that_do_not_exist_are_named(self):
        problems = self.found(links.check, engine__a__b_dot_cpp="", engine__c_dot_hpp_dot_in="",
                              d_dot_md="`a/b.cpp` `c.hpp` `NAME/fields.hpp`\n`b/a.cpp`\n")
        self.assertEqual(["d.md:2: b/a.cpp: there is no such source"], problems)


if __name__ == "__main__":
    unittest.main()
