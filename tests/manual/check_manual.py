"""Checks that the manual page and the completion of a program name all that its --help names, command by command.

usage: check_manual.py PROGRAM PAGE COMPLETION
"""
import pathlib
import re
import shutil
import subprocess
import sys


def help_of(program, path):
    """The options and commands that `program path... --help` lists."""
    text = subprocess.run([program, *path, "--help"], capture_output=True, text=True, check=True).stdout
    lists, _, commands = text.partition("\nSubcommands:\n")
    options = set()
    for line in lists.splitlines():
        if re.match(r"  -", line):
            options.update(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", line.split()[0].replace(",", " ")))
    return options, re.findall(r"^  (\w[\w-]*)", commands, re.MULTILINE)


def sections_of(page):
    """The text of each command in the page, by its heading; '' is the program itself."""
    plain = re.sub(r"\\-", "-", page)
    parts = re.split(r"^\.S[SH] (.*)$", plain, flags=re.MULTILINE)
    return {heading: text for heading, text in zip(parts[1::2], parts[2::2])}


def completions(script, name, words):
    """What bash proposes for the last of the words."""
    code = f'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); {name}; printf "%s\\n" "${{COMPREPLY[@]}}"'
    result = subprocess.run(["bash", "-c", code, "bash", script, *words], capture_output=True, text=True, check=True)
    return set(result.stdout.split())


def check(program, page, script):
    name = pathlib.Path(program).name
    function = re.search(r"^(\w+)\(\) \{", pathlib.Path(script).read_text(), re.MULTILINE).group(1)
    sections = sections_of(pathlib.Path(page).read_text())
    complaints = []
    paths = [[]]
    while paths:
        path = paths.pop()
        options, commands = help_of(program, path)
        if "--help" not in options:
            complaints.append(f"{name} {' '.join(path)}: its --help could not be understood")
        text = sections.get(" ".join([name, *path]) if path else "OPTIONS", "")
        for option in sorted(options):
            if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", text):
                complaints.append(f"{page}: {' '.join([name, *path, option])} is missing")
        for proposed, known in ((completions(script, function, [name, *path, "-"]), options),
                                (completions(script, function, [name, *path, ""]), set(commands))):
            if proposed != known:
                complaints.append(f"{script}: {name} {' '.join(path)}: {sorted(proposed ^ known)}")
        paths += [[*path, command] for command in commands]
    if shutil.which("man"):
        result = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], capture_output=True, text=True)
        complaints += result.stderr.splitlines()
    return complaints


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    found = check(*sys.argv[1:])
    print("\n".join(found))
    sys.exit(1 if found else 0)
