# Run by bare_root_test.sh in a system of its own, as root: installs the packages and uses them as their users would.
step() { echo "$(date +%T)   $*"; }
expect() { # expect STATUS TEXT COMMAND…: how a command must end, and what it must print
    status=$1
    text=$2
    shift 2
    came=0
    "$@" >/tmp/printed 2>&1 || came=$?
    if [ "$came" -ne "$status" ] || ! grep -qF -- "$text" /tmp/printed; then
        echo "FAILED: $*: expected status $status and '$text', got status $came and:"
        cat /tmp/printed
        exit 1
    fi
    step "ok: $*"
}
chmod 1777 /tmp
export DEBIAN_FRONTEND=noninteractive
before=$(du -smx / | cut -f1)
apt-get update -qq
step "installing the students' package"
apt-get install -y -qq --no-install-recommends /packages/umbral_*.deb >/tmp/apt.log 2>&1 || { tail -n 20 /tmp/apt.log; exit 1; }
apt-get clean
step "the students' package and what it needs take $(($(du -smx / | cut -f1) - before)) MiB; itself $(du -smx /usr/lib/umbral /usr/share/umbral | awk '{ sum += $1 } END { print sum }')"

# Used by somebody who is not root.
useradd -m student
as_student() { (cd /home/student && setpriv --reuid student --regid student --clear-groups env HOME=/home/student "$@"); }
expect 0 'sphere' as_student umbral list
expect 0 'Made work' as_student umbral new work
expect 1 '' as_student umbral check --dir work sphere
cp /submissions/ana-all-right/sphere.cpp /home/student/work/raytracing/sphere/
cp /submissions/ana-all-right/phong.* /home/student/work/lighting/shaders/
expect 0 'Everything is right' as_student umbral check --dir work sphere shaders
cp /submissions/carla-typical-mistakes/projections/view-matrix/view_matrix.cpp /home/student/work/projections/view-matrix/
cp /submissions/carla-typical-mistakes/lighting/shaders/phong.* /home/student/work/lighting/shaders/
expect 1 'why' as_student umbral check --dir work view-matrix
expect 1 'why' as_student umbral check --dir work shaders
expect 2 'umbral-instructor' as_student umbral validate sphere
[ ! -e /usr/share/umbral/reference ]

step "installing the instructors' package"
apt-get install -y -qq --no-install-recommends /packages/umbral-instructor_*.deb >/tmp/apt.log 2>&1 || { tail -n 20 /tmp/apt.log; exit 1; }
# The answers lie below /usr now. Asked for in parts: a student's file may not be of any size. Two files are found that
# compiling needs, and that tell nothing: what the unit may export, and the assembler that the compiler is handed.
find /usr/share/umbral/reference /usr/share/umbral/exercises /usr/share/umbral/class /usr/lib/umbral -type f \
    ! -path '*/sphere/exports.map' ! -path '*/bin/assembler/as' >/tmp/answers
split -l 2000 /tmp/answers /tmp/answers.
for part in /tmp/answers.*; do
    {
        while read -r file; do printf '#if __has_include("%s")\n#error found\n#endif\n' "$file"; done <"$part"
        cat /submissions/ana-all-right/sphere.cpp
    } >/home/student/work/raytracing/sphere/sphere.cpp
    expect 0 'Everything is right' as_student umbral check --dir work sphere
done
echo '#include "/usr/share/umbral/reference/raytracing/sphere.cpp"' >/home/student/work/raytracing/sphere/sphere.cpp
expect 1 'No such file' as_student umbral check --json --dir work sphere
printf 'asm(".incbin \\"/usr/share/umbral/reference/raytracing/sphere.cpp\\"");\n' >/tmp/probe.cpp
mkdir /tmp/probe && cp /tmp/probe.cpp /tmp/probe/
expect 1 'file not found' env TMPDIR=/tmp/probe /usr/lib/umbral/bin/umbral-confine 2048 30 /tmp/probe "$(dirname "$(g++ -print-file-name=include)")" \
    "/usr/lib/$(g++ -print-multiarch)/*" /usr/include '/usr/bin/*' /usr/share/umbral/framework -- /usr/bin/g++ -c probe.cpp
expect 0 'not as they should be' umbral validate --quiet --seeds 1 sphere shaders
expect 0 'mean' umbral grade --handed-in --jobs 2 --secret-file /secret --out /reports /submissions
step "removing both"
apt-get purge -y -qq umbral umbral-instructor >/dev/null 2>&1
[ ! -e /usr/lib/umbral ] && [ ! -e /usr/share/umbral ] && [ ! -e /usr/bin/umbral ]
