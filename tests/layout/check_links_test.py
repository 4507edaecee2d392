#!/usr/bin/env python3
"""check_links.py must find dead links and accept those that lead somewhere."""

import pathlib
import tempfile
import unittest

from check_links import dead_links


class LinksTest(unittest.TestCase):
    def found(self, readme):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "docs").mkdir()
            (root / "README.md").write_text(readme, encoding="utf-8")
            (root / "docs/map.md").write_text("# Map\n\n## Objects, as JSON\n[up](../README.md)\n", encoding="utf-8")
            return dead_links(root)

    def test_accepts_files_headings_and_the_net(self):
        self.assertEqual([], self.found("[a](docs/map.md) [b](docs/map.md#objects-as-json) [c](https://x.org/none)\n"))

    def test_finds_a_missing_file(self):
        self.assertEqual(["README.md:2: docs/none.md: there is no such file"], self.found("\n![x](docs/none.md)\n"))

    def test_finds_a_missing_heading(self):
        self.assertEqual(["README.md:1: docs/map.md#things: no heading there is called that"],
                         self.found("[x](docs/map.md#things)\n"))


if __name__ == "__main__":
    unittest.main()
