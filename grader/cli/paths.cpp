#include "cli/paths.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <span>
#include <system_error>
#include <umbral/core/png.hpp>

#include "run/descriptor.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw UsageError(fmt::format("{}: {}", path.string(), reason));
}

/// Refuses a path that the system cannot even look up: a loop of links, a name too long, a folder on the way that is
/// closed.
void expect_known(const fs::path& path, const fs::file_status& status, const std::error_code& error)
{
    if (status.type() == fs::file_type::none) refuse(path, error.message());
}

void expect_access(const fs::path& path, int mode)
{
    if (access(path.c_str(), mode) != 0) refuse(path, std::generic_category().message(errno));
}

}

std::string workspace_of(std::span<const std::string> units, const std::string& folder)
{
    if (folder != ".") return folder;
    std::string found;
    for (const std::string& unit : units) {
        fs::path path(unit);
        if (!path.has_filename()) path = path.parent_path();
        if (std::error_code unknown; !path.has_parent_path() || !fs::is_directory(path, unknown)) continue;
        const fs::path root = path.parent_path().parent_path();
        const std::string meant = root.empty() ? "." : root.string();
        if (!found.empty() && found != meant)
            throw UsageError(
                fmt::format("the units named lie in two workspaces, {} and {}: name those of one", found, meant));
        found = meant;
    }
    return found.empty() ? folder : found;
}

void expect_folder(const fs::path& folder, std::string_view meaning)
{
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    expect_known(folder, status, error);
    if (!fs::exists(status)) refuse(folder, fmt::format("expected {}; there is no such folder", meaning));
    if (!fs::is_directory(status)) refuse(folder, fmt::format("expected {}; this is not a folder", meaning));
    expect_access(folder, R_OK | X_OK);
}

void make_folder(const fs::path& folder)
{
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        refuse(folder, "expected a folder, or a new name; this is not a folder");
    fs::create_directories(folder, error);
    if (error) refuse(folder, fmt::format("cannot make this folder: {}", error.message()));
    expect_access(folder, W_OK | X_OK);
}

void expect_writable(const fs::path& file)
{
    if (file.empty()) return;
    std::error_code error;
    const fs::file_status status = fs::symlink_status(file, error);
    expect_known(file, status, error);
    // Writing renames a new file over the old name: a device would be replaced, not written to.
    if (fs::exists(status) && !fs::is_regular_file(status))
        refuse(file, "expected a file to write, or a new name; this is a folder, a link or a device");
    if (!file.has_filename()) refuse(file, "expected the name of a file, got a folder's");
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    expect_folder(folder, fmt::format("the folder of {}", file.filename().string()));
    expect_access(folder, W_OK | X_OK);
}

std::string read_given(std::string_view option, const fs::path& file, std::size_t most)
{
    const auto refuse_given = [&](const std::string& reason) {
        throw UsageError(fmt::format("{} {}: {}", option, file.string(), reason));
    };
    const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status {};
    if (!opened || fstat(opened.get(), &status) != 0) refuse_given(std::generic_category().message(errno));
    if (!S_ISREG(status.st_mode)) refuse_given("expected a regular file, got another kind");
    std::string bytes(most + 1, '\0');
    std::size_t size = 0;
    while (size < bytes.size()) {
        const ssize_t got = read(opened.get(), bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse_given(std::generic_category().message(errno));
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    if (size > most) refuse_given(fmt::format("expected at most {} KiB, got more", most >> 10U));
    bytes.resize(size);
    return bytes;
}

void write_output(const fs::path& file, std::string_view text)
{
    try {
        write_file_atomically(file, std::as_bytes(std::span(text)));
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

}
