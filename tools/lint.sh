#!/bin/bash
# Run clang-tidy (checks in .clang-tidy) on the sources, with the commands of build/debug, which compiles each file alone.
#
# Usage: tools/lint.sh [FILE-REGEX]     all files of src/ (some 15 minutes on two cores), or those whose path matches
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/packages.sh
install_packages "${build_packages[@]}" "${lint_packages[@]}" $(node_packages)
[ -f build/debug/compile_commands.json ] || cmake --preset debug >/dev/null
# GCC's options in the commands are unknown to clang; "N warnings generated" counts suppressed ones of libraries.
run-clang-tidy-14 -quiet -extra-arg=-Wno-unknown-warning-option -p build/debug -j "$(nproc)" "${1-$PWD/src/.*}" 2>&1 |
    { grep -v -e 'warnings generated\.$' -e '^clang-tidy-14 ' -e '^$' || true; }
