#!/bin/bash
# Check that the C++ sources are formatted as .clang-format and tools/brace_style.py say;
# `tools/check-format.sh --fix` formats them.
# Other versions of clang-format disagree in details: it must be version 14, Debian 12's.
set -euo pipefail
cd "$(dirname "$0")/.."
format=$(command -v clang-format-14 || command -v clang-format) ||
    { echo "skipped: no clang-format (package clang-format-14)"; exit 77; }
"$format" --version | grep -q 'version 14\.' ||
    { echo "skipped: $format is not version 14 (package clang-format-14)"; exit 77; }
mode=(--dry-run -Werror)
[ "${1-}" = --fix ] && mode=(-i)
sources() { find src tests -name '*.cpp' -print0 -o -name '*.hpp' -print0; }
[ "${1-}" = --fix ] && sources | xargs -0 tools/brace_style.py --fix
sources | xargs -0 "$format" "${mode[@]}"
sources | xargs -0 tools/brace_style.py
