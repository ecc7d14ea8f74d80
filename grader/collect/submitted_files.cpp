#include "collect/submitted_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <functional>
#include <set>
#include <system_error>

#include "collect/archive.hpp"
#include "collect/file_names.hpp"
#include "collect/folder_reader.hpp"
#include "collect/text_encoding.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

std::string joined(std::string_view folder, std::string_view name)
{
    return folder.empty() ? std::string(name) : fmt::format("{}/{}", folder, name);
}

/// Gathers what is found, within the caps.
class Intake {
public:
    explicit Intake(const ArchiveTools& tools) : tools_(tools) {}

    void take_text(const std::string& path, std::string bytes)
    {
        if (full() || bytes_ + bytes.size() > caps::submission_bytes) {
            if (!full_)
                note(fmt::format("it holds more than {} files or {} MiB of source code; the rest was not read",
                                 caps::submission_files, caps::submission_bytes >> 20U));
            full_ = true;
            return ignore(path, "the submission holds too much source code");
        }
        bytes_ += bytes.size();
        // Of two in one archive the later one counts, as for whoever unpacks it.
        result_.files.insert_or_assign(path, as_utf8(std::move(bytes)));
    }

    /// Is there no room for another file, or may no more archives be opened?
    [[nodiscard]] bool full() const { return full_ || result_.files.size() >= caps::submission_files; }
    [[nodiscard]] bool archives_full() const { return archives_ >= caps::submission_archives; }

    void ignore(const std::string& path, std::string reason)
    {
        if (result_.ignored.size() < caps::submission_ignored) result_.ignored.push_back({path, std::move(reason)});
    }

    void note(std::string text)
    {
        if (result_.notes.size() < caps::listed) result_.notes.push_back(std::move(text));
    }

    /// Opens an archive, and those within; `prefix` is the path of what comes out of it.
    void take_archive(const std::string& path, const std::string& prefix, std::string_view bytes, std::size_t depth = 1)
    {
        if (tools_.programs.empty()) return ignore(path, "archives are not opened here: unpack it");
        if (depth > caps::archive_depth)
            return ignore(path, "it is an archive within an archive within another: unpack it");
        if (archives_full())
            return ignore(path, fmt::format("only the first {} archives are opened", caps::submission_archives));
        // The kernel counts whole seconds.
        if (tools_.seconds < 1) return ignore(path, "unpacking the archives before it took too long");
        ++archives_;
        Unpacked unpacked = unpack(tools_, bytes, std::min(tools_.seconds, caps::unpack_seconds));
        tools_.seconds -= unpacked.cpu_seconds;
        for (const std::string& text : unpacked.notes) note(fmt::format("{}: {}", one_line(path), text));
        for (Ignored& one : unpacked.ignored) ignore(joined(prefix, one.path), std::move(one.reason));
        std::vector<std::pair<std::string, std::string>> inner;
        for (auto& [name, data] : unpacked.files)
            if (kind_of(last_part(name)) == FileKind::archive)
                inner.emplace_back(joined(prefix, name), std::move(data));
            else
                take_text(joined(prefix, name), std::move(data));
        for (const auto& [name, data] : inner) take_archive(name, name, data, depth + 1);
    }

    SubmittedFiles finish()
    {
        std::ranges::sort(result_.ignored, {}, &Ignored::path);
        return std::move(result_);
    }

private:
    ArchiveTools tools_;
    SubmittedFiles result_;
    std::size_t bytes_ = 0;
    std::size_t archives_ = 0;
    bool full_ = false;
};

struct Folder {
    std::string path;
    std::size_t depth = 0;
    bool of_unit = false;  ///< a unit's exact place
};

/// Where the files of `units` belong, if something lies there.
std::vector<std::string> exact_places(int root, std::span<const Exercise> units)
{
    std::vector<std::string> paths;
    for (const Exercise& unit : units)
        for (const std::string& name : unit.files)
            for (const std::string& path : {joined(unit.id, name), name})
                if (lies_below(root, path)) paths.push_back(path);
    return paths;
}

/// The paths of all files of worth below `root`: those in the folders of `units` first, then the nearest. What cannot
/// be entered is reported to `intake`.
std::vector<std::string> find_files(int root, std::span<const Exercise> units, Intake& intake)
{
    // Headers, of which a library's copy holds thousands, push no source out, except in the units' own folders.
    std::vector<std::string> paths;
    std::vector<std::string> headers;
    std::size_t entries_left = caps::submission_entries;
    bool too_deep = false;
    std::deque<Folder> waiting;
    for (const Exercise& unit : units)
        if (lies_below(root, unit.id)) waiting.push_back({unit.id, 2, true});
    waiting.push_back({"", 0, false});
    std::set<std::string> entered;
    for (; !waiting.empty(); waiting.pop_front()) {
        const Folder& folder = waiting.front();
        if (!entered.insert(folder.path).second) continue;
        const Listing listing = list_folder_below(root, folder.path, entries_left);
        entries_left -= listing.entries;
        if (!listing.refused.empty()) intake.ignore(folder.path, listing.refused);
        for (const std::string& name : listing.files)
            (folder.of_unit || kind_of(name) != FileKind::header ? paths : headers)
                .push_back(joined(folder.path, name));
        for (const std::string& name : listing.folders) {
            if (is_framework_copy(joined(folder.path, name))) continue;
            if (is_code(kind_of(name))) intake.ignore(joined(folder.path, name), "it is a folder");
            too_deep = too_deep || folder.depth == caps::submission_depth;
            if (folder.depth < caps::submission_depth)
                waiting.push_back({joined(folder.path, name), folder.depth + 1, false});
        }
        if (!listing.whole) {
            intake.note(fmt::format("the submission holds more than {} files; not all were looked at",
                                    caps::submission_entries));
            break;
        }
    }
    if (too_deep)
        intake.note(
            fmt::format("folders are more than {} deep; the deepest were not looked at", caps::submission_depth));
    paths.insert(paths.end(), headers.begin(), headers.end());
    return paths;
}

/// Takes all files below `root`. Archives push nothing out.
void take_folder(int root, std::span<const Exercise> units, Intake& intake)
{
    std::vector<std::string> paths = exact_places(root, units);
    const std::vector<std::string> found = find_files(root, units, intake);
    paths.insert(paths.end(), found.begin(), found.end());
    const auto is_archive = [](const std::string& path) { return kind_of(last_part(path)) == FileKind::archive; };
    std::stable_partition(paths.begin(), paths.end(), std::not_fn(is_archive));
    std::set<std::string_view> seen;
    for (const std::string& path : paths) {
        if (!seen.insert(path).second) continue;
        const bool archive = is_archive(path);
        // What cannot be taken is not read either: there may be any number of it.
        const bool full = archive ? intake.archives_full() : intake.full();
        FileBytes file =
            full ? FileBytes{} : read_file_below(root, path, archive ? caps::archive_file : caps::source_file);
        if (!file.refused.empty())
            intake.ignore(path, std::move(file.refused));
        else if (archive)
            intake.take_archive(path, path, file.bytes);
        else
            intake.take_text(path, std::move(file.bytes));
    }
}

/// Takes a submission that is a single archive.
void take_single(const fs::path& path, Intake& intake)
{
    const std::string name = path.filename().string();
    const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const Descriptor folder(open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder) throw std::system_error(errno, std::generic_category(), "opening " + parent.string());
    const FileBytes file = read_file_below(folder.get(), name, caps::archive_file);
    if (!file.refused.empty())
        intake.note(fmt::format("{}: {}", one_line(name), file.refused));
    else if (kind_of(name) != FileKind::archive)
        intake.note(fmt::format("{}: it is neither a folder nor an archive", one_line(name)));
    else
        intake.take_archive(name, "", file.bytes);
}

}

SubmittedFiles read_submission(const fs::path& path, std::span<const Exercise> units, const ArchiveTools& tools)
{
    Intake intake(tools);
    const Descriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NONBLOCK | O_CLOEXEC));
    if (folder)
        take_folder(folder.get(), units, intake);
    else if (errno == ENOTDIR)
        take_single(path, intake);
    else if (!may_be_made(errno))
        throw std::system_error(errno, std::generic_category(), "opening " + path.string());
    else
        intake.note(fmt::format("the submission cannot be opened: {}", std::generic_category().message(errno)));
    return intake.finish();
}

}
