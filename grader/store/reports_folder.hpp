#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "run/descriptor.hpp"
#include "store/mark.hpp"

namespace umbral::grader {

/// The folder of a class's reports, `--out`: marked as Umbral's, and locked while this object lives, so that no two
/// gradings write there.
class ReportsFolder {
public:
    /// Opens `out`, or makes it with the folders above it; a folder that is new or empty gets the mark of `grading`.
    /// Removes the temporary mark of a killed run. Throws RefusedFolder if `out` holds things and Umbral did not make
    /// it, is no folder, or is in use; std::system_error or std::runtime_error if it cannot be written.
    ReportsFolder(const std::filesystem::path& out, const Grading& grading);

    /// Absolute, with links followed.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// Where the reports of a submission lie.
    [[nodiscard]] std::filesystem::path folder_of(const std::string& id) const { return path_ / id; }
    /// Which grading's results it holds.
    [[nodiscard]] const Grading& grading() const noexcept { return grading_; }
    /// Removes what a killed run left of its temporary files for `file`, which lies directly in it. Never throws.
    void tidy(std::string_view file) const noexcept;
    /// Turns it into the folder of another grading. The marks of submissions stay as they are. Throws as the
    /// constructor does.
    void set_grading(const Grading& grading);

    /// Ids of the submissions that have reports here, sorted: folders with the mark of their own name.
    [[nodiscard]] std::vector<std::string> submissions() const;

private:
    [[nodiscard]] Descriptor locked_mark(const Grading& grading, bool replace) const;

    std::filesystem::path path_;
    Grading grading_;
    Descriptor lock_;
};

/// Of the submissions whose reports lie in `out`: the folder or archive that was graded (Mark::source), and the id that
/// it had. Empty if nothing can be read there.
[[nodiscard]] std::map<std::string, std::string> ids_by_source(const std::filesystem::path& out);

}
