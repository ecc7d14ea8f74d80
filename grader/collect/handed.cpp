#include "collect/handed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "collect/candidates.hpp"
#include "collect/file_names.hpp"
#include "collect/submission_id.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

/// What was found for one file that the unit asks for.
struct Found {
    std::string name;
    std::vector<Candidate> candidates;
    Choice choice;
};

/// The chosen file that says where the unit lies: a solution before a stub, a better place before a worse one. Null if
/// none is chosen.
const Candidate* anchor_of(const std::vector<Found>& all)
{
    const Candidate* anchor = nullptr;
    const auto rank = [](const Candidate& one) { return std::pair(one.stub, one.place); };
    for (const Found& found : all)
        if (const Candidate* chosen = found.choice.chosen;
            chosen != nullptr && (anchor == nullptr || rank(*chosen) < rank(*anchor)))
            anchor = chosen;
    return anchor;
}

/// A unit of several files is taken from one folder, if that folder has them: no mixture of two attempts.
void prefer_one_folder(std::vector<Found>& all)
{
    const Candidate* anchor = anchor_of(all);
    if (anchor == nullptr) return;
    for (Found& found : all) {
        std::vector<Candidate> beside;
        for (const Candidate& one : found.candidates)
            if (parent_part(one.path) == parent_part(anchor->path)) beside.push_back(one);
        const Choice here = choose(beside);
        if (here.chosen == nullptr ||
            (found.choice.chosen != nullptr && found.choice.chosen->path == here.chosen->path))
            continue;
        const auto same = std::ranges::find(found.candidates, here.chosen->path, &Candidate::path);
        found.choice.others.clear();
        for (const Candidate& one : found.candidates)
            if (!one.stub && one.text != same->text) found.choice.others.push_back(one.path);
        found.choice.chosen = &*same;
    }
}

/// Why the file `name` is not there, if something of that name was not read; empty otherwise.
std::string why_not_read(const SubmittedFiles& submitted, const Exercise& exercise, const std::string& name)
{
    const Ignored* best = nullptr;
    for (const Ignored& one : submitted.ignored) {
        const bool exact = one.path == name || one.path == exercise.id + "/" + name;
        if (exact || (best == nullptr && file_key(last_part(one.path)) == file_key(name))) best = &one;
        if (exact) break;
    }
    return best == nullptr ? "" : fmt::format("{}: {}", one_line(best->path), best->reason);
}

/// The first of many names, and how many there are beside them.
std::string some_of(std::vector<std::string> names)
{
    constexpr std::size_t most = 2;
    if (names.size() <= most + 1) return listed(names);
    const std::size_t left = names.size() - most;
    names.resize(most);
    return fmt::format("{} and {} other places", listed(names), left);
}

/// Enters what was found for one file.
void enter(const Found& found, const SubmittedFiles& submitted, const Exercise& exercise, Handed& handed)
{
    const auto& [name, candidates, choice] = found;
    const auto refuse = [&](const std::string& reason) {
        if (handed.refused.empty()) handed.refused = reason;
    };
    if (choice.chosen != nullptr) {
        handed.files[name] = choice.chosen->text;
        if (choice.chosen->place >= Place::like_a_workspace)
            handed.notes.push_back(fmt::format("{}: taken from {}", name, one_line(choice.chosen->path)));
        if (!choice.others.empty())
            handed.notes.push_back(
                fmt::format("{}: something else stands in {}, which does not count", name, some_of(choice.others)));
    } else if (!choice.others.empty()) {
        refuse(fmt::format(
            "{}: {} different files could be it ({}), so none was taken: hand in only one of them, or put it in {}/{}",
            name, choice.others.size(), listed(choice.others), exercise.id, name));
    } else if (const std::string reason = why_not_read(submitted, exercise, name); !reason.empty()) {
        refuse(reason);
    } else {
        handed.missing.push_back(name);
    }
}

/// The name under which a file beside the unit's own is compiled; nothing if it cannot be, with the reason in `handed`.
std::optional<std::string> helper_name(std::string_view path, Handed& handed)
{
    std::string name(last_part(path));
    // A name that begins with '-' would be an option.
    if (!is_submission_id(name) || name.starts_with('-')) {
        handed.notes.push_back(fmt::format(
            "{}: not read: name it with letters, digits, '.', '_' and '-', a letter first", one_line(path)));
        return std::nullopt;
    }
    // The compiler is given what ends in .cpp.
    if (kind_of(name) == FileKind::source) name = std::string(name.substr(0, name.find_last_of('.'))) + ".cpp";
    return name;
}

/// Takes the student's own helpers beside the unit's files, if the folder is the unit's: elsewhere they could belong to
/// anything.
void take_helpers(const SubmittedFiles& submitted, const Exercise& exercise, std::string_view folder, Handed& handed)
{
    if (!is_own_folder(folder, exercise)) return;
    std::size_t bytes = 0;
    for (const auto& [name, text] : handed.files) bytes += text.size();
    std::vector<std::string> left_out;
    const auto is_the_units = [&](std::string_view path) {
        return std::ranges::any_of(
            exercise.files, [&](const std::string& name) { return file_key(name) == file_key(last_part(path)); });
    };
    const std::string prefix = std::string(folder) + "/";
    for (auto at = submitted.files.lower_bound(prefix); at != submitted.files.end() && at->first.starts_with(prefix);
         ++at) {
        const auto& [path, text] = *at;
        if (parent_part(path) != folder || is_the_units(path)) continue;
        const auto name = helper_name(path, handed);
        if (!name) continue;
        if (handed.files.contains(*name) || handed.files.size() >= caps::unit_files ||
            bytes + text.size() > caps::unit_sources) {
            left_out.push_back(path);
            continue;
        }
        handed.files[*name] = text;
        bytes += text.size();
    }
    if (!left_out.empty())
        handed.notes.push_back(
            fmt::format("not read, since there are too many files or bytes, or two of one name: {}", listed(left_out)));
}

/// Where something is missing, what could not be looked into may be the reason.
void explain_missing(const SubmittedFiles& submitted, Handed& handed)
{
    if (handed.missing.empty() && handed.refused.empty()) return;
    handed.notes.insert(handed.notes.end(), submitted.notes.begin(), submitted.notes.end());
    std::vector<std::string> shut;
    for (const Ignored& one : submitted.ignored)
        if (!is_code(kind_of(last_part(one.path))))
            shut.push_back(fmt::format("{} ({})", one_line(one.path), one.reason));
    if (!shut.empty()) handed.notes.push_back(fmt::format("not looked into: {}", listed(shut)));
}

}

Handed collect(const SubmittedFiles& submitted, const Exercise& exercise)
{
    std::vector<Found> all;
    for (const std::string& name : exercise.files) {
        all.push_back({name, candidates_for(submitted, exercise, name), {}});
        all.back().choice = choose(all.back().candidates);
    }
    if (all.size() > 1) prefer_one_folder(all);
    Handed handed;
    for (const Found& found : all) enter(found, submitted, exercise, handed);
    if (const Candidate* anchor = anchor_of(all)) take_helpers(submitted, exercise, parent_part(anchor->path), handed);
    if (handed.notes.size() > caps::listed) handed.notes.resize(caps::listed);
    explain_missing(submitted, handed);
    return handed;
}

Handed collect(const std::filesystem::path& folder, const Exercise& exercise)
{
    return collect(read_submission(folder, {&exercise, 1}), exercise);
}

}
