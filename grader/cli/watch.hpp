#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "run/descriptor.hpp"

namespace umbral::grader {

/// Says when something was saved in one of some folders. Saving by writing in place and by renaming a new file over the
/// old one are both seen; folders that come later must be added by watch().
class FolderWatch {
public:
    /// Throws std::system_error if the system offers no more watches.
    FolderWatch();

    /// Watches these folders too; folders that do not exist are left out, known ones stay known.
    void watch(const std::vector<std::filesystem::path>& folders);

    /// Waits until something happens, and then until nothing more has happened for `quiet`: editors save in several
    /// steps. Returns the time of the first of these events.
    [[nodiscard]] std::chrono::steady_clock::time_point wait(std::chrono::milliseconds quiet) const;

private:
    Descriptor inotify_;
};

}
