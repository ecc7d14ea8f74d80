#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "complaint.hpp"
#include "support/temporary_folder.hpp"

/// While it lives, no file of this process may grow beyond `bytes`: writing fails with EFBIG, as on a full disk.
class SmallFiles {
public:
    explicit SmallFiles(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;
    ~SmallFiles()
    {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit old_{};
    void (*handler_)(int) = SIG_DFL;
};

enum class FullDisk { held, failed, cannot_mount };

/// Runs `action(folder)` in a child whose `folder` is a disk of 64 KiB, in a mount namespace of its own (root only).
/// `held`: the action failed naming ENOSPC and left nothing in the folder.
template <class Action>
FullDisk on_full_disk(const umbral::test::TemporaryFolder& folder, Action action)
{
    const pid_t child = ::fork();
    if (child == 0) {
        if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
            ::_exit(2);
        const std::string said = complaint([&] { action(folder); });
        ::_exit(said.find("No space left on device") != std::string::npos && folder.count() == 0 ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!WIFEXITED(status)) return FullDisk::failed;
    return WEXITSTATUS(status) == 0   ? FullDisk::held
           : WEXITSTATUS(status) == 2 ? FullDisk::cannot_mount
                                      : FullDisk::failed;
}
