#include "collect/class_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "collect/file_names.hpp"
#include "collect/roster.hpp"
#include "collect/submission_id.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Why an entry of the class's folder is no submission; empty if it is one.
std::string why_none(const fs::directory_entry& entry, const std::string& name)
{
    if (name.starts_with('.') || is_junk(name)) return "not a submission: its name says so";
    std::error_code error;
    const fs::file_type type = entry.symlink_status(error).type();
    if (type == fs::file_type::directory) return "";
    if (type == fs::file_type::symlink) return "it is a link: submissions are folders or archives themselves";
    if (type != fs::file_type::regular) return "it is neither a folder nor an archive";
    return kind_of(name) == FileKind::archive ? "" : "it is a file: submissions are folders or archives";
}

/// A submission's name on the disk, and the name from which its id follows.
struct Entry {
    std::string name;
    std::string stem;  ///< without an archive's suffix
    std::string id;
    std::string shown;
    bool listed = false;  ///< in the roster
    bool known = false;   ///< by the id that it had when it was graded before
};

std::vector<Entry> entries_of(const fs::path& path, ClassFolder& result)
{
    std::error_code error;
    std::vector<Entry> entries;
    fs::directory_iterator at(path, error);
    const auto check = [&] {
        if (error)
            throw std::runtime_error(
                fmt::format("{}: expected a folder with one folder a submission: {}", path.string(), error.message()));
    };
    check();
    for (; at != fs::directory_iterator(); at.increment(error), check()) {
        const std::string name = at->path().filename().string();
        const std::string reason = why_none(*at, name);
        if (!reason.empty()) {
            result.ignored.push_back({one_line(name), reason});
            continue;
        }
        const bool folder = at->is_directory(error) && !error;
        error.clear();
        entries.push_back({name, folder ? name : std::string(without_archive_suffix(name)), "", one_line(name)});
    }
    std::ranges::sort(entries, {}, &Entry::name);
    return entries;
}

/// What a line of the roster that names no folder was probably meant to name. Accents behind their letters, as Macs
/// write them, look like letters with accents.
std::string alike(const RosterEntry& line, const std::vector<Entry>& entries)
{
    const std::string wanted = derived_id(line.folder);
    std::vector<std::string> names;
    for (const Entry& entry : entries)
        if (!wanted.empty() && derived_id(entry.stem) == wanted) names.push_back(entry.name);
    if (names.empty()) return "";
    return fmt::format("; {} looks alike, but is spelt with other characters: copy the name from there", listed(names));
}

/// The submission that a line of the roster means: by the whole name of its archive, or by that of a folder, or of an
/// archive without its suffix, if nothing else has it, since whoever names what is handed in must not choose whose work
/// it is. Null, with the reason, if there is none.
Entry* meant_by(const RosterEntry& line, std::vector<Entry>& entries, std::string& reason)
{
    const auto exact = std::ranges::find(entries, line.folder, &Entry::name);
    if (exact != entries.end() && exact->stem != exact->name) return &*exact;
    std::vector<std::string> names;
    Entry* found = nullptr;
    for (Entry& entry : entries) {
        if (entry.stem != line.folder) continue;
        names.push_back(entry.name);
        found = &entry;
    }
    if (names.size() == 1) return found;
    reason = names.empty()
                 ? "there is no such folder" + alike(line, entries)
                 : fmt::format("each of {} could be it: list an archive by its whole name, or rename one of them",
                               listed(names));
    return nullptr;
}

void apply_roster(const std::vector<RosterEntry>& roster, const std::string& where, std::vector<Entry>& entries,
                  ClassFolder& result)
{
    for (const RosterEntry& line : roster) {
        std::string reason;
        Entry* const found = meant_by(line, entries, reason);
        if (found == nullptr) {
            result.ignored.push_back(
                {one_line(line.folder), fmt::format("line {} of the roster: {}", line.line, reason)});
            continue;
        }
        if (found->listed)
            throw std::runtime_error(fmt::format("{}:{}: '{}' is listed already, by another of its names", where,
                                                 line.line, one_line(line.folder)));
        found->listed = true;
        found->id = line.id;
        if (!line.name.empty()) found->shown = one_line(line.name);
    }
}

bool is_own_id(const Entry& entry) { return is_submission_id(entry.stem) && !is_reserved_id(entry.stem); }

/// Gives those whom the roster does not list the ids that they had before, as far as it gives these to nobody: what
/// others hand in later takes nobody's id.
void give_known_ids(const std::map<std::string, std::string>& known, std::vector<Entry>& entries)
{
    for (Entry& entry : entries) {
        // Marks hold names that were made printable, which several may have become.
        const auto before = one_line(entry.name) == entry.name ? known.find(entry.name) : known.end();
        if (entry.listed || before == known.end() || !is_submission_id(before->second)) continue;
        const auto has_it = [&](const Entry& other) {
            return (other.listed || other.known) && other.id == before->second;
        };
        if (std::ranges::any_of(entries, has_it)) continue;
        entry.id = before->second;
        entry.known = true;
    }
}

/// Gives an id to everybody who has none by the roster, nor by what was graded before.
void give_ids(std::vector<Entry>& entries)
{
    const auto is_given = [](const Entry& entry) { return entry.listed || entry.known; };
    std::map<std::string, int> wanted;
    for (Entry& entry : entries) {
        if (is_given(entry)) continue;
        entry.id = is_own_id(entry) ? entry.stem : derived_id(entry.stem);
        if (entry.id.empty()) entry.id = "submission-" + short_hash(entry.name);
    }
    for (const Entry& entry : entries) ++wanted[entry.id];
    // What the roster gives is the instructor's word: a folder whose name is somebody else's id gives way, so that
    // nobody's name can keep a class from being graded. Else a folder keeps its plain name whoever would like it; of
    // the others each gets its hash, so that no order matters.
    std::set<std::string> given;
    for (const Entry& entry : entries)
        if (is_given(entry)) given.insert(entry.id);
    std::set<std::string> taken = given;
    const auto keeps = [&](const Entry& entry) {
        return is_given(entry) || (is_own_id(entry) && entry.name == entry.stem && !given.contains(entry.id));
    };
    for (const Entry& entry : entries)
        if (keeps(entry)) taken.insert(entry.id);
    for (Entry& entry : entries) {
        if (keeps(entry)) continue;
        if (wanted[entry.id] > 1) entry.id += "-" + short_hash(entry.name);
        // Somebody may have made a folder that is named like this one's hash.
        while (!taken.insert(entry.id).second) entry.id = "submission-" + short_hash(entry.id + entry.name);
    }
}

}

ClassFolder class_folder(const fs::path& path, const fs::path& roster, const std::map<std::string, std::string>& known)
{
    ClassFolder result;
    std::vector<Entry> entries = entries_of(path, result);
    if (!roster.empty())
        apply_roster(parse_roster(read_text(roster), roster.string()), roster.string(), entries, result);
    give_known_ids(known, entries);
    give_ids(entries);
    for (const Entry& entry : entries) result.submissions.push_back({entry.id, path / entry.name, entry.shown});
    std::ranges::sort(result.submissions, {}, &SubmissionFolder::id);
    std::ranges::sort(result.ignored, {}, &Ignored::path);
    return result;
}

}
