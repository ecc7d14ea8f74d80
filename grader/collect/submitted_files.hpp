#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "collect/sources.hpp"
#include "model/caps.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// What opens archives: the confined program umbral-unpack. Without `programs` archives stay shut, and are listed as
/// ignored.
struct ArchiveTools {
    std::filesystem::path programs;             ///< the folder of umbral-confine and umbral-unpack
    std::filesystem::path scratch;              ///< where an archive is copied to while it is opened; made if missing
    double seconds = caps::all_unpack_seconds;  ///< of processor time, for all archives of a submission
};

/// Something in a submission that was not read.
struct Ignored {
    std::string path;    ///< as in SubmittedFiles::files
    std::string reason;  ///< one line, printable

    friend bool operator==(const Ignored&, const Ignored&) = default;
};

/// The source code in a submission, read once for all units. Paths are relative to the submission, their parts joined
/// by '/', with whatever bytes the student's file system allowed (so print them with one_line()); never absolute,
/// without "." and "..". What came out of an archive lies below the archive's own path: "work.zip/sphere.cpp".
struct SubmittedFiles {
    Sources files;  ///< texts by path: UTF-8 without byte order mark where the file was UTF-16 or had such a mark
    std::vector<Ignored>
        ignored;  ///< by path: links, what is too big, what cannot be read; of these at most caps::submission_ignored
    std::vector<std::string>
        notes;  ///< what the student should know of the whole: a limit was reached, an archive is damaged
};

/// Reads a submission: a folder, or a single archive (.zip, .tar, .tar.gz, .tgz and their like). Goes through all
/// folders below, reads regular files with the suffixes of source code through descriptors opened without following
/// links and without blocking, and stops at caps::submission_*. First come the exact places of `units`
/// (topic/unit/file, then file), so that nothing else in the submission can push them out; then what lies in the
/// folders topic/unit; then nearer files before further ones, and among equally near ones those that are first by name.
/// Folders that tools make (.git, __MACOSX, CMakeFiles, node_modules …) are passed over in silence, and so is the
/// framework's copy (include/umbral) that `umbral new` makes. Never throws for what a student did: an unreadable folder
/// is an empty one with an entry in `ignored`. Throws std::system_error or std::runtime_error if this machine is in
/// trouble: no descriptors, umbral-unpack cannot be started, no room for an archive's copy.
[[nodiscard]] SubmittedFiles read_submission(const std::filesystem::path& path, std::span<const Exercise> units,
                                             const ArchiveTools& tools = {});

}
