#pragma once

#include <any>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
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

/// The name of a judge, as manifests and reports write it: "numbers". Which there are, and all that is particular to
/// one, stands in grader/judge/<name>; grader/judge/judges.hpp lists them.
struct JudgeKind {
    std::string name;

    friend auto operator<=>(const JudgeKind&, const JudgeKind&) = default;
};
[[nodiscard]] inline const std::string& to_string(const JudgeKind& kind) noexcept { return kind.name; }

/// One observation of one case, and what it is worth.
struct Check {
    std::string name;       ///< "case/value"
    std::string case_name;  ///< the driver's case
    std::string value;      ///< the name recorded in it
    JudgeKind judge;
    Millipoints points = 0;
    bool hard = false;    ///< judged against the oracle
    bool hidden = false;  ///< its seed is secret, and students' reports show a verdict without values
    bool pairs = false;   ///< rows 2k and 2k+1 count only together
    Tolerance tolerance;
    double full = 1.0;            ///< the fraction right that earns all points
    double zero = 0.0;            ///< the fraction right that earns none; raised to the best control's
    double range_low = 0;         ///< pictures of floats: the value shown black …
    double range_high = 1;        ///< … and the value shown white
    std::string why;              ///< where the tolerance comes from
    std::string about{};          ///< what the unit's statement says that it looks at; empty if it says nothing
    std::string with{};           ///< the check that this one's points hang on: it earns no larger share
    std::size_t rubric_line = 0;  ///< of the unit's rubric, from 0 on
    std::any own;                 ///< what only this judge takes: a plain struct of its folder (parameters_of)

    /// What is expected follows from another value of the student's own run.
    std::optional<Relation> relation{};
};

/// Which knob of `umbral bench accuracy` the unit turns, and where its error and its time are seen. Both cases are
/// visible ones.
struct UnitKnob {
    std::string name;       ///< "ray-sphere"
    std::string check;      ///< whose error is taken: "far away/t"
    std::string case_name;  ///< whose time is taken: "picture"

    friend bool operator==(const UnitKnob&, const UnitKnob&) = default;
};

/// A line of the rubric by which a course marks a unit.
struct RubricLine {
    std::string words;  ///< as the course puts them
    Millipoints points = 0;
};

/// Limits of one case.
struct Limits {
    double wall_seconds = 5;
    int memory_mib = 512;
};

/// The limits for a run that takes about `seconds`, if it ends at all: a second and eight times that, which busy
/// machines need, and no more than `limits`. For what is tried many times, and of which nobody knows whether it ends.
[[nodiscard]] Limits limits_for(Limits limits, double seconds);

/// A unit as its folder describes it.
struct Exercise {
    std::string id;  ///< "topic/unit"
    std::string topic;
    std::string name;
    std::filesystem::path folder;
    std::vector<std::string> files;  ///< what the student hands in
    std::vector<std::string>
        interfaces;  ///< headers of the framework that the stubs include, in their order: "umbral/core/ray.hpp"
    Millipoints points = 0;
    std::vector<std::string> uses;             ///< reference units that the student may call
    std::vector<std::string> used_interfaces;  ///< headers that their stubs include
    std::vector<std::string>
        forbid;  ///< what must not be used: names and patterns ("glm::rotate*"), families ("@transforms")
    std::map<std::string, std::string> title;  ///< by language: "en", "es"
    std::vector<std::string> course;
    std::optional<double> order;  ///< place within the topic; units without one come last
    bool gl = false;              ///< its cases need an OpenGL context
    bool gl_calls = false;        ///< … and the student's own code calls OpenGL
    bool glfw = false;            ///< its cases are driven through GLFW's functions, without a window
    bool counts_work =
        false;  ///< a check is about how the work grows: all solutions are built so that their basic blocks are counted
    Limits limits;
    std::vector<Check> checks;
    std::vector<RubricLine> rubric;  ///< empty, or each check belongs to a line and each line's checks sum up to it
    std::optional<UnitKnob> knob;    ///< reports show where on its curve a student's choice lies
    std::string digest;              ///< SHA-256 of what decides the score: manifest/unit_digest.hpp

    /// Is the unit written in C++ (and not in GLSL only)?
    [[nodiscard]] bool is_cpp() const;
    /// Is a check judged against an oracle?
    [[nodiscard]] bool has_oracle() const;
    /// Names of the cases that the checks need, in the manifest's order, each once.
    [[nodiscard]] std::vector<std::string> cases() const;
};

/// Titles in English, by unit; units without one are left out.
[[nodiscard]] std::map<std::string, std::string> english_titles(std::span<const Exercise> exercises);

/// In a unit's folder of a package that lacks the sources of driver and answers: what was read of them when the package
/// was made.
inline constexpr const char* packaged_file = "packaged.json";

}
