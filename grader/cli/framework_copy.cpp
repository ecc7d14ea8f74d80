#include "cli/framework_copy.hpp"

#include <string>
#include <utility>
#include <vector>

#include "build/framework_headers.hpp"
#include "cli/paths.hpp"
#include "store/sent_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// What every student's file sees before its first line.
constexpr const char* first_header = "umbral/student.hpp";

}

void copy_framework(const Toolchain& tools, std::span<const Exercise> exercises, const fs::path& workspace)
{
    std::vector<std::string> headers{first_header};
    for (const Exercise& exercise : exercises)
        for (const auto* interfaces : {&exercise.interfaces, &exercise.used_interfaces})
            headers.insert(headers.end(), interfaces->begin(), interfaces->end());
    for (const std::string& header : with_included(tools.framework, std::move(headers)))
        copy_file_below(tools.framework / header, workspace, fs::path("include") / header);
    const fs::path flags = workspace / "compile_flags.txt";
    if (!is_taken(flags)) write_output(flags, std::string("-std=c++20\n-Iinclude\n-include\n") + first_header + "\n");
}

}
