// A hostile submission: before its first answer it tries everything that would help it cheat, and prints what each attempt got.
#include <fcntl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <umbral/raytracing/intersect.hpp>
#include <umbral/record/driver.hpp>

namespace {

using SystemCall = long (*)(long, ...);

// No unit may call syscall(), nor hold assembler. But the C library lies in this process, and a function of it that may be called shows where:
// from there on the first bytes of syscall() are looked for.
SystemCall find_system_call()
{
#if defined(__x86_64__)
    static const unsigned char begin[] = {0x48, 0x89, 0xf8, 0x48, 0x89, 0xf7, 0x48, 0x89, 0xd6, 0x48, 0x89, 0xca, 0x4d,
                                          0x89, 0xc2, 0x4d, 0x89, 0xc8, 0x4c, 0x8b, 0x4c, 0x24, 0x08, 0x0f, 0x05};
    const auto* from = reinterpret_cast<const unsigned char*>(&std::malloc);
    for (long offset = 0; offset < 0xc0000; ++offset)
        if (std::memcmp(from + offset, begin, sizeof begin) == 0) return reinterpret_cast<SystemCall>(const_cast<unsigned char*>(from) + offset);
#endif
    return nullptr;
}

long raw(long number, long a = 0, long b = 0, long c = 0, long d = 0)
{
    static const SystemCall call = find_system_call();
    if (call == nullptr) return -ENOSYS;
    const long result = call(number, a, b, c, d);
    return result == -1 ? -errno : result;
}

long address(const void* pointer) { return reinterpret_cast<long>(pointer); }

void tell(const char* attempt, long got)
{
    const char* reason = got == -EPERM ? "operation not permitted" : got == -EACCES ? "permission denied" : got == -ESRCH ? "no such process" : "error";
    if (got < 0) std::printf("%-34s refused: %s (%ld)\n", attempt, reason, -got);
    else std::printf("%-34s WORKED (%ld)\n", attempt, got);
}

void open_for(const char* attempt, const char* path, int flags) { tell(attempt, raw(SYS_openat, AT_FDCWD, address(path), flags, 0600)); }

// Is this page readable? The kernel says so without a fault: it is asked to read a signal mask from there.
bool readable(const char* page) { return raw(SYS_rt_sigprocmask, 3 /* no such operation */, address(page), 0, 8) != -EFAULT; }

constexpr long page_size = 4096;

int occurrences(const char* from, long pages, const char* word)
{
    int found = 0;
    const auto size = static_cast<long>(std::strlen(word));
    for (long page = 0; page < pages; ++page) {
        const char* at = from + page * page_size;
        if (!readable(at)) continue;
        for (const char* p = at; p < at + page_size - size; ++p)
            if (p[0] == word[0] && std::memcmp(p, word, static_cast<std::size_t>(size)) == 0) ++found;
    }
    return found;
}

void walk_the_heap()
{
    const auto end = static_cast<unsigned long>(raw(SYS_brk, 0));
    const long pages = 2048;
    const char* begin = reinterpret_cast<const char*>(end) - pages * page_size;
    // Spelt in pieces, so that the words are not found in this very program.
    const char words[5][16] = {{'a', 'n', 'a', '-'}, {'s', 'e', 'c', 'r', 'e', 't'}, {'m', 'i', 'l', 'l', 'i', 'p', 'o', 'i', 'n', 't', 's'}, {'o', 'r', 'a', 'c', 'l', 'e'}, {'c', 'a', 'r', 'l', 'a', '-'}};
    for (const auto& word : words) std::printf("heap: the word '%s' occurs %d times\n", word, occurrences(begin, pages, word));
}

// Finds the shared recording by its first eight bytes and overwrites what a careless reader would believe.
void damage_the_recording()
{
    const long own = raw(SYS_mmap, 0, page_size, 3, 0x22);
    char* around = reinterpret_cast<char*>(own) - page_size * 65536L;
    for (long page = 0; page < 131072; ++page, around += page_size) {
        if (!readable(around) || std::memcmp(around, "UMBRAL0", 7) != 0) continue;
        std::printf("recording: found and overwritten\n");
        (void)std::fflush(stdout);
        // stage finished, lengths beyond everything, then leave before the truth is written
        for (long offset = 8; offset < 64; offset += 8) std::memset(around + offset, 0x7f, 8);
        const unsigned finished = 4;
        std::memcpy(around + 8, &finished, sizeof finished);
        raw(SYS_exit_group, 0);
    }
    std::printf("recording: not found\n");
}

struct Attack {
    Attack()
    {
        open_for("read /etc/passwd", "/etc/passwd", O_RDONLY);
        open_for("read the reference", "../../reference/raytracing/sphere.cpp", O_RDONLY);
        open_for("read /proc/self/maps", "/proc/self/maps", O_RDONLY);
        open_for("read /proc/1/environ", "/proc/1/environ", O_RDONLY);
        open_for("write through /proc/self/mem", "/proc/self/mem", O_RDWR);
        open_for("list the folder", ".", O_RDONLY | O_DIRECTORY);
        open_for("write a report of its own", "report.json", O_WRONLY | O_CREAT);
        tell("open a socket", raw(SYS_socket, 2, 1, 0));
        tell("fork", raw(SYS_clone, 17, 0, 0, 0));
        tell("run a shell", raw(SYS_execve, address("/bin/sh"), 0, 0));
        tell("kill its parent", raw(SYS_kill, raw(SYS_getppid), 9));
        tell("kill every process", raw(SYS_kill, -1, 9));
        tell("trace its parent", raw(SYS_ptrace, 16, 1, 0, 0));
        tell("read its parent's memory", raw(SYS_process_vm_readv, 1, 0, 0, 0));
        tell("make an anonymous file", raw(SYS_memfd_create, address("x"), 0));
        tell("raise a limit", raw(SYS_prlimit64, 0, 9, address("\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff"), 0));
        walk_the_heap();
        (void)std::fflush(stdout);
    }
};
const Attack attack;

}

// Names of the framework, the driver and libc: if these replaced the real ones, every answer would be "right".
namespace umbral {
const Driver driver = {{"head-on", [](Case&, Recorder& out) { out.append("t", 4.0F); }}};
void Recorder::append(std::string_view, std::optional<float>) { std::puts("RECORDER REPLACED"); }
void mark_not_implemented() noexcept {}
}
extern "C" float sqrtf(float) noexcept { return 1; }

namespace umbral::raytracing {

std::optional<float> intersect(const Ray&, const Sphere&)
{
    static int calls = 0;
    if (++calls == 3) damage_the_recording();
    return 4.0F;
}

}
