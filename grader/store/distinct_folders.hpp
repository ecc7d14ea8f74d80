#pragma once

#include <filesystem>

namespace umbral::grader {

/// Makes sure that reports written below `out` (which need not exist) can never meet a submission: throws RefusedFolder
/// if the two are the same folder, or if one lies in the other, through whatever links and mounts they are named.
/// `submissions` must exist.
void expect_distinct(const std::filesystem::path& submissions, const std::filesystem::path& out);

}
