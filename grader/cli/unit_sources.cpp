#include "cli/unit_sources.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

bool is_built_from(const fs::path& file)
{
    constexpr std::array<std::string_view, 9> kinds{".cpp",  ".hpp",  ".h",    ".json", ".vert",
                                                    ".frag", ".geom", ".glsl", ".txt"};
    return std::ranges::find(kinds, file.extension().string()) != kinds.end();
}

/// The latest of `latest` and the changes of a folder's files, of those below it too if `deep`.
fs::file_time_type latest_in(const fs::path& folder, bool deep, bool mistakes, fs::file_time_type latest)
{
    std::error_code none;
    for (fs::recursive_directory_iterator entry(folder, none), end; entry != end; entry.increment(none)) {
        const std::string name = entry->path().filename().string();
        if (entry->is_directory(none)) {
            if (!deep || name == "alternatives" || (name == "mistakes" && !mistakes)) entry.disable_recursion_pending();
        } else if (is_built_from(entry->path())) {
            latest = std::max(latest, entry->last_write_time(none));
        }
    }
    return latest;
}

}

fs::file_time_type last_change(const Toolchain& tools, const Exercise& unit, UnitParts parts)
{
    const bool mistakes = parts == UnitParts::all;
    fs::file_time_type latest = fs::file_time_type::min();
    latest = latest_in(unit.folder, true, mistakes, latest);
    latest = latest_in(unit.folder.parent_path(), false, false, latest);
    for (const fs::path& shared : {tools.exercises / "kit", tools.reference, tools.framework / "umbral"})
        latest = latest_in(shared, true, false, latest);
    return latest;
}

}
