#include "collect/folder_reader.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

#include "collect/file_names.hpp"

namespace umbral::grader {
namespace {

/// The machine failed, and no submission: an ailing disk, a network that is gone, something that was moved meanwhile.
[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category(), "reading a submission"); }

/// Why something that is there could not be opened, if the one who made it is to blame. Throws if not.
std::string reason_of(int error)
{
    if (!may_be_made(error)) fail(error);
    if (error == ELOOP) return "it is a link: hand in the file itself";
    return fmt::format("it cannot be opened: {}", std::generic_category().message(error));
}

/// Opens `path` part by part, so that none of them can be a link. The result is empty, with errno set, if that fails.
Descriptor open_below(int root, std::string_view path, int flags)
{
    constexpr int always = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    Descriptor folder(openat(root, ".", always | O_DIRECTORY));
    while (folder && !path.empty()) {
        const std::size_t end = std::min(path.find('/'), path.size());
        const std::string part(path.substr(0, end));
        path.remove_prefix(std::min(end + 1, path.size()));
        folder = Descriptor(openat(folder.get(), part.c_str(), always | (path.empty() ? flags : O_DIRECTORY)));
    }
    return folder;
}

struct CloseFolder {
    void operator()(DIR* folder) const { closedir(folder); }
};

bool is_folder(int parent, const dirent& entry)
{
    if (entry.d_type != DT_UNKNOWN) return entry.d_type == DT_DIR;
    struct stat status {};
    return fstatat(parent, entry.d_name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(status.st_mode);
}

}

bool may_be_made(int error) noexcept
{
    constexpr std::array made{EACCES, EISDIR, ELOOP, ENAMETOOLONG, ENODEV, ENOTDIR, ENXIO, EPERM};
    return std::ranges::find(made, error) != made.end();
}

bool lies_below(int root, std::string_view path)
{
    const Descriptor folder = open_below(root, parent_part(path), O_DIRECTORY);
    struct stat status {};
    if (folder && fstatat(folder.get(), std::string(last_part(path)).c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0)
        return true;
    if (errno != ENOENT && !may_be_made(errno)) fail(errno);
    return false;
}

FileBytes read_file_below(int root, std::string_view path, std::size_t limit)
{
    FileBytes result;
    const auto refuse = [&](std::string reason) {
        result.refused = std::move(reason);
        return result;
    };
    const Descriptor folder = open_below(root, parent_part(path), O_DIRECTORY);
    if (!folder) return refuse(reason_of(errno));
    const std::string name(last_part(path));
    struct stat status {};
    // Opening a device may already do something to it.
    if (fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return refuse(reason_of(errno));
    if (S_ISLNK(status.st_mode)) return refuse(reason_of(ELOOP));
    if (S_ISDIR(status.st_mode)) return refuse("it is a folder");
    if (!S_ISREG(status.st_mode)) return refuse("it is not a regular file");
    const Descriptor file = open_below(folder.get(), name, 0);
    if (!file) return refuse(reason_of(errno));
    if (fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return refuse("it is not a regular file");
    if (static_cast<std::size_t>(status.st_size) > limit)
        return refuse(fmt::format("it has {} bytes; at most {} are read", status.st_size, limit));
    result.bytes.resize(static_cast<std::size_t>(status.st_size));
    std::size_t size = 0;
    while (size < result.bytes.size()) {
        const ssize_t got =
            pread(file.get(), result.bytes.data() + size, result.bytes.size() - size, static_cast<off_t>(size));
        if (got < 0) fail(errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    result.bytes.resize(size);
    return result;
}

Listing list_folder_below(int root, std::string_view path, std::size_t most)
{
    Listing listing;
    const Descriptor descriptor = open_below(root, path, O_DIRECTORY);
    // The stream owns, and closes, what it is given.
    const int own = descriptor ? fcntl(descriptor.get(), F_DUPFD_CLOEXEC, 0) : -1;
    if (own < 0) {
        listing.refused = reason_of(errno);
        return listing;
    }
    const std::unique_ptr<DIR, CloseFolder> folder(fdopendir(own));
    if (!folder) {
        close(own);
        fail(errno);
    }
    const auto next = [&] {
        errno = 0;
        const dirent* const entry = readdir(folder.get());
        if (entry == nullptr && errno != 0) fail(errno);
        return entry;
    };
    while (const dirent* entry = next()) {
        const std::string_view name = entry->d_name;
        if (name == "." || name == "..") continue;
        listing.whole = listing.entries < most;
        if (!listing.whole) break;
        ++listing.entries;
        if (is_junk(name)) continue;
        const FileKind kind = kind_of(name);
        if (is_folder(dirfd(folder.get()), *entry))
            listing.folders.emplace_back(name);
        else if (is_code(kind) || kind == FileKind::archive)
            listing.files.emplace_back(name);
    }
    std::ranges::sort(listing.folders);
    std::ranges::sort(listing.files);
    return listing;
}

}
