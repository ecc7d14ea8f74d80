#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/exercise.hpp"

namespace umbral::grader {

/// Reads `folder/exercise.json`; the folder's last two names must be the unit's id, and driver and stubs must lie in
/// it, or `packaged_file` instead of the driver. Throws std::runtime_error that names the file, the field, what was
/// expected and what came.
[[nodiscard]] Exercise load_exercise(const std::filesystem::path& folder);

/// The same from parsed JSON (`where` names it in messages); reads no other file, so `digest` stays empty.
[[nodiscard]] Exercise parse_exercise(const nlohmann::json& json, const std::string& where);

/// A folder topic/unit with a manifest that is no unit yet, or a topic's folder that cannot be read.
struct BrokenUnit {
    std::string id;      ///< as its folders are called: "topic/unit", or "topic"
    std::string reason;  ///< what load_exercise says
};

struct Units {
    std::vector<Exercise> exercises;
    std::vector<BrokenUnit> broken;  ///< sorted by id
};

/// All units below `root` (topic/unit/exercise.json), sorted by topic in the order of `root`/topics.txt (a name a line,
/// # begins a comment; other topics behind, by name), then `order`, then id. A unit that cannot be loaded keeps no
/// other from being loaded. Throws std::runtime_error if `root` is no folder that can be read, and if the units have
/// more checks of a judge than it allows in all of a course (JudgeRecord::most_in_course).
[[nodiscard]] Units load_units(const std::filesystem::path& root);

}
