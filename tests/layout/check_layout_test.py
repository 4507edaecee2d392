#!/usr/bin/env python3
"""Every rule of check_layout.py must catch a made-up tree that breaks it, at the right line."""

import pathlib
import tempfile
import unittest

from check_layout import Checker

TABLE = """| floor | room | what |
|---|---|---|
| 1 | `core` | x |
| 2 | `features` | x |
| 2 | `knowledge` | x |
| 3 | `filters` | x |

| floor | folder | what |
|---|---|---|
| 1 | `tool/camera` | x |
| 1 | `tool/sensors` | x |
| 2 | `tool/output` | x |
"""


def header(room, body=""):
    return f"#pragma once\n{body}\nnamespace wardslam::{room} {{}}\n"


class LayoutTest(unittest.TestCase):
    def violations(self, files):
        """Of a tree with these files (path -> text)."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {"docs/architecture.md": TABLE, "libs/core/CMakeLists.txt": "", **files}.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return Checker(root).run()

    def assert_single(self, files, expected):
        found = self.violations(files)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(expected), found[0])

    def test_accepts_a_tree_that_keeps_the_rules(self):
        self.assertEqual([], self.violations({
            "libs/core/include/wardslam/core/a.h": header("core"),
            "libs/features/include/wardslam/features/b.h": header("features", '#include "wardslam/core/a.h"'),
            "libs/filters/src/c.cpp": '#include "wardslam/features/b.h"\n#include <wardslam/core/a.h>\n',
            "libs/filters/CMakeLists.txt": "wardslam_room(filters PUBLIC wardslam::core wardslam::features)\n",
            "tests/features/b_test.cpp": "",
        }))

    def test_upward_include(self):
        self.assert_single({"libs/core/src/a.cpp": '\n#include "wardslam/filters/c.h"\n'},
                           "libs/core/src/a.cpp:2: core (floor 1) includes filters (floor 3)")

    def test_include_on_the_same_floor(self):
        self.assert_single({"libs/features/src/a.cpp": "#include <wardslam/knowledge/c.h>\n"},
                           "libs/features/src/a.cpp:1: features (floor 2) includes knowledge (floor 2)")

    def test_include_of_an_unknown_room(self):
        self.assert_single({"libs/filters/src/a.cpp": '#include "wardslam/attic/c.h"\n'},
                           "libs/filters/src/a.cpp:1: includes unknown room 'attic'")

    def test_include_out_of_the_room(self):
        self.assert_single({"libs/filters/src/a.cpp": '#include "../../core/src/a.h"\n'},
                           "libs/filters/src/a.cpp:1: includes ../../core/src/a.h")

    def test_commented_include_is_none(self):
        self.assertEqual([], self.violations({"libs/core/src/a.cpp": '/*\n#include "wardslam/filters/c.h"\n*/\n'}))

    def test_upward_link(self):
        self.assert_single({"libs/features/CMakeLists.txt": "# wardslam::filters\nx(PUBLIC wardslam::filters)\n"},
                           "libs/features/CMakeLists.txt:2: features (floor 2) links filters (floor 3)")

    def test_room_without_floor(self):
        self.assert_single({"libs/attic/src/a.cpp": ""}, "libs/attic:1: room 'attic' has no floor")

    def test_missing_table(self):
        found = self.violations({"docs/architecture.md": "nothing here\n"})
        self.assertIn("docs/architecture.md:1: no table of rooms", found[0])

    def test_foreign_namespace(self):
        self.assert_single({"libs/core/include/wardslam/core/a.h": header("features")},
                           "libs/core/include/wardslam/core/a.h:1: nothing here is in namespace wardslam::core")

    def test_header_in_a_foreign_folder(self):
        self.assert_single({"libs/core/include/wardslam/other/a.h": header("core")},
                           "libs/core/include/wardslam/other/a.h:1: public headers of core lie in")

    def test_missing_pragma_once(self):
        self.assert_single({"libs/core/include/wardslam/core/a.h": "namespace wardslam::core {}\n"},
                           "libs/core/include/wardslam/core/a.h:1: a header needs #pragma once")

    def test_printing_and_exiting(self):
        for statement in ("std::cout << 1;", "std::cerr << 1;", "out(std::cerr);", "exit(1);", "std::exit(1);", 'printf("x");'):
            with self.subTest(statement):
                self.assert_single({"libs/core/src/a.cpp": f"void f() {{\n  {statement}\n}}\n"},
                                   "libs/core/src/a.cpp:2: a room neither prints nor ends the program")

    def test_holding_back_what_a_library_prints_is_allowed(self):
        self.assertEqual([], self.violations({"libs/core/src/a.cpp": "void f(B* b) { std::cerr.rdbuf(b); }\n"}))

    def test_text_and_comments_about_printing_are_allowed(self):
        code = '// std::cout\nconst char* kHelp = "exit(1) std::cerr";\nvoid f(P& p) { p.exit(1); onExit(2); }\n'
        self.assertEqual([], self.violations({"libs/core/src/a.cpp": code}))

    def test_long_file(self):
        self.assert_single({"apps/tool/main.cpp": "\n" * 451}, "apps/tool/main.cpp:451: longer than 450 lines")

    def test_mrpt_version_outside_the_compat_header(self):
        folder = "libs/core/include/wardslam/core/"
        for line in ("#if MRPT_VERSION >= 0x2e0", "#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 14, 0)",
                     "#if __has_include(<mrpt/viz/Scene.h>)", "  DEFINE_VIRTUAL_MRPT_OBJECT(Filter)"):
            with self.subTest(line):
                for path in ("apps/tool/main.cpp", "libs/core/src/mrpt_nav_compat.cpp"):
                    self.assert_single({path: f"\n{line}\n"},
                                       f"{path}:2: what depends on MRPT's version belongs in core/mrpt_compat.h")
                for allowed in ("mrpt_compat.h", "mrpt_nav_compat.h"):
                    self.assertEqual([], self.violations({folder + allowed: header("core", line)}))

    def test_test_without_a_source(self):
        self.assert_single({"tests/core/gone_test.cpp": ""}, "tests/core/gone_test.cpp:1: mirrors nothing")

    def test_accepts_folders_of_a_program_that_keep_the_rules(self):
        self.assertEqual([], self.violations({
            "apps/tool/main.cpp": '#include "output/b.h"\n#include "support/progress.h"\n',
            "apps/tool/camera/a.h": "#pragma once\n",
            "apps/tool/output/b.h": '#pragma once\n#include "camera/a.h"\n#include "wardslam/core/x.h"\n',
            "tests/tool/output/b_test.cpp": "",
            "tests/tool/program_test.cpp": "",
        }))

    def test_upward_include_within_a_program(self):
        self.assert_single({"rawlog_tools/tool/camera/a.cpp": '\n#include "output/b.h"\n'},
                           "rawlog_tools/tool/camera/a.cpp:2: camera (floor 1) includes output (floor 2)")

    def test_include_on_the_same_floor_of_a_program(self):
        self.assert_single({"apps/tool/camera/a.cpp": '#include "sensors/b.h"\n'},
                           "apps/tool/camera/a.cpp:1: camera (floor 1) includes sensors (floor 1)")

    def test_folder_that_includes_what_lies_above_all_folders(self):
        self.assert_single({"apps/tool/camera/a.cpp": '#include "b.h"\n', "apps/tool/b.h": "#pragma once\n"},
                           "apps/tool/camera/a.cpp:1: camera includes b.h, which lies in no folder")

    def test_folder_of_a_program_without_floor(self):
        self.assert_single({"apps/tool/attic/a.cpp": ""}, "apps/tool/attic:1: folder 'tool/attic' has no floor")

    def test_folders_are_no_rooms(self):
        self.assert_single({"libs/camera/src/a.cpp": ""}, "libs/camera:1: room 'camera' has no floor")

    def test_test_without_a_source_in_a_folder_of_a_program(self):
        self.assert_single({"apps/tool/camera/a.cpp": "", "tests/tool/output/a_test.cpp": ""},
                           "tests/tool/output/a_test.cpp:1: mirrors nothing")

    def test_names_of_programs_and_of_their_tests(self):
        table = TABLE.replace("tool/", "my-tool/")
        self.assert_single({"docs/architecture.md": table, "apps/my-tool/camera/a.cpp": "",
                            "tests/my_tool/camera/a_test.cpp": "", "tests/my_tool/camera/b_test.cpp": ""},
                           "tests/my_tool/camera/b_test.cpp:1: mirrors nothing")


if __name__ == "__main__":
    unittest.main()
