#include "cli/watch.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace umbral::grader {
namespace {

constexpr int for_ever = -1;

/// Is something to be read within this time?
bool ready(int descriptor, int milliseconds)
{
    pollfd waiting{descriptor, POLLIN, 0};
    int found = 0;
    while ((found = poll(&waiting, 1, milliseconds)) < 0 && errno == EINTR) continue;
    if (found < 0) throw std::system_error(errno, std::generic_category(), "waiting for a save");
    return found > 0;
}

/// What happened does not matter, only that it did: the files are compared anyway.
void discard_events(int descriptor)
{
    alignas(inotify_event) std::array<char, 16384> events{};
    while (read(descriptor, events.data(), events.size()) > 0) continue;
}

}

FolderWatch::FolderWatch() : inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
{
    if (!inotify_)
        throw std::system_error(errno, std::generic_category(), "--watch: the system gives no inotify instance");
}

void FolderWatch::watch(const std::vector<std::filesystem::path>& folders)
{
    constexpr std::uint32_t saves = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE | IN_ONLYDIR;
    for (const std::filesystem::path& folder : folders)
        if (inotify_add_watch(inotify_.get(), folder.c_str(), saves) < 0 && errno != ENOENT && errno != ENOTDIR)
            throw std::system_error(errno, std::generic_category(), "--watch: cannot watch " + folder.string());
}

std::chrono::steady_clock::time_point FolderWatch::wait(std::chrono::milliseconds quiet) const
{
    (void)ready(inotify_.get(), for_ever);
    const auto first = std::chrono::steady_clock::now();
    do discard_events(inotify_.get());
    while (ready(inotify_.get(), static_cast<int>(quiet.count())));
    return first;
}

}
