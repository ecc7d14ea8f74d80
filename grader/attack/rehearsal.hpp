#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "attack/trial.hpp"

namespace umbral::grader::attack {

/// What came of one attack.
struct Outcome {
    std::string came;                   ///< "raytracing/sphere: compile_error 0"
    std::vector<std::string> findings;  ///< what did not hold; none if all did
};

/// What came of a class of attacks beside good work.
struct Rehearsal {
    std::map<std::string, Outcome> outcomes;   ///< by the attack's id
    std::vector<std::string> changes_of_good;  ///< what the attacks changed of good work's results; none if nothing
    Measured run;                              ///< of the grading of all together
    double cache_mib = 0;
    double reports_mib = 0;
};

/// Grades the good work alone, then beside all the attacks at once. If that class does not come to its end, its halves
/// are graded, and so on, until those that end it are alone. Needs an empty folder; what it leaves there is the
/// caller's to remove. `say` is told what happens.
[[nodiscard]] Rehearsal rehearse(const Target& target, const Setting& setting, std::span<const Attack> attacks,
                                 const std::filesystem::path& scratch,
                                 const std::function<void(const std::string&)>& say = {});

/// Grades good work beside one attack alone: what it costs is held against its bounds.
[[nodiscard]] Outcome rehearse_alone(const Target& target, const Setting& setting, const Attack& attack,
                                     const std::filesystem::path& scratch);

}
