#include "worker/run_roots.hpp"

#include <cstdlib>

namespace umbral::grader {

std::vector<std::string> run_roots(const Toolchain& tools)
{
    std::vector<std::string> roots;
    const auto add = [&](const std::filesystem::path& folder) {
        if (folder.is_absolute()) roots.push_back(folder.lexically_normal().string());
    };
    for (const auto& folder :
         {tools.exercises, tools.reference, tools.units, tools.programs, tools.framework, tools.cache}) {
        add(folder);
        // The project's sources, its build, the user's cache.
        add(folder.parent_path());
    }
    add(tools.student_header.parent_path());
    if (const char* const home = std::getenv("HOME")) add(home);
    return roots;
}

}
