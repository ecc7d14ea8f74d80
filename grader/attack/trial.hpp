#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "attack/attack.hpp"
#include "attack/measured.hpp"
#include "attack/setting.hpp"

namespace umbral::grader::attack {

/// Where the program that is attacked lies, and the work that stands beside the attacks.
struct Target {
    std::filesystem::path umbral;        ///< the program
    std::filesystem::path reference;     ///< answers, which are handed in as good work
    std::filesystem::path exercises;     ///< which files a unit has
    std::filesystem::path sample_class;  ///< tests/class: more good work
    int more_good = 0;                   ///< so many further copies of the answers, each with a comment of its own
};

/// What is left of grading a class: its reports by submission, and what it cost.
struct Graded {
    Measured run;
    std::filesystem::path submissions;
    std::filesystem::path out;
    std::filesystem::path source;  ///< where Umbral lies
    std::string secret;
    nlohmann::json class_json;                      ///< null if there is none
    std::map<std::string, nlohmann::json> reports;  ///< what report.json says of a submission, by its id
    double cache_kib = 0;
    double reports_kib = 0;

    /// The class was graded to its end.
    [[nodiscard]] bool complete() const { return run.status == 0 && class_json.is_object(); }
    [[nodiscard]] std::string how_it_ended() const;
};

/// Names of the good submissions that stand in every class.
[[nodiscard]] std::vector<std::string> good_ids();

/// Puts good work and the attacks into one class below `scratch`, an empty folder, and grades it with the real program
/// under --jobs 8. `units` are the units that are graded.
[[nodiscard]] Graded grade_beside_good(const Target& target, const Setting& setting, std::span<const Attack> attacks,
                                       const std::vector<std::string>& units, const std::filesystem::path& scratch,
                                       double seconds = 1800);

/// The units of all these attacks, sorted.
[[nodiscard]] std::vector<std::string> units_of(std::span<const Attack> attacks);

}
