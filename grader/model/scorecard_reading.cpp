#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/scorecard.hpp"
#include "text/field.hpp"

namespace umbral::grader {
namespace {

// What one unit may hold: far above what the grader's own caps let in, so that only damage goes beyond.
constexpr std::size_t most_bytes = std::size_t{16} << 20U;
constexpr std::size_t most_items = 100000;
constexpr double largest = std::numeric_limits<double>::max();

std::string text(const Field& field) { return field.any_text(most_bytes); }

Millipoints points(const Field& field, Millipoints most = std::numeric_limits<int>::max())
{
    return field.integer(0, static_cast<int>(most));
}

double number_or_nan(const Field& field)
{
    return field.is_null() ? std::numeric_limits<double>::quiet_NaN() : field.number(-largest, largest);
}

std::optional<double> number_if_any(const Field& field)
{
    return field.is_null() ? std::nullopt : std::optional(field.number(-largest, largest));
}

std::uint64_t seed(const Field& field)
{
    const std::string digits = field.text(20);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || (digits.size() > 1 && digits.front() == '0'))
        field.refuse("a seed in decimal digits");
    return value;
}

JudgeKind kind(const Field& field)
{
    std::string name = field.text(32);
    if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos) field.refuse("the name of a judge");
    return {std::move(name)};
}

/// What a text names; refused where it names nothing of that kind.
template <class Read>
auto named(const Field& field, Read&& read, const std::string& expected)
{
    try {
        return read(field.text(32));
    } catch (const std::invalid_argument&) {
        field.refuse(expected);
    }
}

std::optional<Difference> difference(const Field& field)
{
    if (field.is_null()) return std::nullopt;
    field.allow_only({"where", "yours", "expected", "row", "question"});
    Difference result{text(field.member("where")), text(field.member("yours")), text(field.member("expected"))};
    if (const Field row = field.member("row"); row.given())
        result.cell = static_cast<std::size_t>(row.integer(0, std::numeric_limits<int>::max()));
    if (const Field question = field.member("question"); question.given()) result.question = text(question);
    return result;
}

CodePlace code_place(const Field& field)
{
    constexpr int most = std::numeric_limits<int>::max();
    field.allow_only({"file", "line", "column", "text", "sentence"});
    CodePlace result{text(field.member("file")), static_cast<int>(field.member("line").integer(1, most)), 0,
                     text(field.member("text")), text(field.member("sentence"))};
    if (const Field column = field.member("column"); column.given())
        result.column = static_cast<int>(column.integer(1, most));
    return result;
}

CheckResult check(const Field& field)
{
    field.allow_only({"name",       "kind",          "hard",
                      "hidden",     "unjudged",      "score",
                      "max_score",  "error",         "reference_error",
                      "message",    "metrics",       "first_difference",
                      "common",     "common_tells",  "held_back",
                      "beside",     "simplest",      "about",
                      "headline",   "sketch",        "artefacts",
                      "seeds",      "practice",      "practice_example",
                      "code_place", "last_question", "depends"});
    CheckResult result;
    result.name = text(field.member("name"));
    result.kind = kind(field.member("kind"));
    result.hard = field.member("hard").boolean();
    result.hidden = field.member("hidden").boolean();
    if (const Field kept = field.member("unjudged"); kept.given())
        result.unjudged = named(kept, unjudged_from, "what kept a check from being judged");
    result.max_score = points(field.member("max_score"));
    result.score = points(field.member("score"), result.max_score);
    result.error = number_if_any(field.member("error"));
    result.reference_error = number_if_any(field.member("reference_error"));
    result.message = text(field.member("message"));
    const Field metrics = field.member("metrics");
    for (const std::string& name : metrics.names()) result.metrics[name] = number_or_nan(metrics.member(name));
    result.first_difference = difference(field.member("first_difference"));
    if (const Field last = field.member("last_question"); last.given()) result.last_question = text(last);
    if (const Field simplest = field.member("simplest"); simplest.given()) result.simplest = difference(simplest);
    if (const Field common = field.member("common"); common.given()) result.common = text(common);
    if (const Field tells = field.member("common_tells"); tells.given())
        result.common_tells = named(tells, common_tells_from, "what wrong answers share");
    if (const Field depends = field.member("depends"); depends.given()) result.depends = text(depends);
    if (const Field place = field.member("code_place"); place.given()) result.code_place = code_place(place);
    if (const Field practice = field.member("practice"); practice.given()) result.practice = text(practice);
    if (const Field example = field.member("practice_example"); example.given())
        result.practice_example = difference(example);
    if (const Field held = field.member("held_back"); held.given()) result.held_back = held.boolean();
    if (const Field beside = field.member("beside"); beside.given()) result.beside = beside.boolean();
    if (const Field about = field.member("about"); about.given()) result.about = text(about);
    if (const Field headline = field.member("headline"); headline.given()) result.headline = text(headline);
    if (const Field sketch = field.member("sketch"); sketch.given()) result.sketch = text(sketch);
    const Field artefacts = field.member("artefacts");
    for (const std::string& name : artefacts.names()) result.artefacts[name] = text(artefacts.member(name));
    if (const Field seeds = field.member("seeds"); seeds.given())
        for (const Field& one : seeds.items(1, 2)) result.seeds.push_back(seed(one));
    return result;
}

Explanation explanation(const Field& field)
{
    field.allow_only({"name", "sentence", "confidence", "ambiguous", "hidden"});
    Explanation result;
    result.name = text(field.member("name"));
    result.sentence = text(field.member("sentence"));
    result.confidence = number_or_nan(field.member("confidence"));
    if (const Field ambiguous = field.member("ambiguous"); ambiguous.given()) result.ambiguous = ambiguous.boolean();
    if (const Field hidden = field.member("hidden"); hidden.given()) result.hidden = hidden.boolean();
    return result;
}

RubricScore rubric_score(const Field& field)
{
    field.allow_only({"words", "score", "max_score"});
    const Millipoints most = points(field.member("max_score"));
    return {text(field.member("words")), points(field.member("score"), most), most};
}

}

UnitResult unit_result_from_json(const nlohmann::json& json, const std::string& where)
{
    const Field field(json, where);
    field.allow_only({"id", "digest", "verdict", "score", "max_score", "seconds", "reference_seconds", "checks",
                      "message", "explanation", "stdout", "seed", "unscored", "rubric", "curve"});
    UnitResult result;
    result.id = text(field.member("id"));
    result.digest = text(field.member("digest"));
    result.verdict = named(field.member("verdict"), verdict_from, "the name of a verdict");
    result.max_score = points(field.member("max_score"));
    result.score = points(field.member("score"), result.max_score);
    result.seconds = number_or_nan(field.member("seconds"));
    result.reference_seconds = number_or_nan(field.member("reference_seconds"));
    for (const Field& one : field.member("checks").items(0, most_items)) result.checks.push_back(check(one));
    if (const Field rubric = field.member("rubric"); rubric.given())
        for (const Field& one : rubric.items(1, most_items)) result.rubric.push_back(rubric_score(one));
    result.message = text(field.member("message"));
    for (const Field& one : field.member("explanation").items(0, most_items))
        result.explanations.push_back(explanation(one));
    result.output = text(field.member("stdout"));
    result.seed = seed(field.member("seed"));
    if (const Field curve = field.member("curve"); curve.given()) result.curve = curve_from_json(curve);
    if (const Field unscored = field.member("unscored"); unscored.given()) result.unscored = points(unscored);
    return result;
}

}
