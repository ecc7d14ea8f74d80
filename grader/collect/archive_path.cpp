#include <algorithm>

#include "collect/archive.hpp"

namespace umbral::grader {

std::string harmless_path(std::string_view path)
{
    std::string result;
    while (!path.empty()) {
        const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
        const std::string_view part = path.substr(0, end);
        path.remove_prefix(std::min(end + 1, path.size()));
        const bool drive = part.size() == 2 && part[1] == ':';
        if (part.empty() || part == "." || part == ".." || drive || part.find('\0') != std::string_view::npos) continue;
        if (!result.empty()) result += '/';
        result += part;
    }
    return result;
}

}
