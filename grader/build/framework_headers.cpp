#include "build/framework_headers.hpp"

#include <utility>

#include "collect/sources.hpp"
#include "model/include_lines.hpp"

namespace umbral::grader {

std::set<std::string> with_included(const std::filesystem::path& framework, std::vector<std::string> headers)
{
    std::set<std::string> all;
    while (!headers.empty()) {
        const std::string header = std::move(headers.back());
        headers.pop_back();
        if (!std::filesystem::exists(framework / header) || !all.insert(header).second) continue;
        for (std::string& included : framework_includes(read_text(framework / header)))
            headers.push_back(std::move(included));
    }
    return all;
}

}
