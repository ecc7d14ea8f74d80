#include "store/reports_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "store/refused_folder.hpp"
#include "store/temporaries.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what)
{
    throw std::system_error(errno, std::generic_category(), fmt::format("{}: {}", path.string(), what));
}

/// Locks an open mark, or refuses. Where a file system knows no locks, going on without is all that can be done.
void lock(const Descriptor& mark, const fs::path& folder)
{
    if (flock(mark.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    throw RefusedFolder(fmt::format(
        "{}: another `umbral grade` is writing its reports here; wait until it ends, or name another folder with --out",
        folder.string()));
}

/// The marks of the submissions that have reports there, by their ids.
std::map<std::string, Mark> marks_in(const fs::path& folder)
{
    std::map<std::string, Mark> marks;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        try {
            if (!fs::is_directory(entry.symlink_status())) continue;
            if (std::optional<Mark> mark = read_mark(entry.path()); mark && mark->submission == name)
                marks.emplace(name, *std::move(mark));
        } catch (const std::exception&) {  // not ours, then
        }
    }
    return marks;
}

bool is_still(const Descriptor& mark, const fs::path& file)
{
    struct stat open {};
    struct stat named {};
    return fstat(mark.get(), &open) == 0 && lstat(file.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

}

// A mark is locked before it gets its name, and replaced by another one that is locked already: whoever opens it finds
// it locked, and whoever has locked one looks whether it is still the one with the name.
Descriptor ReportsFolder::locked_mark(const Grading& grading, bool replace) const
{
    const fs::path file = path_ / mark_name;
    for (;;) {
        Descriptor mark(replace ? -1 : open(file.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
        if (mark) {
            lock(mark, path_);
            if (is_still(mark, file)) return mark;
            continue;
        }
        if (!replace && errno != ENOENT) fail(file, "cannot open it");
        const fs::path temporary = fmt::format("{}.tmp-{}-0", file.string(), getpid());
        unlink(temporary.c_str());
        mark = Descriptor(open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR));
        if (!mark) fail(file, "cannot create a temporary file beside it");
        lock(mark, path_);
        const std::string text = to_text({.grading = grading});
        const bool written =
            write(mark.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) && fsync(mark.get()) == 0;
        const bool named = written && renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, file.c_str(),
                                                replace ? 0 : RENAME_NOREPLACE) == 0;
        if (named) return mark;
        const int error = errno;
        unlink(temporary.c_str());
        errno = error;
        if (!written || replace || errno != EEXIST) fail(file, "cannot write it");
    }
}

ReportsFolder::ReportsFolder(const fs::path& out, const Grading& grading) : grading_(grading)
{
    const fs::file_status status = fs::status(out);
    if (fs::exists(status) && !fs::is_directory(status))
        throw RefusedFolder(fmt::format("--out {}: expected a folder, or nothing yet", out.string()));
    const fs::path parent = fs::absolute(out).lexically_normal();
    fs::create_directories(parent);
    path_ = fs::canonical(out);
    if (!read_mark(path_) && !is_untouched(path_))
        throw RefusedFolder(
            fmt::format("--out {}: the folder holds things that Umbral did not make, and reports must not meet them; "
                        "name a new or an empty folder (if these are "
                        "reports of a version that set no marks yet, delete it first)",
                        path_.string()));
    if (const std::optional<Mark> mark = read_mark(path_); mark && !mark->submission.empty())
        throw RefusedFolder(
            fmt::format("--out {}: these are the reports of {}, for a student's eyes, and everybody's would lie among "
                        "them; name another folder",
                        path_.string(), mark->submission));
    lock_ = locked_mark(grading, false);
    if (const std::optional<Mark> mark = read_mark(path_)) grading_ = mark->grading;
    remove_temporaries(path_, mark_name);
}

void ReportsFolder::tidy(std::string_view file) const noexcept { remove_temporaries(path_, file); }

void ReportsFolder::set_grading(const Grading& grading)
{
    lock_ = locked_mark(grading, true);
    grading_ = grading;
}

std::vector<std::string> ReportsFolder::submissions() const
{
    std::vector<std::string> ids;
    for (const auto& [id, mark] : marks_in(path_)) ids.push_back(id);
    return ids;
}

std::map<std::string, std::string> ids_by_source(const fs::path& out)
{
    std::map<std::string, std::string> ids;
    try {
        for (const auto& [id, mark] : marks_in(out))
            if (!mark.source.empty()) ids.emplace(mark.source, id);
    } catch (const fs::filesystem_error&) {  // a new folder, or none of ours: whoever opens it says so
    }
    return ids;
}

}
