#!/usr/bin/env bash
# Runs clang-tidy over the sources compiled in BUILD_DIR whose path matches one of the patterns (default: all but tests).
# usage: tidy.sh BUILD_DIR [REGEX...]
set -uo pipefail
build=$(realpath "$1")
shift
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit

# clang-tidy cannot read the precompiled headers of another compiler: every source includes what it needs without them.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
sed -E 's# (-Winvalid-pch|-include [^ ]*/cmake_pch\.hxx)##g' "$build/compile_commands.json" >"$commands/compile_commands.json"

run-clang-tidy -quiet -p "$commands" -j "$(nproc)" "${@:-^$PWD/(apps|libs|rawlog_tools)/}" 2>&1 |
  grep -vE '^[0-9]+ warnings? (generated|treated)|^clang-tidy.* -p=|^$'
status=${PIPESTATUS[0]}
((status == 0)) && echo "clang-tidy: no findings"
exit "$status"
