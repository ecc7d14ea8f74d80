#include "model/exercise.hpp"

#include <algorithm>

namespace umbral::grader {

Limits limits_for(Limits limits, double seconds)
{
    limits.wall_seconds = std::min(limits.wall_seconds, 1 + 8 * seconds);
    return limits;
}

bool Exercise::is_cpp() const
{
    return std::any_of(files.begin(), files.end(),
                       [](const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".hpp"); });
}

bool Exercise::has_oracle() const
{
    return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return check.hard; });
}

std::vector<std::string> Exercise::cases() const
{
    std::vector<std::string> names;
    for (const Check& check : checks)
        if (std::find(names.begin(), names.end(), check.case_name) == names.end()) names.push_back(check.case_name);
    return names;
}

std::map<std::string, std::string> english_titles(std::span<const Exercise> exercises)
{
    std::map<std::string, std::string> titles;
    for (const Exercise& exercise : exercises)
        if (const auto english = exercise.title.find("en"); english != exercise.title.end())
            titles[exercise.id] = english->second;
    return titles;
}

}
