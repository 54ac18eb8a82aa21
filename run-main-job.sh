#!/bin/bash
# Riffle's main job, from a bare Debian 12 to a report: install what is needed, build, simulate flow condition 2
# (2D, until converged), write the report.
#
# Usage: ./run-main-job.sh
#
# Needs root or sudo for packages that are not there yet. Takes some minutes; a second call builds only what changed.
set -euo pipefail
cd "$(dirname "$0")"
if [ $# -gt 0 ]; then
    sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"
    case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi
. tools/packages.sh

case=cases/rough-bed-2d/condition-2.toml
results=results/main-job

install_packages "${build_packages[@]}" $(node_packages)
configure_options=(-DRIFFLE_INSTRUCTION_SETS=machine)  # the others would take a quarter of the build
build release --target riffle

say "Simulating $case"
build/release/bin/riffle run "$case" -o "$results" --force

say "Writing the report"
build/release/bin/riffle report "$results" >/dev/null
echo "report: $PWD/$results/report.html"
