#!/bin/sh
# run.sh FOLDER UMBRAL PAGES SOURCE: grades part of the sample class and drives the reports in a browser. Everything it
# makes lies in FOLDER.
set -eu
folder=$1
umbral=$2
pages=$3
source=$4

need() {
    command -v "$1" >/dev/null || {
        printf 'The browser tests need %s: install the packages of cmake/debian-packages-test.txt (apt-get install chromium nodejs npm).\n' "$1" >&2
        exit 1
    }
}
need node
need npm
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || need chromium

mkdir -p "$folder"
cp "$source/tests/browser/package.json" "$source/tests/browser/package-lock.json" "$source"/tests/browser/*.mjs "$folder/"
if ! [ -d "$folder/node_modules/playwright-core" ] || ! cmp -s "$folder/package-lock.json" "$folder/installed-lock.json"; then
    (cd "$folder" && npm ci --no-audit --no-fund --omit=optional >npm.log 2>&1) || {
        cat "$folder/npm.log" >&2
        printf 'npm ci failed: the browser tests fetch playwright-core once, which needs a network the first time.\n' >&2
        exit 1
    }
    cp "$folder/package-lock.json" "$folder/installed-lock.json"
fi

rm -rf "$folder/class" "$folder/reports" "$folder/made-up"
mkdir -p "$folder/class"
for submission in ana-all-right bruno-untouched carla-typical-mistakes elena-does-not-compile; do
    cp -R "$source/tests/class/$submission" "$folder/class/"
done
echo "a secret of the browser tests" >"$folder/secret"
"$umbral" grade "$folder/class" --out "$folder/reports" --secret-file "$folder/secret" --with-hidden --jobs 1 \
    --unit raytracing/sphere --unit projections/view-matrix >"$folder/grade.log" 2>&1 || {
    cat "$folder/grade.log" >&2
    exit 1
}
"$pages" "$folder/made-up" >/dev/null
UMBRAL_BROWSER=$browser UMBRAL_PAGES=$folder node --test --test-concurrency=1 "$folder"/*.test.mjs
