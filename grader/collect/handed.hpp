#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collect/sources.hpp"
#include "collect/submitted_files.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// What was handed in for one unit.
struct Handed {
    Sources files;
    std::vector<std::string> missing;  ///< files that the unit asks for and that are not there
    std::string refused;  ///< why a file was not taken: too big, a link, several that differ; empty if none was
    std::vector<std::string>
        notes{};  ///< what the student should know: "sphere.cpp: taken from work/Sphere.cpp"; printable, one line each

    /// Is there nothing that could have been meant for this unit?
    [[nodiscard]] bool nothing() const { return files.empty() && refused.empty(); }
};

/// Chooses a unit's files. For each file that the unit asks for:
/// 1. `topic/unit/file`, else `file` flat in the submission, if it is more than the stub;
/// 2. else the one file below a folder `topic/unit`, else the one file anywhere, whose name is the same but for case,
/// separators, C++'s
///    other suffixes and what downloads append ("Sphere.cpp", "sphere (1).cc"). Several with the same text count as
///    one; of several that differ none is taken, and `refused` names them. A note says where the file was taken from;
/// 3. else the untouched stub.
/// Further C++ files beside it come along if the folder is the unit's own (named like it), as many as caps::unit_files
/// and caps::unit_sources allow, with plain names that no compiler takes for an option.
[[nodiscard]] Handed collect(const SubmittedFiles& submitted, const Exercise& exercise);

/// The same from a folder in which archives stay shut: read_submission(), then collect().
[[nodiscard]] Handed collect(const std::filesystem::path& folder, const Exercise& exercise);

}
