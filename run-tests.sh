#!/bin/bash
# Install what is needed, build with warnings as errors, run the tests; ends with the summary of ctest.
#
# Usage: ./run-tests.sh           the quick tests (unit, verification, end to end, formatting)
#        ./run-tests.sh --long    the long ones: validation against the measurements
#
# Needs root or sudo for packages that are not there yet. Exit status: 0 when all tests pass.
set -euo pipefail
cd "$(dirname "$0")"
preset=ci
case ${1-} in
    "") ;;
    --long) preset=long ;;
    *)
        sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"
        case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
        ;;
esac
. tools/packages.sh

install_packages "${build_packages[@]}" "${test_packages[@]}" $(node_packages)
build ci

# The browser of the report's test; its record of what is installed is as old as the installation.
if [ ! web/node_modules/.package-lock.json -nt web/package-lock.json ]; then
    say "Installing the report's test browser driver"
    npm ci --prefix web --ignore-scripts --no-audit --no-fund --loglevel=error
    touch web/node_modules/.package-lock.json
fi

say "Testing"
exec ctest --preset "$preset" --parallel "$(nproc)"
