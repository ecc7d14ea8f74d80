#include "model/scorecard.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/faults.hpp"
#include "model/recording.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

// Texts may hold what a student printed or named: only here do they enter JSON, which must be UTF-8.
std::string text(std::string_view value) { return printable(value, std::numeric_limits<std::size_t>::max()); }

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json number(const std::optional<double>& value) { return value ? number(*value) : json(nullptr); }

template <class Items, class Convert>
json list(const Items& items, Convert&& convert)
{
    json result = json::array();
    for (const auto& item : items) result.push_back(convert(item));
    return result;
}

template <class Values, class Convert>
json object(const Values& values, Convert&& convert)
{
    json result = json::object();
    for (const auto& [key, value] : values) result[text(key)] = convert(value);
    return result;
}

json difference(const std::optional<Difference>& value)
{
    if (!value) return nullptr;
    json result{{"where", text(value->where)}, {"yours", text(value->yours)}, {"expected", text(value->expected)}};
    if (value->cell) result["row"] = *value->cell;
    if (!value->question.empty()) result["question"] = text(value->question);
    return result;
}

json code_place(const CodePlace& value)
{
    json result{{"file", text(value.file)},
                {"line", value.line},
                {"text", text(value.text)},
                {"sentence", text(value.sentence)}};
    if (value.column > 0) result["column"] = value.column;
    return result;
}

/// What a student's own report shows beyond the class's.
enum class Detail { for_class, for_report };

json check(const CheckResult& value, Detail detail)
{
    json result{{"name", text(value.name)},
                {"kind", to_string(value.kind)},
                {"hard", value.hard},
                {"hidden", value.hidden},
                {"score", value.score},
                {"max_score", value.max_score},
                {"error", number(value.error)},
                {"reference_error", number(value.reference_error)},
                {"message", text(value.message)},
                {"metrics", object(value.metrics, [](double metric) { return number(metric); })},
                {"first_difference", difference(value.first_difference)}};
    if (value.unjudged != Unjudged::no) result["unjudged"] = to_string(value.unjudged);
    if (!value.last_question.empty()) result["last_question"] = text(value.last_question);
    if (value.simplest) result["simplest"] = difference(value.simplest);
    if (!value.common.empty()) result["common"] = text(value.common);
    if (value.common_tells != CommonTells::other) result["common_tells"] = to_string(value.common_tells);
    if (!value.depends.empty()) result["depends"] = text(value.depends);
    if (value.code_place) result["code_place"] = code_place(*value.code_place);
    if (!value.practice.empty()) result["practice"] = text(value.practice);
    if (value.practice_example) result["practice_example"] = difference(value.practice_example);
    if (value.held_back) result["held_back"] = true;
    if (value.beside) result["beside"] = true;
    if (!value.about.empty()) result["about"] = text(value.about);
    if (!value.headline.empty()) result["headline"] = text(value.headline);
    if (!value.sketch.empty()) result["sketch"] = text(value.sketch);
    if (detail == Detail::for_report && !value.seeds.empty())
        result["seeds"] = list(value.seeds, [](std::uint64_t seed) { return std::to_string(seed); });
    if (detail == Detail::for_report)
        result["artefacts"] = object(value.artefacts, [](const std::string& path) { return text(path); });
    return result;
}

json explanation(const Explanation& value)
{
    json result{
        {"name", text(value.name)}, {"sentence", text(value.sentence)}, {"confidence", number(value.confidence)}};
    if (value.ambiguous) result["ambiguous"] = true;
    if (value.hidden) result["hidden"] = true;
    return result;
}

json rubric_score(const RubricScore& value)
{
    return {{"words", text(value.words)}, {"score", value.score}, {"max_score", value.max_score}};
}

json unit(const UnitResult& value, Detail detail)
{
    json result{{"id", text(value.id)},
                {"digest", text(value.digest)},
                {"verdict", to_string(value.verdict)},
                {"score", value.score},
                {"max_score", value.max_score},
                {"seconds", number(value.seconds)},
                {"reference_seconds", number(value.reference_seconds)},
                {"checks", list(value.checks, [&](const CheckResult& item) { return check(item, detail); })},
                {"message", text(value.message)},
                {"explanation", list(value.explanations, explanation)},
                {"stdout", text(value.output)}};
    if (!value.rubric.empty()) result["rubric"] = list(value.rubric, rubric_score);
    if (detail == Detail::for_report && value.curve) result["curve"] = to_json(*value.curve);
    if (value.unscored != 0) result["unscored"] = value.unscored;
    // As text: readers that hold numbers in a double would round a 64-bit seed.
    if (detail == Detail::for_report) result["seed"] = std::to_string(value.seed);
    return result;
}

json submission(const SubmissionResult& value, Detail detail)
{
    json result{{"id", text(value.id)},
                {"score", value.score},
                {"max_score", value.max_score},
                {"units", list(value.units, [&](const UnitResult& item) { return unit(item, detail); })}};
    if (!value.folder.empty()) result["folder"] = text(value.folder);
    return result;
}

json fault(const Fault& value)
{
    const auto place = [](const Fault::Place& one) {
        return json{{"submission", text(one.submission)}, {"unit", text(one.unit)}};
    };
    return {{"cause", text(value.cause)},
            {"remedy", text(value.remedy)},
            {"points", value.points},
            {"units", list(value.places, place)}};
}

json left_out(const LeftOut& value) { return {{"unit", value.unit}, {"submissions", list(value.submissions, text)}}; }

json document(const char* format, const Fingerprint& fingerprint)
{
    return {{"format", format},
            {"version", 1},
            {"score_unit", "millipoints"},
            {"tool", {{"version", text(fingerprint.version)}, {"commit", text(fingerprint.commit)}}},
            {"machine",
             {{"cpu", text(fingerprint.cpu)},
              {"compiler", text(fingerprint.compiler)},
              {"gl", text(fingerprint.gl)},
              {"libm", text(fingerprint.libm)},
              {"protections", list(fingerprint.protections, text)}}}};
}

}

void add_up(SubmissionResult& submission)
{
    submission.score = 0;
    submission.max_score = 0;
    for (const UnitResult& unit : submission.units) {
        if (unit.verdict == Verdict::grader_fault) continue;
        submission.score += unit.score;
        submission.max_score += unit.max_score;
    }
}

json to_json(const UnitResult& value) { return unit(value, Detail::for_report); }

json to_json(const ClassResult& result)
{
    json root = document("umbral-class", result.fingerprint);
    root["course"] = text(result.grading.course);
    root["attempt"] = result.grading.attempt;
    root["secret"] = text(result.grading.secret);
    root["faults"] = list(faults(result), fault);
    root["unfinished"] = list(result.unfinished, text);
    root["elsewhere"] = list(result.elsewhere, text);
    root["left_out"] = list(result.left_out, left_out);
    root["submissions"] =
        list(result.submissions, [](const SubmissionResult& item) { return submission(item, Detail::for_class); });
    return root;
}

json to_json(const SubmissionResult& result, const Fingerprint& fingerprint)
{
    json root = document("umbral-report", fingerprint);
    root["submission"] = submission(result, Detail::for_report);
    return root;
}

}
