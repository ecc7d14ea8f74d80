#pragma once

#include <filesystem>
#include <string_view>

namespace umbral::grader {

/// Makes sure that reports written below `out` (which need not exist) can never meet a submission: throws RefusedFolder
/// if the two are the same folder, or if one lies in the other, through whatever links and mounts they are named.
/// `submissions` must exist.
void expect_distinct(const std::filesystem::path& submissions, const std::filesystem::path& out);

/// Makes sure that a file which an option names lies nowhere below `folder`, where `what` lie: throws RefusedFolder if
/// it does.
void expect_outside(std::string_view what, const std::filesystem::path& folder, std::string_view option,
                    const std::filesystem::path& file);

}
