#include "batch/artefacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <umbral/core/png.hpp>

namespace umbral::grader {

std::string artefact_name(const Exercise& exercise, const Check& check, const char* extension)
{
    std::string name = exercise.id + "-" + check.name + extension;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '-');
    return name;
}

void make_artefact_folder(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    if (!std::filesystem::is_directory(std::filesystem::symlink_status(folder)))
        throw std::runtime_error(
            fmt::format("{} is a link: nothing is written where it leads; remove it", folder.string()));
}

void write_artefact(const std::filesystem::path& file, std::span<const std::byte> bytes)
{
    make_artefact_folder(file.parent_path());
    write_file_atomically(file, bytes);
}

}
