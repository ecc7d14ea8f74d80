# To be sourced: a display without a screen, and $work, a folder, until the script ends. Ends it with 77 if what is
# needed is not installed.
for program in Xvfb xdotool; do
    if ! command -v "$program" > /dev/null; then
        echo "SKIPPED: $program is not installed (see cmake/debian-packages-test.txt): REAL WINDOWS WERE NOT TRIED"
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

