#include "store/sent_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <umbral/core/png.hpp>

#include "store/refused_folder.hpp"

namespace umbral::grader {

namespace fs = std::filesystem;

namespace {

/// Removes a link, pipe, socket or device of this name. Files and folders stay.
void remove_what_was_planted(const fs::path& name)
{
    std::error_code unknown;
    const fs::file_status status = fs::symlink_status(name, unknown);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) fs::remove(name, unknown);
}

}

void make_folder_below(const fs::path& root, const fs::path& below)
{
    fs::path folder = root;
    for (const fs::path& part : below) {
        if (part.empty()) continue;
        if (part == ".." || part.is_absolute()) throw std::logic_error("not below a folder: " + below.string());
        folder /= part;
        std::error_code error;
        fs::create_directory(folder, error);
        const fs::file_status status = fs::symlink_status(folder);
        if (fs::is_symlink(status))
            throw RefusedFolder(
                fmt::format("{} is a link: nothing is written where it leads; remove it", folder.string()));
        if (fs::exists(status) && !fs::is_directory(status))
            throw RefusedFolder(fmt::format("{}: expected a folder; this is not a folder", folder.string()));
        if (error)
            throw RefusedFolder(fmt::format("{}: cannot make this folder: {}", folder.string(), error.message()));
    }
}

void write_file_below(const fs::path& root, const fs::path& below, std::span<const std::byte> bytes)
{
    make_folder_below(root, below.parent_path());
    remove_what_was_planted(root / below);
    write_file_atomically(root / below, bytes);
}

void copy_file_below(const fs::path& from, const fs::path& root, const fs::path& below)
{
    std::ifstream stream(from, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad()) throw std::runtime_error(from.string() + ": cannot be read");
    write_file_below(root, below, std::as_bytes(std::span(text)));
}

}
