#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/common_tells.hpp"
#include "model/curve.hpp"
#include "model/exercise.hpp"
#include "model/unjudged.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// One value of the student's beside the expected one, ready to print.
struct Difference {
    std::string where;  ///< "row 17", "pixel (120, 33)", "entry (0, 3)"
    std::string yours;
    std::string expected;
    std::optional<std::size_t> cell{};  ///< of the expected recording, row by row, where it has one
    std::string question{};             ///< what was asked there, as code; empty where that is not known
    std::vector<std::size_t> others{};  ///< further cells that it may as well belong to; in no file
};

/// A line of the student's own file that wrong answers come through, and right ones do not, or the reverse.
struct CodePlace {
    std::string file;
    int line = 0;          ///< counted from 1
    int column = 0;        ///< of what runs there in `text`, in bytes, counted from 1; 0 where nothing says it
    std::string text;      ///< the line, without what it is indented by
    std::string sentence;  ///< "all 41 calls with wrong answers come through here, and none of the 359 with right ones"
};

/// What a check found.
struct CheckResult {
    std::string name;
    JudgeKind kind;
    bool hard = false;
    bool hidden = false;
    Unjudged unjudged = Unjudged::no;
    Millipoints score = 0;
    Millipoints max_score = 0;
    std::optional<double> error;            ///< the worst, in the unit of its tolerance; empty if not finite
    std::optional<double> reference_error;  ///< the reference's own against the oracle, where there is one
    std::string message;                    ///< one line; empty if nothing is to say
    std::string about{};                    ///< what it looks at, in the statement's words; empty if that says nothing
    std::string headline{};  ///< the message up to its values, for where these are shown anyway; or empty
    std::map<std::string, double> metrics;  ///< finite numbers only
    std::optional<Difference> first_difference;
    std::string last_question{};  ///< in which the check's case crashed or did not end, as code; empty where it did not
    std::string common{};  ///< "wrong wherever …": what all questions with wrong answers share; empty if nothing does
    CommonTells common_tells = CommonTells::other;
    std::string depends{};  ///< what wrong answers depend on and should not, or the reverse; of a hidden check with
                            ///< practice inputs
    std::optional<CodePlace> code_place{};  ///< of a hidden check, with practice inputs
    std::string practice{};  ///< as `common`, of a hidden check, about inputs that are not graded and the same for all
    std::optional<Difference> practice_example{};  ///< of a hidden check, the first wrong value with such inputs
    std::uint64_t practice_seed = 0;               ///< of its inputs; in no file
    bool told_by_question = false;  ///< of `common` or `practice`: numbers of a question part wrong answers from right
                                    ///< ones; in no file
    bool held_back = false;         ///< right by itself; it earned less for what it hangs on (Check::with)
    bool beside = false;  ///< right where the case is asked alone, and wrong only with other questions in between
    std::optional<Difference> simplest{};  ///< a wrong value with a question that is simpler than the first one's;
                                           ///< `where` says which of its numbers, or nothing
    std::string
        sketch{};  ///< lines of ASCII: what the first bad place looks like; empty where there is nothing to draw
    std::map<std::string, std::string>
        artefacts;  ///< "triptych", practice_picture to paths below the report; not in class.json
    std::vector<std::uint64_t>
        seeds{};  ///< judged by chance: of its case, and the fresh one if it was run again; not in class.json
    bool borderline = false;  ///< to be run again with a fresh seed; in no file
};

/// The artefact that students may see of a hidden check: a triptych of practice inputs.
inline constexpr const char* practice_picture = "practice";

/// Why a result fails, as far as it could be recognised.
struct Explanation {
    std::string name;        ///< "transposed", "mistake: school_formula"
    std::string sentence;    ///< for the student
    double confidence = 0;   ///< how sure it is, 0..1: grader/judge/confidence.hpp says how that is measured
    double fit = 0;          ///< the share that speaks for it of the checks that say anything; in no file
    bool ambiguous = false;  ///< another one matches as well: it is one of these
    bool hidden = false;     ///< only hidden cases lead to it: not for students
};

/// What the checks of one line of a unit's rubric earned together.
struct RubricScore {
    std::string words;
    Millipoints score = 0;
    Millipoints max_score = 0;
};

/// Has the check lost points?
[[nodiscard]] inline bool fails(const CheckResult& check) { return check.score < check.max_score; }

struct UnitResult {
    std::string id;
    std::string digest;
    Verdict verdict = Verdict::grader_fault;
    Millipoints score = 0;
    Millipoints max_score = 0;
    double seconds = 0;            ///< of the student's cases, wall clock
    double reference_seconds = 0;  ///< of the reference's
    std::vector<CheckResult> checks;
    std::vector<RubricScore> rubric{};      ///< of a unit that has one; empty for a grader fault
    std::string message;                    ///< why there is no better verdict: diagnostics, crash text, refused calls
    std::vector<Explanation> explanations;  ///< best first
    std::string output;                     ///< what the student's code printed, bounded
    std::uint64_t seed = 0;                 ///< of the visible cases
    /// Would it come out so again? Not where a compiler or a run ended for want of time or memory that a machine under
    /// load may have taken: such a result is shown, and asked for again the next time. In no file.
    bool settled = true;
    std::optional<UnitCurve>
        curve{};               ///< of a unit with a knob, where the student's place on it is known; not in class.json
    Millipoints unscored = 0;  ///< of a grader fault: the points that are in no sum because of it
};

struct SubmissionResult {
    std::string id;
    Millipoints score = 0;
    Millipoints max_score = 0;
    std::vector<UnitResult> units;
    std::string folder{};  ///< how the submission was called where it came from; empty if that is its id
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

/// What hidden inputs follow from beside the student: results of different gradings do not belong into one table.
struct Grading {
    std::string course;
    unsigned attempt = 0;
    std::string secret;  ///< secret_fingerprint() of it

    friend bool operator==(const Grading&, const Grading&) = default;
};

/// A submission whose reports could not be written.
struct Unwritten {
    std::string submission;
    std::string cause;
};

/// A unit that is not graded, since so few submissions have files of it that it seems not to be the class's task.
struct LeftOut {
    std::string unit;
    std::vector<std::string> submissions;
};

struct ClassResult {
    Fingerprint fingerprint;
    std::vector<SubmissionResult> submissions;
    Grading grading{};
    std::vector<std::string>
        unfinished{};  ///< ids of submissions that still have to be graded: grading goes on, or was stopped
    std::vector<std::string>
        elsewhere{};  ///< ids with results of an earlier run, by another version of Umbral or on another machine
    std::vector<Unwritten> unwritten{};
    std::vector<LeftOut> left_out{};
};

/// Sums the units' points into the submission's. A unit with a grader fault is in neither sum: our fault is nobody's
/// zero.
void add_up(SubmissionResult& submission);

/// A unit as report.json holds it: with seeds and artefacts.
[[nodiscard]] nlohmann::json to_json(const UnitResult& unit);
/// The same read back: to_json(unit_result_from_json(json, where)) == json for every JSON that to_json made. `fit` of
/// explanations is in no file and becomes 0; a number that was not finite becomes NaN, or nothing where that may be.
/// Throws std::runtime_error, which begins with `where` and names the field, for anything that to_json does not write.
[[nodiscard]] UnitResult unit_result_from_json(const nlohmann::json& json, const std::string& where);

/// class.json and report.json as docs/schemas describe them. Times are the only fields that differ between equal runs.
[[nodiscard]] nlohmann::json to_json(const ClassResult& result);
[[nodiscard]] nlohmann::json to_json(const SubmissionResult& result, const Fingerprint& fingerprint);

}
