#!/usr/bin/env python3
"""That run_page.py finds what is wrong with a page."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

RUNNER = Path(__file__).with_name("run_page.py")


def run(text):
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder, "page.md")
        page.write_text(text, encoding="utf-8")
        (Path(folder) / "bin").mkdir()
        return subprocess.run([sys.executable, "-B", RUNNER, page, "--build", folder, "--source", folder],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)


class RunPage(unittest.TestCase):
    def expect(self, code, part, text):
        done = run(text)
        self.assertEqual(done.returncode, code, done.stdout)
        self.assertIn(part, done.stdout + done.stderr if done.stderr else done.stdout)

    def test_a_page_that_is_right(self):
        self.expect(0, "hello", "# Page\n```sh\ncd /tmp >/dev/null && cd - >/dev/null\nA=hello\n```\n"
                    "text\n```sh\necho $A | tee out.txt\n! false\n```\n<!-- makes: out.txt -->\n<!-- says: hello -->\n")

    def test_a_command_that_fails_is_named_with_the_line_of_the_page(self):
        self.expect(1, "page.md: line 4: failed: no_such_program", "# Page\n```sh\ntrue\nno_such_program\ntouch late\n```\n")

    def test_nothing_is_run_after_a_failure(self):
        done = run("```sh\nfalse\necho later\n```\n")
        self.assertEqual(done.returncode, 1)
        self.assertNotIn("later\n", done.stdout)

    def test_a_command_that_should_fail_and_does_not(self):
        self.expect(1, "a command failed", "```sh\nwrong() { ! true; }\nwrong\n```\n")

    def test_a_failure_within_a_pipe(self):
        self.expect(1, "a command failed", "```sh\nfalse | cat\n```\n")

    def test_a_name_that_is_not_set(self):
        self.expect(1, "a command failed", "```sh\necho $NO_SUCH_NAME_HERE\n```\n")

    def test_a_file_that_is_not_made(self):
        self.expect(1, "none.txt is not there", "```sh\ntrue\n```\n<!-- makes: none.txt -->\n")

    def test_a_file_that_is_empty(self):
        self.expect(1, "empty.txt is not there, or empty", "```sh\ntouch empty.txt\n```\n<!-- makes: empty.txt -->\n")

    def test_words_that_are_not_said(self):
        self.expect(1, "nothing said 'word'", "```sh\necho other\n```\n<!-- says: word -->\n")

    def test_boxes_without_a_mark_are_not_run(self):
        self.expect(0, "", "```\nno_such_program\n```\n```sh\ntrue\n```\n")

    def test_a_page_without_commands(self):
        self.expect(1, "has no box marked sh", "# Page\n")

    def test_a_box_that_is_not_closed(self):
        self.expect(1, "not closed", "```sh\ntrue\n")


if __name__ == "__main__":
    unittest.main()
