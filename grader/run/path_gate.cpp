#include "run/path_gate.hpp"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <optional>

#include "run/descriptor.hpp"

// Based on: seccomp_unotify(2), Linux man-pages 6.03.
namespace umbral::grader {
namespace {

/// The compiler asks some thousands of times for the headers of a large file. A file that asks for others without end
/// would make it wait for minutes, and compute for seconds only.
constexpr std::size_t most_answers = 50'000;

/// Which argument of a call is its path, and whether the one before it is a folder's descriptor.
struct PathArgument {
    std::size_t index;
    bool below_descriptor;
};

PathArgument path_argument(int call)
{
#ifdef SYS_open
    if (call == SYS_open || call == SYS_stat || call == SYS_lstat || call == SYS_access || call == SYS_readlink)
        return {0, false};
#endif
    (void)call;
    return {1, true};
}

/// The path at `address` in another process; nothing if it cannot be read to its end.
std::optional<std::string> read_path(pid_t process, std::uint64_t address)
{
    std::string path;
    std::array<char, 256> piece{};
    while (path.size() < PATH_MAX) {
        // Never over the end of a page: the next may not be there.
        const std::size_t page_left = 4096 - (address + path.size()) % 4096;
        iovec ours{piece.data(), std::min(piece.size(), page_left)};
        iovec theirs{reinterpret_cast<void*>(address + path.size()), ours.iov_len};
        const ssize_t got = process_vm_readv(process, &ours, 1, &theirs, 1, 0);
        if (got <= 0) return std::nullopt;
        const std::size_t length = strnlen(piece.data(), static_cast<std::size_t>(got));
        path.append(piece.data(), length);
        if (length < static_cast<std::size_t>(got)) return path;
    }
    return std::nullopt;
}

bool is_admitted(const seccomp_notif& asked, const PathRules& rules)
{
    const PathArgument argument = path_argument(asked.data.nr);
    const std::optional<std::string> path = read_path(static_cast<pid_t>(asked.pid), asked.data.args[argument.index]);
    if (!path) return false;
    // An empty path means the descriptor itself, which was opened through the gate.
    if (path->empty() || path->front() == '/') return path->empty() || rules.admits(*path);
    return (!argument.below_descriptor || static_cast<int>(asked.data.args[0]) == AT_FDCWD) && rules.admits(*path);
}

/// The kernel's structures may be larger than those of the headers at hand.
struct Sizes {
    std::size_t asked = sizeof(seccomp_notif);
    std::size_t answer = sizeof(seccomp_notif_resp);
    Sizes()
    {
        seccomp_notif_sizes sizes{};
        if (syscall(SYS_seccomp, SECCOMP_GET_NOTIF_SIZES, 0, &sizes) != 0) return;
        asked = std::max<std::size_t>(asked, sizes.seccomp_notif);
        answer = std::max<std::size_t>(answer, sizes.seccomp_notif_resp);
    }
};

}

void guard_paths(Descriptor listener, pid_t child, const PathRules& rules)
{
    const Sizes sizes;
    std::vector<std::byte> asked_bytes(sizes.asked);
    std::vector<std::byte> answer_bytes(sizes.answer);
    const Descriptor ended(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
    for (std::size_t answered = 0; answered < most_answers;) {
        std::array<pollfd, 2> watched{pollfd{listener.get(), POLLIN, 0}, pollfd{ended.get(), POLLIN, 0}};
        if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) return;
        if ((watched[0].revents & POLLIN) == 0) {
            if (watched[0].revents != 0 || watched[1].revents != 0) return;
            continue;
        }
        std::ranges::fill(asked_bytes, std::byte{});
        std::ranges::fill(answer_bytes, std::byte{});
        auto& asked = *reinterpret_cast<seccomp_notif*>(asked_bytes.data());
        // Whoever asked may be gone by now.
        if (ioctl(listener.get(), SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) continue;
        ++answered;
        auto& answer = *reinterpret_cast<seccomp_notif_resp*>(answer_bytes.data());
        answer.id = asked.id;
        if (is_admitted(asked, rules))
            answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
        else
            answer.error = -ENOENT;
        (void)ioctl(listener.get(), SECCOMP_IOCTL_NOTIF_SEND, &answer);
    }
}

}
