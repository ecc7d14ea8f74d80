#!/usr/bin/env bash
# compare_lab4.sh REAL HEADLESS: lab 4's program in a real window on a display without a screen, and without a window;
# after each key the light must stand at the same place and the frame look the same: 192 mean colours, which may differ
# by a level where two drivers' edges do. 77 means: what is needed is not installed.
set -euo pipefail
real=$1
headless=$2
. "$(dirname "$0")/display.sh"

"$real" > "$work/real.txt"
"$headless" > "$work/headless.txt"
paste -d ' ' "$work/real.txt" "$work/headless.txt" | awk '
    function distance(a, b) { return a < b ? b - a : a - b }
    {
        if (NF != 2 * 583) { print "frame " NR - 1 ": expected 2 * 583 words, got " NF; wrong = 1; next }
        for (i = 1; i <= 583; ++i) {
            allowed = i > 7 ? 1 : 0.002
            same = i == 2 || i == 7 ? $i == $(583 + i) : distance($i, $(583 + i)) <= allowed
            if (!same) { print "frame " NR - 1 ", word " i ": real " $i ", headless " $(583 + i); wrong = 1 }
            if (i > 7 && distance($i, before[i]) > 1) ++changes
            before[i] = $i
        }
    }
    END {
        print NR " frames, " changes + 0 " cells changed from one to the next"
        if (NR != 11 || changes < 500) { print "expected 11 frames, and 500 changes"; wrong = 1 }
        exit wrong
    }'
