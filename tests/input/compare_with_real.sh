#!/usr/bin/env bash
# compare_with_real.sh REAL HEADLESS: plays one script to a real GLFW window on a display without a screen, and to
# headless GLFW; what the
# callbacks hear, and the commands that the reference makes of it, must be the same lines. 77 means: what is needed is
# not installed.
set -euo pipefail
real=$1
headless=$2
script=$(dirname "$0")/desktop.script

for program in Xvfb xdotool; do
    if ! command -v "$program" > /dev/null; then
        echo "SKIPPED: $program is not installed (see cmake/debian-packages-test.txt): HEADLESS GLFW WAS NOT COMPARED WITH THE REAL ONE"
        exit 77
    fi
done

work=$(mktemp -d)
server=
finish() {
    if [ -n "$server" ]; then
        kill "$server" 2> /dev/null || true
        wait "$server" 2> /dev/null || true
    fi
    rm -rf "$work"
}
trap finish EXIT

# The server takes a free display itself and writes its number. -r: no key repeats by itself, however slow the machine
# is.
mkfifo "$work/number"
Xvfb -displayfd 3 -screen 0 1280x1024x24 -r -noreset -nolisten tcp 3> "$work/number" > "$work/server.txt" 2>&1 &
server=$!
if ! read -r -t 60 number < "$work/number"; then
    echo "Xvfb did not start:"
    cat "$work/server.txt"
    exit 1
fi
export DISPLAY=":$number"
unset WAYLAND_DISPLAY XAUTHORITY
# In a build with sanitizers: what the libraries of X keep for themselves until the end is not ours to free.
export ASAN_OPTIONS=detect_leaks=0

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
