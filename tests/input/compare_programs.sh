#!/usr/bin/env bash
# compare_programs.sh REAL HEADLESS: event loops, and a program that reads its input in three modes, in a window of the
# real GLFW on a display without a screen, and without a window; both must draw, update, show and hear the same in the
# same order. 77 means: what is needed is not installed.
set -euo pipefail
real=$1
headless=$2
. "$(dirname "$0")/display.sh"

"$real" > "$work/real.txt"
"$headless" > "$work/headless.txt"
lines=$(wc -l < "$work/real.txt")
echo "$lines lines"
diff -u --label "real GLFW" "$work/real.txt" --label "headless GLFW" "$work/headless.txt"
# An empty log on both sides would prove nothing.
[ "$lines" -gt 60 ]
