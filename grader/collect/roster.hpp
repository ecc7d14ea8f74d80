#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// One line of a roster.
struct RosterEntry {
    std::string folder;  ///< of the submission, as the file system spells it
    std::string id;
    std::string name;      ///< of the student; may be empty
    std::size_t line = 0;  ///< where it begins in the file, from 1
};

/// Reads CSV with the columns folder,id or folder,id,name, which its first line names: UTF-8, with or without byte
/// order mark; fields may be quoted, and then hold commas, line feeds and doubled quotes. Between fields there may be
/// semicolons instead, if the first line has them. Throws std::runtime_error with `where` and the line: a wrong number
/// of fields, an id that is none, a folder or an id listed twice.
[[nodiscard]] std::vector<RosterEntry> parse_roster(std::string_view text, const std::string& where);

}
