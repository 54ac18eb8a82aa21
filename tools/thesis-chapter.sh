#!/bin/bash
# Runs everything that the thesis' chapter on two-dimensional flow needs and makes its figures: the seven uniform flow
# conditions, condition 2 at a finer spacing, conditions 3 and 6 with the original SPS closure, and the case of the 2016
# paper with both closures; then riffle report --thesis.
#
# Usage: tools/thesis-chapter.sh [-o FOLDER] [--set SECTION.KEY=VALUE]...
#
#   -o FOLDER   where the runs and thesis.html go (default: results/thesis)
#   --set ...   for every run, as in `riffle run`: --set run.until='"1 s"' for a quick trial
#
# About 20 minutes on two cores. A second call goes on where the first was stopped: runs that are complete are kept,
# others are resumed. RIFFLE names the program (default: build/release/bin/riffle, else that on the PATH).
set -euo pipefail
cd "$(dirname "$0")/.."

folder=results/thesis
settings=()
while [ $# -gt 0 ]; do
    case $1 in
        -o) folder=${2:?-o needs a folder}; shift 2 ;;
        --set) settings+=(--set "${2:?--set needs section.key=value}"); shift 2 ;;
        -h | --help) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
        *) echo "tools/thesis-chapter.sh: unknown option $1 (see --help)" >&2; exit 2 ;;
    esac
done
riffle=${RIFFLE:-build/release/bin/riffle}
[ -x "$riffle" ] || riffle=$(command -v riffle) || {
    echo "tools/thesis-chapter.sh: no program at build/release/bin/riffle; build it first, or name it in RIFFLE" >&2
    exit 2
}

# run NAME CASE [OPTION...]: run a case into its folder, or go on with it.
run() {
    local name=$1 case=$2
    shift 2
    if [ ! -e "$folder/$name/results.h5" ]; then
        "$riffle" run "$case" -o "$folder/$name" "$@" "${settings[@]}"
    elif grep -qs finished "$folder/$name/run.log"; then
        echo "$folder/$name: complete"
    else
        "$riffle" resume "$folder/$name"
    fi
}

for number in 1 2 3 5 6 7 8; do
    run "condition-$number" "cases/rough-bed-2d/condition-$number.toml"
done
run condition-2-1.5mm cases/rough-bed-2d/condition-2.toml --set numerics.spacing='"1.5 mm"'

# The SPS closure has no steady flow to start from, and does not settle soon.
sps=(--set turbulence.closure=sps --set start.kind=uniform --set numerics.sound_speed=12 --set run.until='"10 s"')
run condition-3-sps cases/rough-bed-2d/condition-3.toml "${sps[@]}" --set start.velocity=0.26
run condition-6-sps cases/rough-bed-2d/condition-6.toml "${sps[@]}" --set start.velocity=0.42
run paper-2016 cases/paper-2016.toml
run paper-2016-sps cases/paper-2016.toml "${sps[@]}" --set start.velocity=0.35 \
    --set turbulence.smagorinsky_constant=0.15 --set turbulence.filter_width='"2 mm"'

"$riffle" report --thesis "$folder"
