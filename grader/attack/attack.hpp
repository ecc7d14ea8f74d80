#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/verdict.hpp"

namespace umbral::grader::attack {

/// What must come of one unit of an attacking submission.
struct ExpectedUnit {
    std::vector<Verdict> verdicts;           ///< any of these; empty: any but a fault of the grader's
    double least_points = 0;                 ///< what the work in it is worth at least
    double most_points = 0;                  ///< and at most
    std::vector<std::string> message_has;    ///< texts that the unit's message must hold
    std::vector<std::string> message_lacks;  ///< texts that it must not hold
    double most_seconds = 0;                 ///< that the student's report may tell of; 0: any
};

/// What grading an attack alone may cost.
struct Bounds {
    double seconds = 60;
    double grader_memory_mib = 400;  ///< of the grader's own process, at its peak
    double report_kib = 2048;        ///< of the submission's reports
    double disk_mib = 128;           ///< of cache and reports together, when it is over
};

/// One attack: a folder with attack.json and the files that a student would hand in.
struct Attack {
    std::string theme;
    std::string name;
    std::filesystem::path folder;
    std::string what;          ///< one sentence
    std::string area;          ///< the room that has to hold it
    bool harmless = false;     ///< may run on an instructor's own machine, even if it succeeds
    bool ci = false;           ///< runs in every test; the others in a full one
    bool draws = false;        ///< one of its units uses OpenGL
    bool knows_paths = false;  ///< its files name places of this very grading, so that messages may repeat them
    std::string make;          ///< the generator of what git cannot hold; empty: none
    std::map<std::string, ExpectedUnit> units;
    std::vector<std::string> lacks;          ///< texts that no report, page or line on the terminal may hold
    std::vector<std::string> student_lacks;  ///< texts that what the student may read must not hold
    Bounds bounds;

    /// "shaders-long-comment": also the name of its submission.
    [[nodiscard]] std::string id() const { return theme + "-" + name; }
};

/// The attack in `folder`. Throws std::runtime_error that names file, field, what was expected and what came.
[[nodiscard]] Attack load_attack(const std::filesystem::path& folder);

/// All attacks in `root`/THEME/NAME, sorted by id.
[[nodiscard]] std::vector<Attack> load_attacks(const std::filesystem::path& root);

}
