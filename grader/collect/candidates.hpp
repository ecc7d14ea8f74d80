#pragma once

#include <span>
#include <string>
#include <vector>

#include "collect/submitted_files.hpp"

namespace umbral::grader {

/// Where a file lies, from where a unit's file belongs to where it may be found.
enum class Place {
    workspace,         ///< topic/unit/file, exactly
    flat,              ///< directly in the submission, exactly
    like_a_workspace,  ///< below a folder topic/unit, of whatever case and wherever that lies
    elsewhere
};

/// A file that could be one that a unit asks for.
struct Candidate {
    std::string path;  ///< in SubmittedFiles::files
    std::string_view text;
    Place place = Place::elsewhere;
    bool stub = false;
};

/// All files that could be the unit's file `name`, the best places first.
[[nodiscard]] std::vector<Candidate> candidates_for(const SubmittedFiles& submitted, const Exercise& exercise,
                                                    const std::string& name);

/// Is the folder the unit's own, by its name ("Sphere", "view_matrix")?
[[nodiscard]] bool is_own_folder(std::string_view folder, const Exercise& exercise);

/// What was chosen for one file.
struct Choice {
    const Candidate* chosen = nullptr;  ///< null if there is none, or several that differ
    std::vector<std::string>
        others;  ///< paths of solutions that differ: what was passed over, or could not be told apart
};

/// The best place with a solution decides, if all that lies in places of that kind has the same text; without a
/// solution, the stub.
[[nodiscard]] Choice choose(std::span<const Candidate> candidates);

}
