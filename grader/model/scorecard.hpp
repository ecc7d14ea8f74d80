#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// One value of the student's beside the expected one, ready to print.
struct Difference {
    std::string where;  ///< "row 17", "pixel (120, 33)", "entry (0, 3)"
    std::string yours;
    std::string expected;
};

/// What a check found.
struct CheckResult {
    std::string name;
    JudgeKind kind = JudgeKind::numbers;
    bool hard = false;
    bool hidden = false;
    Millipoints score = 0;
    Millipoints max_score = 0;
    std::optional<double> error;            ///< the worst, in the unit of its tolerance; empty if not finite
    std::optional<double> reference_error;  ///< the reference's own against the oracle, where there is one
    std::string message;                    ///< one line; empty if nothing is to say
    std::map<std::string, double> metrics;  ///< finite numbers only
    std::optional<Difference> first_difference;
    std::string sketch{};                          ///< lines of ASCII: what the first bad place looks like; empty where there is nothing to draw
    std::map<std::string, std::string> artefacts;  ///< "triptych" to a path below the report; not in class.json
    std::vector<std::uint64_t> seeds{};            ///< noise: of its case, and the fresh one if it was run again; not in class.json
};

/// Why a result fails, as far as it could be recognised.
struct Explanation {
    std::string name;        ///< "transposed", "mistake: school_formula"
    std::string sentence;    ///< for the student
    double confidence = 0;   ///< how sure it is, 0..1: grader/judge/sureness.hpp says how that is measured
    double fit = 0;          ///< the share that speaks for it of the checks that say anything; in no file
    bool ambiguous = false;  ///< another one matches as well: it is one of these
};

struct UnitResult {
    std::string id;
    std::string digest;
    Verdict verdict = Verdict::grader_fault;
    Millipoints score = 0;
    Millipoints max_score = 0;
    double seconds = 0;            ///< of the student's cases, wall clock
    double reference_seconds = 0;  ///< of the reference's
    std::vector<CheckResult> checks;
    std::string message;                    ///< why there is no better verdict: diagnostics, crash text, refused calls
    std::vector<Explanation> explanations;  ///< best first
    std::string output;                     ///< what the student's code printed, bounded
    std::uint64_t seed = 0;                 ///< of the visible cases
};

struct SubmissionResult {
    std::string id;
    Millipoints score = 0;
    Millipoints max_score = 0;
    std::vector<UnitResult> units;
};

/// What a result depends on beside the submission: shown in every report.
struct Fingerprint {
    std::string version;
    std::string commit;
    std::string cpu;
    std::string compiler;
    std::string gl;
    std::string libm;
    std::vector<std::string> protections;  ///< active ones, as "landlock 4"
};

struct ClassResult {
    Fingerprint fingerprint;
    std::vector<SubmissionResult> submissions;
};

/// Sums the units' points into the submission's. A unit with a grader fault is in neither sum: our fault is nobody's zero.
void add_up(SubmissionResult& submission);

/// class.json and report.json as docs/schemas describe them. Times are the only fields that differ between equal runs.
[[nodiscard]] nlohmann::json to_json(const ClassResult& result);
[[nodiscard]] nlohmann::json to_json(const SubmissionResult& result, const Fingerprint& fingerprint);

}
