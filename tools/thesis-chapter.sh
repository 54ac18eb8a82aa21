#!/bin/bash
# Runs what the thesis' chapters on simulations and the paper of 2016 need, and makes their figures:
#
#   4      the seven uniform flow conditions in two dimensions, conditions 3 and 6 at a second spacing and with the
#          original SPS closure at two spacings, and condition 2 at 2 mm
#   paper  the case of the paper, with both closures
#   5      conditions 1, 2, 5 and 8 in three dimensions between side walls, 2 and 5 at a second spacing, 1 with a lower
#          roughness
#   6      conditions 1, 2, 5 and 8 in two and in three dimensions, and 5 with the original SPS closure in both
#
# Usage: tools/thesis-chapter.sh [4] [paper] [5] [6] [--size laptop|workstation|thesis] [-o FOLDER]
#                                [--set SECTION.KEY=VALUE]...
#
#   4 5 6 ...   the parts to make (default: 4 and paper); each run serves all of them
#   --size ...  of the runs in three dimensions. laptop: half of the width beside a plane of symmetry, 3 and 4 mm;
#               workstation: the whole width, 2.5 to 4 mm; thesis: the whole width, 1.5 and 2.5 mm as there (the thesis
#               took 40 to 80 days for each). Default: laptop
#   -o FOLDER   where the runs and thesis.html go (default: results/thesis)
#   --set ...   for every run, as in `riffle run`: --set run.until='"1 s"' for a quick trial
#
# A second call goes on where the first was stopped: runs that are complete are kept, others are resumed. RIFFLE names
# the program (default: build/release/bin/riffle, else that on the PATH).
set -euo pipefail
cd "$(dirname "$0")/.."

folder=results/thesis
size=laptop
parts=()
settings=()
while [ $# -gt 0 ]; do
    case $1 in
        4 | 5 | 6 | paper) parts+=("$1"); shift ;;
        --size) size=${2:?--size needs laptop, workstation or thesis}; shift 2 ;;
        -o) folder=${2:?-o needs a folder}; shift 2 ;;
        --set) settings+=(--set "${2:?--set needs section.key=value}"); shift 2 ;;
        -h | --help) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
        *) echo "tools/thesis-chapter.sh: unknown option $1 (see --help)" >&2; exit 2 ;;
    esac
done
[ ${#parts[@]} -gt 0 ] || parts=(4 paper)
riffle=${RIFFLE:-build/release/bin/riffle}
[ -x "$riffle" ] || riffle=$(command -v riffle) || {
    echo "tools/thesis-chapter.sh: no program at build/release/bin/riffle; build it first, or name it in RIFFLE" >&2
    exit 2
}
mkdir -p "$folder"

wanted() {
    local part one
    for part in "${parts[@]}"; do
        for one in "$@"; do [ "$part" = "$one" ] && return 0; done
    done
    return 1
}

# run NAME CASE [OPTION...]: run a case with the instruments of the figures into its folder, or go on with it.
run() {
    local name=$1 case=$2
    shift 2
    if [ ! -e "$folder/$name/results.h5" ]; then
        # Means over the plane of the centreline (Figs 4.6, 4.9, 4.12), its velocity in time (4.20), and the surface
        # along the channel (4.18, 4.19, 5.34).
        {
            cat "$case"
            printf '\n[[probe]]\nname = "means"\nkind = "grid"\nspacing = "4 mm"\naveraging_time = "0.5 s"\n'
            printf 'sampling_frequency = "20 Hz"\n'
            printf '\n[[probe]]\nname = "plane"\nkind = "grid"\naveraging_time = 0\nspacing = "5 mm"\nsampling_frequency = "50 Hz"\n'
            printf '\n[[probe]]\nname = "surface"\nkind = "surface_line"\nspacing = "5 mm"\nsampling_frequency = "50 Hz"\n'
        } >"$folder/$name.toml"
        "$riffle" run "$folder/$name.toml" -o "$folder/$name" "$@" "${settings[@]}"
    elif grep -qs finished "$folder/$name/run.log"; then
        echo "$folder/$name: complete"
    else
        "$riffle" resume "$folder/$name"
    fi
}

# The SPS closure has no steady flow to start from, and does not settle soon.
sps=(--set turbulence.closure=sps --set start.kind=uniform --set numerics.sound_speed=12 --set run.until='"10 s"')

if wanted 4; then
    for number in 1 2 3 5 6 7 8; do
        run "condition-$number" "cases/rough-bed-2d/condition-$number.toml"
    done
    run condition-2-2mm cases/rough-bed-2d/condition-2.toml --set numerics.spacing='"2 mm"'
    for number in 3 6; do
        case=cases/rough-bed-2d/condition-$number.toml
        velocity=$([ $number = 3 ] && echo 0.26 || echo 0.42)
        run condition-$number-2mm "$case" --set numerics.spacing='"2 mm"'
        run condition-$number-sps "$case" "${sps[@]}" --set start.velocity=$velocity
        run condition-$number-sps-2mm "$case" "${sps[@]}" --set start.velocity=$velocity --set numerics.spacing='"2 mm"'
    done
fi
if wanted paper; then
    run paper-2016 cases/paper-2016.toml
    run paper-2016-sps cases/paper-2016.toml "${sps[@]}" --set start.velocity=0.35 \
        --set turbulence.smagorinsky_constant=0.15 --set turbulence.filter_width='"2 mm"'
fi

# space NAME NUMBER SPACING [OPTION...]: a condition in three dimensions for 6 s, as long as in the thesis.
space() {
    local name=$1 number=$2 spacing=$3 width=()
    shift 3
    [ "$size" = laptop ] && width=(--set channel.sides=half)
    run "$name" "cases/rough-bed-3d/condition-$number.toml" "${width[@]}" --set numerics.spacing="\"$spacing mm\"" \
        --set run.until='"6 s"' --set run.average_from='"3 s"' --set output.mean_field_interval='"0.5 s"' \
        --set output.snapshot_interval='"3 s"' "$@"
}
# Spacings of conditions 1, 2, 5 and 8, and the second ones of 2 and 5.
case $size in
    laptop) spacings=(3 3 4 4) second=(4 5) ;;
    workstation) spacings=(2.5 3 3 4) second=(4 4) ;;
    thesis) spacings=(1.5 1.5 2.5 2.5) second=(2 3) ;;
    *) echo "tools/thesis-chapter.sh: unknown size $size: expected laptop, workstation or thesis" >&2; exit 2 ;;
esac
if wanted 5 6; then
    space condition-1-3d 1 "${spacings[0]}"
    space condition-2-3d 2 "${spacings[1]}"
    space condition-5-3d 5 "${spacings[2]}"
    space condition-8-3d 8 "${spacings[3]}"
fi
if wanted 5; then
    space condition-2-3d-coarser 2 "${second[0]}"
    space condition-5-3d-coarser 5 "${second[1]}"
    space condition-1-3d-lower 1 "${spacings[0]}" --set bed.roughness_height='"0.32 D"'
fi
if wanted 6; then
    for number in 1 2 5 8; do
        run "condition-$number" "cases/rough-bed-2d/condition-$number.toml"
    done
    case=cases/rough-bed-2d/condition-5.toml
    run condition-5-sps "$case" "${sps[@]}" --set start.velocity=0.36 --set numerics.spacing="\"${spacings[2]} mm\"" \
        --set run.until='"6 s"'
    space condition-5-3d-sps 5 "${spacings[2]}" --set turbulence.closure=sps --set numerics.sound_speed=12
fi

list=$(IFS=,; echo "${parts[*]}")
"$riffle" report --thesis="$list" "$folder"
