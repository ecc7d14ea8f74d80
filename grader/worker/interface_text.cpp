#include "worker/interface_text.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

namespace umbral::grader {

std::string interface_text(const Worker& worker, const Exercise& exercise)
{
    const std::filesystem::path& framework = worker.tools().framework;
    std::vector<std::filesystem::path> files;
    for (const auto* headers : {&exercise.interfaces, &exercise.used_interfaces})
        for (const std::string& header : *headers) files.push_back(framework / header);
    std::error_code none;
    std::set<std::filesystem::path> others;
    for (const auto& entry : std::filesystem::directory_iterator(framework / "umbral" / exercise.topic, none))
        if (entry.path().extension() == ".hpp" && std::ranges::find(files, entry.path()) == files.end())
            others.insert(entry.path());
    files.insert(files.end(), others.begin(), others.end());
    std::ostringstream text;
    for (const std::filesystem::path& file : files) text << std::ifstream(file).rdbuf() << '\n';
    return text.str();
}

}
