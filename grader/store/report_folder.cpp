#include "store/report_folder.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <span>
#include <system_error>
#include <umbral/core/png.hpp>

#include "store/refused_folder.hpp"
#include "store/temporaries.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* units_name = "units";
constexpr const char* pictures_name = "pictures";
constexpr const char* unit_suffix = ".unit";
constexpr const char* fault_suffix = ".fault";

// Units' ids hold no underscore, so that no two give the same name.
fs::path file_of(const fs::path& folder, const std::string& unit_id, const char* suffix)
{
    std::string name = unit_id;
    std::ranges::replace(name, '/', '_');
    return folder / units_name / (name + suffix);
}

/// Is this a folder, and no link to one? What lies in that is not Umbral's.
bool is_own_folder(const fs::path& folder) noexcept
{
    std::error_code none;
    return fs::is_directory(fs::symlink_status(folder, none));
}

std::vector<fs::path> files_of_units(const fs::path& folder)
{
    std::vector<fs::path> files;
    if (!is_own_folder(folder / units_name)) return files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder / units_name, none))
        if (const fs::path suffix = entry.path().extension(); suffix == unit_suffix || suffix == fault_suffix)
            files.push_back(entry.path());
    return files;
}

void make_folder(const fs::path& folder)
{
    if (mkdir(folder.c_str(), S_IRWXU) == 0 || errno == EEXIST) return;
    throw fs::filesystem_error("cannot make the folder", folder, std::error_code(errno, std::generic_category()));
}

}

Mark open_report_folder(const fs::path& folder, const std::string& id)
{
    make_folder(folder);
    if (!fs::is_directory(fs::symlink_status(folder)))
        throw RefusedFolder(
            fmt::format("{}: the reports of {} belong here, but something else is in the way", folder.string(), id));
    std::optional<Mark> mark = read_mark(folder);
    if (!mark && !is_untouched(folder))
        throw RefusedFolder(
            fmt::format("{}: the reports of {} belong here, but Umbral did not make this folder", folder.string(), id));
    if (mark && mark->submission != id)
        throw RefusedFolder(fmt::format("{}: the reports of {} belong here, but the folder holds those of {}",
                                        folder.string(), id, mark->submission));
    for (const char* const below : {units_name, pictures_name})
        if (std::error_code none;
            fs::exists(fs::symlink_status(folder / below, none)) && !is_own_folder(folder / below))
            throw RefusedFolder(fmt::format(
                "{}: a folder with parts of the reports of {} belongs here, but it is a link or a file; remove it",
                (folder / below).string(), id));
    if (!mark) mark.emplace().submission = id;
    return *std::move(mark);
}

void set_mark(const fs::path& folder, const Mark& mark)
{
    const std::string text = to_text(mark);
    write_file_atomically(folder / mark_name, std::as_bytes(std::span(text)));
    // Behind the mark: a folder that holds anything is known by it, whenever the process is killed.
    make_folder(folder / units_name);
}

fs::path unit_file(const fs::path& folder, const std::string& unit_id) { return file_of(folder, unit_id, unit_suffix); }

fs::path fault_file(const fs::path& folder, const std::string& unit_id)
{
    return file_of(folder, unit_id, fault_suffix);
}

std::vector<std::string> kept_units(const fs::path& folder)
{
    std::set<std::string> units;
    for (const fs::path& file : files_of_units(folder)) {
        std::string name = file.stem().string();
        std::ranges::replace(name, '_', '/');
        units.insert(std::move(name));
    }
    return {units.begin(), units.end()};
}

void forget_units(const fs::path& folder)
{
    for (const fs::path& file : files_of_units(folder)) fs::remove(file);
}

void tidy_temporaries(const fs::path& folder) noexcept
{
    for (const char* const below : {"", units_name, pictures_name})
        if (is_own_folder(folder / below)) remove_temporaries(folder / below);
}

void remove_pictures(const fs::path& folder, const std::set<std::string>& pictures) noexcept
{
    try {
        const fs::path all = folder / pictures_name;
        if (!is_own_folder(all)) return;
        for (const fs::path picture : pictures) {
            // Whoever had the folder may have changed the results that name them.
            const fs::path file = all / picture.filename();
            if (picture.parent_path() == pictures_name && fs::is_regular_file(fs::symlink_status(file)))
                fs::remove(file);
        }
        if (fs::is_empty(all)) fs::remove(all);
    } catch (const std::exception&) {  // a picture too many disturbs nobody
    }
}

}
