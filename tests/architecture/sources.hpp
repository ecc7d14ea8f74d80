#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// The project's own files, as the tests of its order see them.
namespace umbral::test {

struct Line {
    std::string file;  ///< relative to the root
    std::size_t number;
    std::string text;
    [[nodiscard]] std::string where() const { return file + ":" + std::to_string(number) + ": " + text; }
};

/// Regular files below `folder` (relative to the root), sorted.
inline std::vector<std::filesystem::path> files_below(const std::string& folder)
{
    const std::filesystem::path root = UMBRAL_SOURCE_DIR;
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(root / folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
        if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(root));
    std::sort(files.begin(), files.end());
    return files;
}

inline bool is_cpp(const std::filesystem::path& file)
{
    return file.extension() == ".cpp" || file.extension() == ".hpp";
}

inline std::vector<Line> lines_of(const std::filesystem::path& file)
{
    std::vector<Line> lines;
    std::ifstream stream(std::filesystem::path(UMBRAL_SOURCE_DIR) / file);
    for (std::string text; std::getline(stream, text);) lines.push_back({file.string(), lines.size() + 1, text});
    return lines;
}

}
