#!/usr/bin/env python3
"""Runs the commands of a tutorial as they stand.

usage: run_page.py PAGE --build BUILD_FOLDER --source SOURCE_FOLDER

Boxes marked sh are one script, run by bash in an empty folder with the programs of the build on PATH; the first command that
fails ends it, and bash names the page's own line. Comments of the page say what else is expected:

    <!-- makes: FILE ... -->   files that must be there at the end, and hold something
    <!-- says: TEXT -->        what the commands must have printed
    <!-- needs: NAME ... -->   PREFIX: an installation, made for it; DATABASE: a server, started for it

Exit codes: 0 good, 1 not, 77 something it needs is not on this computer.
"""

import argparse
import os
import pwd
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
COMMENT = re.compile(r"^<!-- (makes|says|needs): (.+) -->$")


class Skip(Exception):
    pass


class Page:
    """script has as many lines as the page, so that bash's line numbers are the page's."""

    def __init__(self, path):
        self.script = []
        self.makes, self.says, self.needs = [], [], []
        box = None
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith("```"):
                box = None if box is not None else line[3:].strip()
                self.script.append("")
                continue
            self.script.append(line if box == "sh" else "")
            comment = COMMENT.match(line) if box is None else None
            if comment:
                told = [comment[2]] if comment[1] == "says" else comment[2].split()
                getattr(self, comment[1]).extend(told)
        if box is not None:
            sys.exit(f"{path}: a box is not closed")
        if not any(self.script):
            sys.exit(f"{path}: has no box marked sh")


class Database:
    """A PostgreSQL server of its own on a socket in a temporary folder. As root it runs as the user postgres."""

    def __init__(self):
        found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"))
        if not found or not Path("/usr/share/postgresql", found[-1].parents[1].name, "extension/postgis.control").exists():
            raise Skip("no PostgreSQL server with PostGIS is installed")
        self.bin = found[-1].parent
        self.folder = tempfile.mkdtemp(prefix="wardslam_tutorial_database_")
        self.user = []
        if os.geteuid() == 0:
            try:
                os.chown(self.folder, pwd.getpwnam("postgres").pw_uid, -1)
            except KeyError:
                raise Skip("as root, a user postgres is needed") from None
            self.user = ["setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups"]
        self.run("initdb", "--no-sync", "--auth=trust", "--username=postgres", "-D", self.folder + "/data")
        self.run("pg_ctl", "start", "-w", "-D", self.folder + "/data", "-l", self.folder + "/log",
                 "-o", f"-c listen_addresses='' -c fsync=off -k '{self.folder}'")
        self.url = f"postgresql:///postgres?host={self.folder}&user=postgres"

    def run(self, program, *arguments):
        subprocess.run([*self.user, str(self.bin / program), *arguments], cwd="/", check=True, stdout=subprocess.DEVNULL)

    def stop(self):
        self.run("pg_ctl", "stop", "-w", "-m", "immediate", "-D", self.folder + "/data")
        shutil.rmtree(self.folder, ignore_errors=True)


def install(build, prefix):
    subprocess.run(["cmake", "--install", str(build), "--prefix", str(prefix)], check=True, stdout=subprocess.DEVNULL)
    return str(prefix)


def perform(page, name, environment, folder):
    """What is wrong, as sentences."""
    script = folder / name
    script.write_text("\n".join(page.script) + "\n", encoding="utf-8")
    work = folder / "work"
    work.mkdir()
    done = subprocess.run(["bash", "-euo", "pipefail", "-O", "inherit_errexit", "-c",
                           "trap 'echo \"$BASH_SOURCE: line $LINENO: failed: $BASH_COMMAND\" >&2' ERR; source \"$0\"",
                           str(script)],
                          cwd=work, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, encoding="utf-8", errors="replace", check=False)
    print(done.stdout)
    troubles = [f"{name}: a command failed ({done.returncode})"] if done.returncode else []
    for made in page.makes:
        if not (work / made).is_file() or (work / made).stat().st_size == 0:
            troubles.append(f"{name}: {made} is not there, or empty")
    troubles += [f"{name}: nothing said '{said}'" for said in page.says if said not in done.stdout]
    return troubles


def run(path, build, source, folder):
    page = Page(path)
    environment = dict(os.environ, PATH=f"{build / 'bin'}:{os.environ['PATH']}", SOURCE=str(source), HOME=str(folder))
    database = None
    try:
        if "PREFIX" in page.needs:
            environment["PREFIX"] = install(build, folder / "prefix")
        if "DATABASE" in page.needs:
            database = Database()
            environment["DATABASE"] = database.url
        return perform(page, path.name, environment, folder)
    finally:
        if database is not None:
            database.stop()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", type=Path)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--source", type=Path, required=True)
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # no server is left behind
    with tempfile.TemporaryDirectory(prefix="wardslam_tutorial_") as folder:
        try:
            troubles = run(arguments.page, arguments.build.resolve(), arguments.source.resolve(), Path(folder))
        except Skip as reason:
            print(f"skipped: {reason}")
            sys.exit(SKIPPED)
    for trouble in troubles:
        print(trouble)
    sys.exit(1 if troubles else 0)


if __name__ == "__main__":
    main()
