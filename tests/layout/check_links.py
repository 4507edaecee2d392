#!/usr/bin/env python3
"""Checks that the links of the documents lead somewhere: to files of the tree, and to headings in them.

usage: check_links.py PROJECT_ROOT

Links to the net are not followed. Every dead link is printed as "file:line: what"; the exit code is 1 when there is one.
"""

import re
import sys
from pathlib import Path

DOCUMENTS = ("*.md", "docs/*.md")
LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*)$", re.M)
ELSEWHERE = re.compile(r"^\w+:")  # https:, mailto:


def anchors(document):
    """What a heading is called in links: lower case, blanks as dashes, without punctuation."""
    text = document.read_text(encoding="utf-8")
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in HEADING.findall(text)}


def dead_links(root):
    found = []
    for document in sorted(path for pattern in DOCUMENTS for path in root.glob(pattern)):
        for number, line in enumerate(document.read_text(encoding="utf-8").splitlines(), 1):
            for link in LINK.findall(line):
                if ELSEWHERE.match(link):
                    continue
                name, _, anchor = link.partition("#")
                target = document.parent / name if name else document
                place = f"{document.relative_to(root)}:{number}"
                if not target.exists():
                    found.append(f"{place}: {link}: there is no such file")
                elif anchor and anchor not in anchors(target):
                    found.append(f"{place}: {link}: no heading there is called that")
    return found


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = dead_links(Path(sys.argv[1]).resolve())
    for line in found:
        print(line)
    print(f"links: {len(found)} dead")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
