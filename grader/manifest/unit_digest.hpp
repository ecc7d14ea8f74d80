#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/exercise.hpp"

namespace umbral::grader {

/// The sources of a project, each read once however many units include it: a command that loads a hundred units would
/// read every header of the framework a hundred times.
class ProjectSources {
public:
    struct Source {
        std::string digest;  ///< SHA-256 of its bytes
        std::vector<std::filesystem::path>
            including;  ///< the project's files that its include lines name, normal paths
    };

    /// `project` holds the folders exercises, framework and reference, where includes are looked for after the folder
    /// of the file itself. What was read is remembered, also if the file changes afterwards. Throws std::runtime_error
    /// that names a file which cannot be read.
    [[nodiscard]] const Source& read(const std::filesystem::path& project, const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, Source> read_;
};

/// SHA-256 over the names and bytes of all that decides a unit's score: manifest, stubs, driver, reference and oracle,
/// and every header of this project that these include, directly or not, wherever it lies (the unit's own, other
/// topics', interfaces). Names are relative to the project, so that it is the same on all machines. `exercise.folder`
/// must lie in `exercises/topic/unit`; `framework` and `reference` are looked for beside `exercises`. A unit of
/// students' packages has no sources: there `packaged_file` holds the digest. Throws std::runtime_error if manifest,
/// driver or a stub cannot be read.
[[nodiscard]] std::string unit_digest(const Exercise& exercise, ProjectSources& sources);

}
