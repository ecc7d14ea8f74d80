#!/usr/bin/env bash
# compare_with_real.sh REAL HEADLESS: plays one script to a real GLFW window on a display without a screen, and to
# headless GLFW; what the callbacks hear, and the commands that the reference makes of it, must be the same lines. 77
# means: what is needed is not installed.
set -euo pipefail
real=$1
headless=$2
script=$(dirname "$0")/desktop.script

. "$(dirname "$0")/display.sh"

failed=0
for mode in raw commands; do
    # A pointer that stands where the last run left it would begin elsewhere: every run moves it to the window's corner
    # first.
    "$real" "$mode" "$script" > "$work/real.txt"
    "$headless" "$mode" "$script" > "$work/headless.txt"
    if ! diff -u --label "real GLFW, $mode" "$work/real.txt" --label "headless GLFW, $mode" "$work/headless.txt"; then failed=1; fi
    lines=$(wc -l < "$work/real.txt")
    echo "$mode: $lines lines"
    # An empty log on both sides would prove nothing.
    if [ "$lines" -lt 25 ]; then failed=1; fi
done
exit $failed
