#!/usr/bin/env bash
# Fails on C++ that clang-format would write differently. usage: format.sh [CLANG_FORMAT]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
find apps libs rawlog_tools tests training -name '*.h' -print0 -o -name '*.cpp' -print0 |
  xargs -0 "${1:-clang-format}" --dry-run -Werror
