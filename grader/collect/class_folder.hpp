#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "collect/submitted_files.hpp"

namespace umbral::grader {

/// One submission of a class.
struct SubmissionFolder {
    std::string id;                ///< is_submission_id(), no file name of a report's, unique in the class
    std::filesystem::path folder;  ///< the folder, or the archive, to give to read_submission()
    std::string shown;             ///< printable: the roster's name, else the folder's as it was
};

/// What a folder with a class's submissions holds.
struct ClassFolder {
    std::vector<SubmissionFolder> submissions;  ///< sorted by id
    std::vector<Ignored> ignored;  ///< sorted by path: what is no submission, with the reason; paths are printable here
};

/// Finds the submissions of a class: each folder and each archive (ana.zip, ana.tar.gz) directly in `path`; links,
/// files and names with a leading dot are ignored. A plain name is its own id, others get derived_id(), with a short
/// hash where two would be the same. `roster` is empty, or a CSV file (UTF-8; quoted fields as spreadsheets write them)
/// with the columns folder,id or folder,id,name, which decides the ids of the folders that it lists, whatever others
/// are named (a folder that is named like another's id gets its hash); an archive is listed by its whole name or,
/// if no other has the same without its suffix, without it. `known` are the ids that folders and archives have had
/// before, by their names, which they keep in the same way. Throws std::runtime_error, with the line where there is
/// one, if `path` cannot be read or the roster is wrong: an id that is none or that two folders would have, a folder
/// listed twice. A listed folder that is not there, and a name that several archives have without suffix, are reported
/// in `ignored`. No submission at all is no error here.
[[nodiscard]] ClassFolder class_folder(const std::filesystem::path& path, const std::filesystem::path& roster = {},
                                       const std::map<std::string, std::string>& known = {});

}
