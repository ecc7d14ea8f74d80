#include "render/scene_files.hpp"

#include <algorithm>
#include <stdexcept>

namespace umbral::render {

std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& place)
{
    if (!std::filesystem::is_directory(place)) return {place};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(place))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty())
        throw std::runtime_error(place.string() + ": expected a scene, or a folder with scenes (*.json), got none");
    std::sort(files.begin(), files.end());
    return files;
}

}
