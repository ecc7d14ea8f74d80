#include "report/told_reasons.hpp"

#include <algorithm>

#include "report/hidden.hpp"
#include "report/reasons.hpp"

namespace umbral::grader {
namespace {

/// Does the reason that is given say the same of wrong answers: that they are so many times the right ones, or negated?
bool is_told(CommonTells tells, std::span<const Explanation> reasons)
{
    const auto given = [&](std::string_view name) {
        return std::ranges::find(reasons, name, &Explanation::name) != reasons.end();
    };
    return (tells == CommonTells::multiple && given("scaled")) || (tells == CommonTells::opposite && given("negated"));
}

}

void add_pattern(Block& block, const UnitResult& unit, const std::vector<const CheckResult*>& failing)
{
    if (failing.empty()) return;
    const bool explained = !main_reasons(unit).empty();
    const CheckResult& shown = *failing.front();
    const bool vague = shown.common.empty() || is_vague(shown.common_tells);
    if (!shown.common.empty() && !(vague && explained) && !is_told(shown.common_tells, main_reasons(unit)))
        block.sentence("pattern", shown.common);
    const auto depending =
        std::ranges::find_if(failing, [](const CheckResult* check) { return !check->depends.empty(); });
    if (!explained && depending != failing.end())
        block.sentence("depends",
                       (*depending == &shown ? "" : "in " + (*depending)->name + ": ") + (*depending)->depends);
    if (explained || !vague) return;
    auto telling = std::ranges::find_if(failing, [&](const CheckResult* check) {
        return check != &shown && !check->common.empty() && !is_vague(check->common_tells);
    });
    if (telling == failing.end() && shown.common.empty())
        telling = std::ranges::find(failing, CommonTells::one_sided, &CheckResult::common_tells);
    if (telling != failing.end())
        block.sentence(shown.common.empty() ? "pattern" : "",
                       fmt::format("in {}: {}", (*telling)->name, (*telling)->common));
}

void add_code_place(Block& block, const UnitResult& unit, const CheckResult* shown, const Paint& paint)
{
    const auto known =
        std::ranges::find_if(unit.checks, [](const CheckResult& one) { return one.code_place.has_value(); });
    if (known == unit.checks.end()) return;
    const CodePlace& place = *known->code_place;
    const std::string of_check = known->hidden      ? "on practice inputs, "
                                 : &*known == shown ? ""
                                                    : fmt::format("in {}, ", known->name);
    block.sentence("code", fmt::format("{}:{}", place.file, place.line));
    const std::string text = paint.safe(place.text);
    block.labelled("", {"  " + shorten(text, block.room() - 2, paint.ellipsis())});
    if (display_width(text) + 2 <= block.room() && place.column > 1) {
        const std::string before =
            paint.safe(std::string_view(place.text).substr(0, static_cast<std::size_t>(place.column) - 1));
        block.labelled(
            "", {std::string(static_cast<std::size_t>(display_width(before)) + 2, ' ') + paint(Tone::quiet, "^")});
    }
    block.sentence("", of_check + place.sentence);
}

void add_reasons(Block& block, const UnitResult& unit)
{
    const char* label = "why";
    for (std::string sentence : reason_sentences(unit.explanations)) {
        // Hints are written in Markdown.
        for (std::size_t at = 0; (at = sentence.find("**", at)) != std::string::npos;) sentence.erase(at, 2);
        block.sentence(label, sentence);
        label = "";
    }
}

}
