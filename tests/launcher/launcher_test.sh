#!/bin/sh
# The launcher on a machine without anything: every outside program is a fake that notes how it was called.
# usage: launcher_test.sh SOURCE_FOLDER
set -eu
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
expect() { # expect DESCRIPTION COMMAND…
    description=$1
    shift
    if "$@"; then echo "ok: $description"; else
        echo "FAILED: $description"
        failed=1
    fi
}

mkdir -p "$work/project/cmake" "$work/fakes"
cp "$source/umbral" "$work/project/"
mkdir -p "$work/project/tests"
cp "$source/tests/turns.txt" "$work/project/tests/"
cp "$source/cmake/debian-packages.txt" "$work/project/cmake/"
printf 'absent no-such-command-anywhere  # a comment\npresent sh\n' >"$work/project/cmake/debian-packages-test.txt"
for name in apt-get sudo cmake; do
    printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n' "$name" "$work" >"$work/fakes/$name"
done
printf '[ "$1" = --preset ]\n' >>"$work/fakes/cmake"  # configuring works, building fails
printf '#!/bin/sh\necho "g++ installed"\nexit 1\n' >"$work/fakes/dpkg-query"
chmod +x "$work/fakes"/*
PATH=$work/fakes:$PATH

status=0
(cd "$work/project" && ./umbral --no-install list) >"$work/printed" 2>&1 || status=$?
expect "--no-install ends with status 2" [ "$status" -eq 2 ]
expect "--no-install names what is missing" grep -q 'libglm-dev' "$work/printed"
expect "--no-install does not name what is there" sh -c "! grep -qE '(^| )g\+\+ ' '$work/printed'"
expect "--no-install calls no apt" [ ! -e "$work/calls" ]

status=0
(cd "$work/project" && ./umbral list) >"$work/printed" 2>&1 || status=$?
expect "a build that fails ends with status 3" [ "$status" -eq 3 ]
expect "it says so" grep -q 'the build failed' "$work/printed"
expect "it says what it installs" grep -q 'installing what is missing: .*libglm-dev' "$work/printed"
expect "apt installs only what is missing" grep -qE '^(sudo )?apt-get install .*libglm-dev' "$work/calls"
expect "apt gets no comment lines" sh -c "! grep -q '#' '$work/calls'"
expect "it builds from the folder of the launcher" grep -q 'cmake --preset release' "$work/calls"
expect "it builds the program, and not all units" grep -q 'cmake --build --preset release --target program *$' "$work/calls"
# What the demo grades is built beside the program.
mkdir -p "$work/project/exercises/meshes/weld"
printf '# the demo\nmeshes/weld\n' >"$work/project/tests/demo-units.txt"
(cd "$work/project" && ./umbral demo) >"$work/printed" 2>&1 || true
expect "the demo's units are built with the program" \
    grep -q 'cmake --build --preset release --target program unit-meshes-weld *$' "$work/calls"
rm -r "$work/project/tests/demo-units.txt" "$work/project/exercises"
expect "a failed build leaves no stamp" [ ! -e "$work/project/build/release/stamp" ]

# A unit that somebody asked for once is kept up to date; one that is gone is not asked for.
mkdir -p "$work/project/build/release/units/meshes/weld" "$work/project/build/release/units/meshes/gone" "$work/project/exercises/meshes/weld"
: >"$work/project/build/release/units/meshes/weld/built"
mkdir -p "$work/project/build/release/units/meshes/area" "$work/project/exercises/meshes/area"
: >"$work/project/build/release/units/meshes/area/answers"
: >"$work/project/exercises/meshes/area/exercise.json"
: >"$work/project/build/release/units/meshes/gone/built"
: >"$work/project/exercises/meshes/weld/exercise.json"
(cd "$work/project" && ./umbral list) >"$work/printed" 2>&1 || true
expect "units that were built are built again, with mistakes or without" grep -q 'cmake --build --preset release --target program answers-meshes-area unit-meshes-weld *$' "$work/calls"

# So are programs of commands that not everybody calls, once one was called.
mkdir -p "$work/project/build/release/bin"
: >"$work/project/build/release/bin/umbral-authors"
: >"$work/project/build/release/bin/umbral-debug-gl"
(cd "$work/project" && ./umbral list) >"$work/printed" 2>&1 || true
expect "programs that were built are built again" grep -q 'cmake --build --preset release --target program umbral-authors umbral-debug-gl answers-meshes-area' "$work/calls"
rm "$work/project/build/release/bin/umbral-authors" "$work/project/build/release/bin/umbral-debug-gl"

# A command of that name will do instead of its package; without one the package is installed.
: >"$work/calls"
(cd "$work/project" && ./umbral test) >"$work/printed" 2>&1 || true
expect "tests build everything" grep -q 'cmake --build --preset release --target all' "$work/calls"
expect "tests need more packages" grep -qE 'apt-get install .*libglm-dev .*absent' "$work/calls"
expect "a command that is there needs no package" sh -c "! grep -qE ' present( |$)' '$work/calls'"

# From here on builds work.
mkdir -p "$work/project/build/release/bin"
for name in "$work/fakes/cmake" "$work/fakes/ctest" "$work/project/build/release/bin/umbral"; do
    printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n' "${name##*/}" "$work" >"$name"
    chmod +x "$name"
done

# Whoever has to wait for another build is told so.
(
    flock 8
    echo held >"$work/held"
    sleep 1
) 8>"$work/project/build/release/lock" &
while [ ! -e "$work/held" ]; do sleep 0.1; done
(cd "$work/project" && ./umbral list) >"$work/printed" 2>&1 || true
wait
expect "a call that waits for another build says so" grep -q 'another build is running in this checkout' "$work/printed"

# Each unit has its turn with one of twelve commits, and is validated with three more; each folder of tests has its turn
# with two of six, or with all.
mkdir -p "$work/project/exercises/transforms/hook" "$work/project/exercises/meshes/area" "$work/project/exercises/meshes/ply" \
    "$work/project/exercises/meshes/revolution" "$work/project/exercises/pipeline/clip-line"
for unit in transforms/hook meshes/area meshes/ply meshes/revolution pipeline/clip-line; do
    : >"$work/project/exercises/$unit/exercise.json"
done
# tested_with COUNT PATHS [--all]: notes what ./umbral test calls, with so many commits of which the last changed these
# files.
tested_with() {
    printf '#!/bin/sh\ncase "$*" in *rev-list*) echo %s ;; *log*) printf "%%s\\n" %s ;; esac\n' "$1" "$2" >"$work/fakes/git"
    chmod +x "$work/fakes/git"
    : >"$work/calls"
    rm -f "$work/project/build/release/stamp"*
    shift 2
    (cd "$work/project" && ./umbral test "$@") >"$work/printed" 2>&1 || true
}
asked_for() { sed -n "/--preset release/s/.*-D$1=\([^ ]*\).*/\1/p" "$work/calls" | tr ';' '\n'; }
: >"$work/turns"
: >"$work/parts"
: >"$work/validated"
for count in 0 1 2 3 4 5 6 7 8 9 10 11; do
    tested_with $((count + 900)) ''
    asked_for UMBRAL_WHOLE_UNITS >>"$work/turns"
    [ "$count" -ge 6 ] || asked_for UMBRAL_TEST_PARTS >>"$work/parts"
    sed -nE 's/^umbral validate --quiet --seeds 1 ([^-].*)/whole \1/p; s/^umbral validate .*--without-mistakes (.+)/right \1/p' \
        "$work/calls" | awk '{ for (i = 2; i <= NF; ++i) print $1, $i }' >>"$work/validated"
done
expect "twelve turns are all units, each once" [ "$(sed '/^$/d' "$work/turns" | sort | uniq -c | awk '$1 == 1' | wc -l)" -eq 6 ]
expect "each unit is validated whole once in twelve turns" \
    [ "$(grep whole "$work/validated" | sort | uniq -c | awk '$1 == 1' | wc -l)" -eq 6 ]
expect "and three times without its mistakes" \
    [ "$(grep right "$work/validated" | sort | uniq -c | awk '$1 == 3' | wc -l)" -eq 6 ]
tested() { sort "$work/parts" | uniq -c | awk -v times="$1" '$1 == times { print $2 }'; }
folders=$(cd "$source/tests" && for list in */CMakeLists.txt; do dirname "$list"; done | grep -vx support)
expect "each folder of tests has turns" [ "$(sort -u "$work/parts")" = "$(printf '%s\n' "$folders" | LC_ALL=C sort)" ]
expect "it has two of six, or all" [ "$({ tested 2; tested 6; } | wc -l)" -eq "$(printf '%s\n' "$folders" | wc -l)" ]

# What changed lately is tested whole, whatever of it changed.
tested_with 907 'exercises/meshes/ply/soups.hpp docs/units.md'
expect "a unit whose folder changed" [ "$(asked_for UMBRAL_WHOLE_UNITS)" = meshes/ply ]
tested_with 907 'reference/pipeline/clip_line_oracle.cpp reference/meshes/gone.cpp'
expect "a unit whose oracle changed" [ "$(asked_for UMBRAL_WHOLE_UNITS)" = pipeline/clip-line ]
tested_with 907 'tests/units/meshes/area_test.cpp exercises/meshes/support.hpp'
expect "a unit whose test changed" [ "$(asked_for UMBRAL_WHOLE_UNITS)" = meshes/area ]
tested_with 907 '' --all
expect "--all compiles all mistakes and tests" grep -qE -- '-DUMBRAL_WHOLE_UNITS=\*/\* -DUMBRAL_TEST_PARTS=( |$)' "$work/calls"
exit $failed
