# shellcheck shell=bash disable=SC2034 # what it sets is used by the scripts that read this one
# Shared by tests/bench/<part>/run BIN_DIRECTORY OUT_DIRECTORY [--quick]: reads the arguments, draws charts.
# SPDX-License-Identifier: MIT

[ $# -ge 2 ] || {
    echo "usage: $0 BIN_DIRECTORY OUT_DIRECTORY [--quick]" >&2
    exit 2
}
bin=$(realpath "$1")
out=$(realpath -m "$2")
quick=("${@:3}")
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd -P)
mkdir -p "$out"

# needs PROGRAM PACKAGE...: a part that lacks something is left out, which is the exit status 77.
needs() {
    command -v "$1" >/dev/null || {
        echo "left out: $1 is missing; it comes with: ${*:2}"
        exit 77
    }
}

# field PART NAME: a line of the part's JSON, such as its machine.
field() { sed -nE "s/^ \"$2\": \"?(.*[^\",])\"?,?\$/\1/p" "$out/$1.json" | head -n 1; }

# chart PART SCRIPT: SCRIPT draws $out/PART.csv with gnuplot, as PNG and SVG.
chart() {
    needs gnuplot gnuplot-nox
    local kind terminal
    for kind in png svg; do
        terminal="pngcairo size 1100,760 font 'DejaVu Sans,10'"
        [ $kind = png ] || terminal="svg size 1100,760 dynamic background rgb 'white' font 'DejaVu Sans,10'"
        gnuplot -e "csv='$out/$1.csv'; csvs='$out'; set terminal $terminal; set output '$out/$1.$kind.tmp'" \
            -e "machine='$(field "$1" machine), $(field "$1" cores) cores; $(field "$1" driver); $(field "$1" date)'" \
            "$(dirname "${BASH_SOURCE[0]}")/style.gp" "$2"
        mv "$out/$1.$kind.tmp" "$out/$1.$kind"
    done
}
