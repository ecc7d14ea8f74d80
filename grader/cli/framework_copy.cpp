#include "cli/framework_copy.hpp"

#include <deque>
#include <set>
#include <string>

#include "cli/paths.hpp"
#include "collect/sources.hpp"
#include "manifest/include_lines.hpp"
#include "store/sent_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// What every student's file sees before its first line.
constexpr const char* first_header = "umbral/student.hpp";

/// The headers that the stubs see, and all that those include.
std::set<std::string> headers_for(const Toolchain& tools, std::span<const Exercise> exercises)
{
    std::deque<std::string> waiting{first_header};
    for (const Exercise& exercise : exercises)
        for (const auto* headers : {&exercise.interfaces, &exercise.used_interfaces})
            waiting.insert(waiting.end(), headers->begin(), headers->end());
    std::set<std::string> all;
    for (; !waiting.empty(); waiting.pop_front()) {
        if (!fs::exists(tools.framework / waiting.front()) || !all.insert(waiting.front()).second) continue;
        for (const std::string& header : framework_includes(read_text(tools.framework / waiting.front())))
            waiting.push_back(header);
    }
    return all;
}

}

void copy_framework(const Toolchain& tools, std::span<const Exercise> exercises, const fs::path& workspace)
{
    for (const std::string& header : headers_for(tools, exercises)) {
        copy_file_below(tools.framework / header, workspace, fs::path("include") / header);
    }
    const fs::path flags = workspace / "compile_flags.txt";
    if (!is_taken(flags)) write_output(flags, std::string("-std=c++20\n-Iinclude\n-include\n") + first_header + "\n");
}

}
