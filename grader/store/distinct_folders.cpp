#include "store/distinct_folders.hpp"

#include <fmt/format.h>

#include "store/refused_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Is `folder` the same as `path`, or above it? Compared by device and number too: a folder may be mounted in two
/// places.
bool holds(const fs::path& folder, const fs::path& path)
{
    for (fs::path one = path;; one = one.parent_path()) {
        std::error_code unknown;
        if (one == folder || fs::equivalent(one, folder, unknown)) return true;
        if (one == one.parent_path()) return false;
    }
}

/// With all links followed, as far as it exists, and without a slash at its end.
fs::path real(const fs::path& path)
{
    fs::path whole = fs::weakly_canonical(fs::absolute(path));
    return whole.has_filename() ? whole : whole.parent_path();
}

}

void expect_outside(std::string_view what, const fs::path& folder, std::string_view option, const fs::path& file)
{
    if (holds(real(folder), real(file)))
        throw RefusedFolder(fmt::format("{} {} lies in the folder of {}, which goes to students: keep it elsewhere",
                                        option, file.string(), what));
}

void expect_distinct(const fs::path& submissions, const fs::path& out)
{
    const fs::path theirs = real(submissions);
    const fs::path ours = real(out);
    const char* const relation = theirs == ours || (holds(theirs, ours) && holds(ours, theirs))
                                     ? "is the folder of the submissions"
                                 : holds(theirs, ours) ? "lies in the folder of the submissions"
                                 : holds(ours, theirs) ? "holds the folder of the submissions"
                                                       : nullptr;
    if (relation == nullptr) return;
    throw RefusedFolder(
        fmt::format("--out {} {} {}; reports must not lie among the work: name a folder beside it, such as --out {}",
                    ours.string(), relation, theirs.string(), (theirs.parent_path() / "reports").string()));
}

}
