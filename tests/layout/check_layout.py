#!/usr/bin/env python3
"""Checks that the source tree keeps to docs/architecture.md.

usage: check_layout.py PROJECT_ROOT

The floors are read from the table of rooms in docs/architecture.md: a room may include and link only rooms on lower
floors. So it is with the folders of a program that has some, by the table of `program/folder`. Every violation is printed as "file:line: what"; the exit code is 1 when there is one.
"""

import re
import sys
from pathlib import Path

MAX_LINES = 450
PROGRAM_FOLDERS = ("apps", "rawlog_tools")
CODE_FOLDERS = ("libs", *PROGRAM_FOLDERS, "tests")
FLOOR_ROW = re.compile(r"^\|\s*(\d+)\s*\|\s*`([\w-]+(?:/\w+)?)`\s*\|")
MRPT_COMPAT = re.compile(r"libs/core/include/wardslam/core/mrpt_(\w+_)?compat\.h")
MRPT_VERSION = re.compile(r"MRPT_VERSION|__has_include\s*\(\s*[<\"]mrpt/|\bDEFINE_VIRTUAL_MRPT_OBJECT")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROOM_TARGET = re.compile(r"\bwardslam(?:::|_)(\w+)")
PRINTS_OR_EXITS = re.compile(r"\bstd::(cout|cerr|clog)\b(?!\.rdbuf\()|(?<![\w.>])(printf|puts|exit|_exit|quick_exit|abort)\s*\(")
COMMENT_OR_STRING = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>\w*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)


def read_floors(root):
    """Room, or program/folder -> floor."""
    table = root / "docs/architecture.md"
    lines = table.read_text(encoding="utf-8").splitlines() if table.exists() else []
    return {row[2]: int(row[1]) for row in map(FLOOR_ROW.match, lines) if row}


def blanked(text, strings):
    """The text with comments (and strings, when asked) as blanks; lines keep their numbers."""

    def blank(match):
        keep = match[0][0] != "/" and not strings
        return match[0] if keep else re.sub(r"[^\n]", " ", match[0])

    return COMMENT_OR_STRING.sub(blank, text)


def numbered(text):
    return enumerate(text.splitlines(), 1)


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cpp"))


class Checker:
    def __init__(self, root):
        self.root = root
        self.floors = read_floors(root)
        self.violations = []

    def run(self):
        if not self.floors:
            self.report(self.root / "docs/architecture.md", 1, "no table of rooms found ('| floor | `room` | ...')")
        for folder in sorted(path for path in (self.root / "libs").iterdir() if path.is_dir()):
            self.check_room(folder)
        for folder in self.folders_of_programs():
            self.check_folder(folder)
        for path in (path for folder in CODE_FOLDERS for path in sources(self.root / folder)):
            self.check_shape(path)
            self.check_mrpt_version(path)
        for path in sorted((self.root / "tests").glob("*/*_test.cpp")):
            self.check_mirrors_source(path)
        for path in sorted((self.root / "tests").glob("*/*/*_test.cpp")):
            self.check_mirrors_folder(path)
        return self.violations

    def report(self, path, line, what):
        self.violations.append(f"{path.relative_to(self.root)}:{line}: {what}")

    def check_room(self, folder):
        if folder.name not in self.floors:
            self.report(folder, 1, f"room '{folder.name}' has no floor in docs/architecture.md")
            return
        for path in sources(folder):
            self.check_room_source(folder.name, path)
        cmake = folder / "CMakeLists.txt"
        for number, line in numbered(cmake.read_text(encoding="utf-8") if cmake.exists() else ""):
            for other in ROOM_TARGET.findall(line.split("#")[0]):
                if other in self.floors:
                    self.check_floor(folder.name, other, cmake, number, "links")
        public = folder / "include/wardslam" / folder.name
        for path in sources(folder / "include"):
            if public not in path.parents:
                self.report(path, 1, f"public headers of {folder.name} lie in include/wardslam/{folder.name}/")

    def check_room_source(self, room, path):
        text = path.read_text(encoding="utf-8")
        for number, line in numbered(blanked(text, strings=False)):
            include = INCLUDE.match(line)
            if include:
                self.check_include(room, path, number, include[1])
        for number, line in numbered(blanked(text, strings=True)):
            if PRINTS_OR_EXITS.search(line):
                self.report(path, number, "a room neither prints nor ends the program: throw, or count an event")
        if path.suffix == ".h" and not re.search(rf"^namespace wardslam::{room}\b", text, re.M):
            self.report(path, 1, f"nothing here is in namespace wardslam::{room}")

    def check_include(self, room, path, number, target):
        parts = Path(target).parts
        if ".." in parts:
            self.report(path, number, f"includes {target}: '..' leads out of the room")
        if parts[0] == "wardslam" and len(parts) > 1:
            self.check_floor(room, parts[1], path, number, "includes")

    def check_floor(self, room, other, path, number, verb):
        if other not in self.floors:
            self.report(path, number, f"{verb} unknown room '{other}'")
        elif other != room and self.floors[other] >= self.floors[room]:
            self.report(path, number, f"{room} (floor {self.floors[room]}) {verb} {other} (floor "
                                      f"{self.floors[other]}); only lower floors are allowed")

    def programs(self):
        for above in PROGRAM_FOLDERS:
            yield from sorted(path for path in (self.root / above).glob("*") if path.is_dir())

    def folders_of_programs(self):
        for program in self.programs():
            yield from sorted(path for path in program.iterdir() if path.is_dir() and sources(path))

    def check_folder(self, folder):
        program = folder.parent
        own = f"{program.name}/{folder.name}"
        if own not in self.floors:
            self.report(folder, 1, f"folder '{own}' has no floor in docs/architecture.md")
            return
        for path in sources(folder):
            for number, line in numbered(blanked(path.read_text(encoding="utf-8"), strings=False)):
                include = INCLUDE.match(line)
                if include:
                    self.check_include_of_folder(program, folder.name, path, number, include[1])

    def check_include_of_folder(self, program, folder, path, number, target):
        own, other = f"{program.name}/{folder}", f"{program.name}/{Path(target).parts[0]}"
        if "/" not in target and (program / target).exists():
            self.report(path, number, f"{folder} includes {target}, which lies in no folder")
        elif other in self.floors and other != own and self.floors[other] >= self.floors[own]:
            self.report(path, number, f"{folder} (floor {self.floors[own]}) includes {Path(target).parts[0]} (floor "
                                      f"{self.floors[other]}); only lower floors are allowed")

    def check_shape(self, path):
        lines = path.read_text(encoding="utf-8").splitlines()
        if path.suffix == ".h" and "#pragma once" not in lines:
            self.report(path, 1, "a header needs #pragma once")
        if len(lines) > MAX_LINES:
            self.report(path, len(lines), f"longer than {MAX_LINES} lines: split it")

    def check_mrpt_version(self, path):
        if MRPT_COMPAT.fullmatch(path.relative_to(self.root).as_posix()) or path.name == "mrpt_compat_test.cpp":
            return
        for number, line in numbered(blanked(path.read_text(encoding="utf-8"), strings=False)):
            if MRPT_VERSION.search(line):
                self.report(path, number, "what depends on MRPT's version belongs in core/mrpt_compat.h or core/mrpt_*_compat.h")

    def check_mirrors_source(self, path):
        room = path.parent.name
        name = path.name[: -len("_test.cpp")]
        if room in self.floors and not any(source.stem == name for source in sources(self.root / "libs" / room)):
            self.report(path, 1, f"mirrors nothing: libs/{room} has no {name}.h or {name}.cpp")

    def check_mirrors_folder(self, path):
        """Of tests/<program>/<folder>/; in the tests' names '-' is '_'."""
        name = path.name[: -len("_test.cpp")]
        for program in self.programs():
            folders = [own for own in self.floors if own.startswith(f"{program.name}/")]
            if not folders or program.name.replace("-", "_") != path.parent.parent.name:
                continue
            if not any(source.stem == name for source in sources(program / path.parent.name)):
                folder = (program / path.parent.name).relative_to(self.root)
                self.report(path, 1, f"mirrors nothing: {folder} has no {name}.h or {name}.cpp")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    violations = Checker(Path(sys.argv[1]).resolve()).run()
    for violation in violations:
        print(violation)
    print(f"layout: {len(violations)} violation(s)")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
