#include "collect/candidates.hpp"

#include <algorithm>
#include <utility>

#include "collect/file_names.hpp"

namespace umbral::grader {
namespace {

bool is_named(std::string_view folder, std::string_view name)
{
    return folder_key(without_archive_suffix(last_part(folder))) == folder_key(name);
}

Place place_of(std::string_view path, const Exercise& exercise, const std::string& name)
{
    if (path == exercise.id + "/" + name) return Place::workspace;
    if (path == name) return Place::flat;
    for (std::string_view folder = parent_part(path); !folder.empty(); folder = parent_part(folder))
        if (is_named(folder, exercise.name) && is_named(parent_part(folder), exercise.topic))
            return Place::like_a_workspace;
    return Place::elsewhere;
}

}

std::vector<Candidate> candidates_for(const SubmittedFiles& submitted, const Exercise& exercise,
                                      const std::string& name)
{
    std::vector<Candidate> candidates;
    const std::string key = file_key(name);
    for (const auto& [path, text] : submitted.files)
        if (file_key(last_part(path)) == key)
            candidates.push_back({path, text, place_of(path, exercise, name), is_stub(text, exercise, name)});
    // Among equals the plain name comes first.
    std::ranges::stable_sort(candidates, {},
                             [&](const Candidate& one) { return std::pair(one.place, last_part(one.path) != name); });
    return candidates;
}

bool is_own_folder(std::string_view folder, const Exercise& exercise) { return is_named(folder, exercise.name); }

Choice choose(std::span<const Candidate> candidates)
{
    Choice choice;
    if (candidates.empty()) return choice;
    const auto first = std::ranges::find(candidates, false, &Candidate::stub);
    if (first == candidates.end()) {
        choice.chosen = &candidates.front();
        return choice;
    }
    choice.chosen = &*first;
    bool alone = true;
    for (const Candidate& one : candidates) {
        if (one.stub || one.text == first->text) continue;
        choice.others.push_back(one.path);
        alone = alone && one.place != first->place;
    }
    if (!alone) {
        // Of what could not be told apart the chosen one is no better than the others.
        std::erase_if(choice.others, [&](const std::string& path) {
            return std::ranges::find(candidates, path, &Candidate::path)->place != first->place;
        });
        choice.others.insert(choice.others.begin(), first->path);
        choice.chosen = nullptr;
    }
    return choice;
}

}
