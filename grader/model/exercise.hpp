#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/relation.hpp"

namespace umbral::grader {

/// Points are whole thousandths of a point everywhere; they become decimals only in what people read.
using Millipoints = std::int64_t;

/// How far a value may lie from the expected one. A value is right if it satisfies any bound that is given.
struct Tolerance {
    std::optional<double> absolute;
    std::optional<double> relative;   ///< of the expected value (of the largest entry of a vector or matrix)
    std::optional<double> ulps;       ///< units in the last place of the expected value as a float
    std::optional<double> band_ulps;  ///< rows whose trusted column "<value>.margin" is smaller do not count
};

/// What a check compares with what.
enum class JudgeKind { numbers, matrices, buffer, image, fragments, trace, events, cost, noise };

/// All of them, in the order in which messages list them.
inline constexpr std::array all_judges{JudgeKind::numbers, JudgeKind::matrices, JudgeKind::buffer, JudgeKind::image, JudgeKind::fragments,
                                       JudgeKind::trace,   JudgeKind::events,   JudgeKind::cost,   JudgeKind::noise};

/// Checks of noise in all units of a course, among which the chance to fail correct work is shared out (judge/error_budget.hpp). A fixed
/// number, more than a course has: the same work gets the same verdict whether it is graded alone or with others, and a budget for 100
/// instead of 10 costs half a standard deviation.
inline constexpr int most_noise_checks = 100;

/// What a trace of OpenGL calls can be held to; grader/judge/trace.cpp says how each is counted.
inline constexpr std::array<std::string_view, 7> trace_rules{"draw calls",      "vertices",         "uploaded bytes", "objects created",
                                                             "objects deleted", "deprecated calls", "state changes"};

/// One observation of one case, and what it is worth.
struct Check {
    std::string name;       ///< "case/value"
    std::string case_name;  ///< the driver's case
    std::string value;      ///< the name recorded in it
    JudgeKind judge = JudgeKind::numbers;
    Millipoints points = 0;
    bool hard = false;    ///< judged against the oracle
    bool hidden = false;  ///< its seed is secret, and students' reports show a verdict without values
    bool pairs = false;   ///< rows 2k and 2k+1 count only together
    Tolerance tolerance;
    double full = 1.0;               ///< the fraction right that earns all points
    double zero = 0.0;               ///< the fraction right that earns none; raised to the best control's
    double range_low = 0;            ///< images and noise of floats: the value shown black …
    double range_high = 1;           ///< … and the value shown white
    std::vector<std::string> rules;  ///< traces: what is counted against the reference, as "draw calls"
    double growth = 1;               ///< costs: the largest exponent of the size with which the count may grow
    std::string why;                 ///< where the tolerance comes from

    /// What is expected follows from another value of the student's own run.
    std::optional<Relation> relation{};
};

/// Limits of one case.
struct Limits {
    double wall_seconds = 5;
    int memory_mib = 512;
};

/// A unit as its folder describes it.
struct Exercise {
    std::string id;  ///< "topic/unit"
    std::string topic;
    std::string name;
    std::filesystem::path folder;
    std::vector<std::string> files;  ///< what the student hands in
    Millipoints points = 0;
    std::vector<std::string> uses;             ///< reference units that the student may call
    std::vector<std::string> forbid;           ///< what must not be used: names and patterns ("glm::rotate*"), families ("@transforms")
    std::map<std::string, std::string> title;  ///< by language: "en", "es"
    std::vector<std::string> course;
    std::optional<double> order;  ///< place within the topic; units without one come last
    bool gl = false;              ///< its cases need an OpenGL context
    bool gl_calls = false;        ///< … and the student's own code calls OpenGL
    bool glfw = false;            ///< its cases are driven through GLFW's functions, without a window
    Limits limits;
    std::vector<Check> checks;
    std::string digest;  ///< SHA-256 of what decides the score in the unit's folder: manifest, driver, headers that it may include, stubs

    /// Is the unit written in C++ (and not in GLSL only)?
    [[nodiscard]] bool is_cpp() const;
    /// Is a check about how the work grows? Then all tenants are built so that their basic blocks are counted.
    [[nodiscard]] bool counts_cost() const;
    /// Is a check judged against an oracle?
    [[nodiscard]] bool has_oracle() const;
    /// Names of the cases that the checks need, in the manifest's order, each once.
    [[nodiscard]] std::vector<std::string> cases() const;
};

/// Reads `folder/exercise.json`; the folder's last two names must be the unit's id, and driver and stubs must lie in it.
/// Throws std::runtime_error that names the file, the field, what was expected and what came.
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

/// All units below `root` (topic/unit/exercise.json), sorted by topic in the course's order (other topics behind, by name), then `order`, then
/// id. A unit that cannot be loaded keeps no other from being loaded. Throws std::runtime_error if `root` is no folder that can be read, and
/// if the units have more than most_noise_checks checks of noise.
[[nodiscard]] Units load_units(const std::filesystem::path& root);

[[nodiscard]] const char* to_string(JudgeKind kind);

}
