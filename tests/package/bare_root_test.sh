#!/bin/sh
# The Debian packages on a system that has nothing: made by cpack, installed by apt in a fresh root, used there.
# Students' first, then instructors'. The root comes from the mirrors that this machine's apt is configured with. Takes
# minutes, hence only with UMBRAL_TEST_ALL set.
# usage: bare_root_test.sh SOURCE_FOLDER BUILD_FOLDER
set -eu
source=$1
build=$2
skip() {
    echo "skipped: $1"
    exit 77
}
[ -n "${UMBRAL_TEST_ALL:-}" ] || skip "UMBRAL_TEST_ALL is not set"
[ "$(id -u)" -eq 0 ] || skip "a root of its own is made by root only"
for program in debootstrap dpkg-shlibdeps unshare pivot_root; do
    command -v $program >/dev/null || skip "$program is not installed"
done
unshare -m true 2>/dev/null || skip "this machine allows no mount namespaces"

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
root=$work/root
step() { echo "$(date +%T) $*"; }

step "packing"
(cd "$build" && cmake --build . --target installable >/dev/null && cpack --config CPackConfig.cmake -B "$work/packages" >"$work/cpack.log" 2>&1) ||
    { tail -n 20 "$work/cpack.log"; exit 1; }
for package in "$work"/packages/*.deb; do
    echo "$(basename "$package"): $(stat -c %s "$package") bytes, installed $(dpkg-deb -f "$package" Installed-Size) KiB; $(dpkg-deb -f "$package" Depends)"
done

# The first mirror that apt knows for this machine's own release; debootstrap checks the signature with the system's own
# keys.
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
mirror=$(apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' "Created-By: Packages" | awk -v release="$release" '$2 == release && $3 == "main" { print $1; exit }')
[ -n "$mirror" ] || skip "apt on this machine knows no mirror of $release"
step "a bare root of $release"
debootstrap --variant=minbase "$release" "$root" "$mirror" >"$work/debootstrap.log" 2>&1 || { tail -n 20 "$work/debootstrap.log"; exit 1; }
# Names are resolved, and mirrors reached, as outside.
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
for file in /etc/apt/apt.conf.d/*proxy*; do [ ! -f "$file" ] || cp "$file" "$root/etc/apt/apt.conf.d/"; done
echo "the root takes $(du -sm "$root" | cut -f1) MiB"
mkdir "$root/packages" "$root/submissions"
cp "$work"/packages/*.deb "$root/packages/"
cp -R "$source/tests/class/." "$root/submissions/"
printf 'the same secret gives the same hidden cases' >"$root/secret"
cp "$source/tests/package/in_bare_root.sh" "$root/"

# Not chroot: in one, the kernel allows no user namespaces.
step "in the root"
unshare -m -p -f --propagation private sh -eu -c '
    mount --bind "$1" "$1"
    cd "$1"
    mkdir -p old proc dev tmp
    mount -t proc proc proc
    mount --rbind /dev dev
    pivot_root . old
    umount -l /old
    exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 TERM=dumb ${http_proxy:+http_proxy=$http_proxy} sh -eu /in_bare_root.sh
' sh "$root"

step "the same class in the checkout"
UMBRAL_CACHE=$work/cache "$build/bin/umbral" grade --handed-in --jobs 2 --secret-file "$root/secret" --out "$work/there" "$source/tests/class" >/dev/null
step "comparing"
# Pretty-printed, one value a line: times are the only lines that may differ.
for file in "$root/reports/class.json" "$work/there/class.json"; do grep -vE '"(reference_)?seconds":' "$file" >"$file.without-times"; done
if ! cmp "$root/reports/class.json.without-times" "$work/there/class.json.without-times"; then
    diff "$root/reports/class.json.without-times" "$work/there/class.json.without-times" | head -n 40
    exit 1
fi
echo "class.json: $(wc -l <"$work/there/class.json.without-times") lines, all equal but for times"
step "done"
