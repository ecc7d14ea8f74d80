#include "unit/artefacts.hpp"

#include <algorithm>

#include "store/sent_folder.hpp"

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
    make_folder_below(folder.parent_path(), folder.filename());
}

void write_artefact(const std::filesystem::path& file, std::span<const std::byte> bytes)
{
    const std::filesystem::path folder = file.parent_path();
    write_file_below(folder.parent_path(), folder.filename() / file.filename(), bytes);
}

}
