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

/// Of a folder's files, and of those below it in folders that `enters` names.
template <class Enters>
fs::file_time_type latest_in(const fs::path& folder, const Enters& enters)
{
    fs::file_time_type latest = fs::file_time_type::min();
    std::error_code none;
    for (fs::recursive_directory_iterator entry(folder, none), end; entry != end; entry.increment(none)) {
        if (entry->is_directory(none)) {
            if (!enters(entry->path().filename())) entry.disable_recursion_pending();
        } else if (is_built_from(entry->path())) {
            latest = std::max(latest, entry->last_write_time(none));
        }
    }
    return latest;
}

}

fs::file_time_type last_shared_change(const Toolchain& tools)
{
    const auto all = [](const fs::path&) { return true; };
    return std::max({latest_in(tools.exercises / "kit", all), latest_in(tools.reference, all),
                     latest_in(tools.framework / "umbral", all)});
}

fs::file_time_type last_own_change(const Exercise& unit, UnitParts parts)
{
    const auto built = [&](const fs::path& name) {
        return name != "alternatives" && (name != "mistakes" || parts == UnitParts::all);
    };
    const auto none = [](const fs::path&) { return false; };
    return std::max(latest_in(unit.folder, built), latest_in(unit.folder.parent_path(), none));
}

}
