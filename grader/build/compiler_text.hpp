#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "build/submission.hpp"

namespace umbral::grader {

/// The first errors of g++ output, with their notes and source lines, at most `lines` lines.
[[nodiscard]] std::string first_errors(std::string_view output, std::size_t lines);

/// The lines "sphere.cpp:3:5: warning: …".
[[nodiscard]] std::string warnings_of(const std::string& output);

/// Does the compiler of this name say that a process of its own was stopped by the limit of processor time? Its
/// versions call that a fatal error, or one of the compiler's.
[[nodiscard]] bool tells_of_processor_time(std::string_view output, std::string_view compiler);

/// Does g++ output, as `without_folders` gives it, hold an error whose place is one of these files: "sphere.cpp:3:5:
/// error: …"?
[[nodiscard]] bool blames_own_file(std::string_view output, const Sources& files);

/// g++ output in which a student's files are named as they were written and headers as they are included, not by where
/// they lie on this machine, in one of `folders`. Equal work gets equal output: the compiler's own files, whose names
/// are new each time, are "object file".
[[nodiscard]] std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders);

}
