#!/bin/bash
# Run clang-tidy (checks in .clang-tidy) on the sources, with the commands of build/ci.
#
# Usage: tools/lint.sh [FILE-REGEX]     all files of src/, or those whose path matches
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/packages.sh
install_packages "${build_packages[@]}" "${lint_packages[@]}" $(node_packages)
[ -f build/ci/compile_commands.json ] || cmake --preset ci >/dev/null
exec run-clang-tidy-14 -quiet -p build/ci -j "$(nproc)" "${1-$PWD/src/.*}" 2>/dev/null
