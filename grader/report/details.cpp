#include "report/details.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/block.hpp"
#include "report/check_words.hpp"
#include "report/failing_order.hpp"
#include "report/hidden.hpp"
#include "report/layout.hpp"
#include "report/next_steps.hpp"
#include "report/reasons.hpp"
#include "report/side_by_side.hpp"
#include "report/told_reasons.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_lines = 12;
constexpr std::size_t most_bytes = 4096;

std::string words_and_points(const CheckResult& check)
{
    return fmt::format("{}, {} of {} points", check_words(check), points_text(check.score),
                       points_text(check.max_score));
}

/// The student's text, at most most_lines lines, each of at most `width` cells; says how much is left out.
std::vector<std::string> excerpt(std::string_view text, int width, const Paint& paint)
{
    std::size_t size = std::min(text.size(), most_bytes);
    while (size < text.size() && size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
    std::vector<std::string> lines = wrap(paint.safe_lines(text.substr(0, size)), width);
    const bool too_many = lines.size() > most_lines;
    if (too_many) lines.resize(most_lines);
    if (too_many || size < text.size())
        lines.push_back(fmt::format("{} ({} bytes in all; the beginning is shown)", paint.ellipsis(), text.size()));
    return lines;
}

/// Code in its own lines; those that are too long go on in the next, farther in.
std::vector<std::string> code_lines(std::string_view code, int width, const Paint& paint)
{
    constexpr int indent = 2;
    constexpr std::size_t most = 24;
    constexpr std::size_t most_first = 4;  ///< of more than that, and the last ones, which led to the answer
    std::vector<std::string> written;
    for (std::size_t place = 0; place < code.size(); place = std::min(code.find('\n', place), code.size()) + 1)
        written.emplace_back(code.substr(place, code.find('\n', place) - place));
    if (const std::size_t all = written.size(); all > most) {
        const auto left_out = static_cast<std::ptrdiff_t>(all - most + 1);
        written.erase(written.begin() + most_first, written.begin() + most_first + left_out);
        written.insert(written.begin() + most_first, fmt::format("// … {} lines left out", left_out));
    }
    std::vector<std::string> lines;
    for (const std::string& line : written) {
        const std::vector<std::string> pieces = wrap(paint.safe(line), width - indent);
        for (std::size_t i = 0; i < pieces.size(); ++i)
            lines.push_back(std::string(i == 0 ? 0 : indent, ' ') + pieces[i]);
    }
    return lines;
}

/// A question that is none of those graded first, and the wrong value that came of it.
void add_other_question(Block& block, std::string_view label, const Difference& wrong, const Paint& paint)
{
    if (!wrong.question.empty()) block.labelled(label, code_lines(wrong.question, block.room(), paint));
    if (!wrong.where.empty()) block.sentence(wrong.question.empty() ? label : "", wrong.where);
    block.labelled("", side_by_side(wrong, block.room(), paint));
}

/// The shortest question in which a visible case crashed or did not end.
void add_last_question(Block& block, const UnitResult& unit, const CheckResult* shown, const Paint& paint)
{
    const CheckResult* told = nullptr;
    for (const CheckResult& check : unit.checks) {
        if (check.hidden || check.last_question.empty()) continue;
        if (told == nullptr || check.last_question.size() < told->last_question.size()) told = &check;
    }
    if (told == nullptr) return;
    if (shown != nullptr && shown->last_question == told->last_question) told = shown;
    block.labelled("ended in", code_lines(told->last_question, block.room(), paint));
    if (told != shown) block.sentence("", fmt::format("(of {})", told->name));
}

/// Does the check's message say at length what stands below it: matrices that are drawn, or long events?
bool repeats_first(const CheckResult& check)
{
    constexpr std::size_t short_values = 40;
    if (!check.first_difference) return false;
    const auto& [where, yours, expected, cell, question, others] = *check.first_difference;
    if (find_matrix(yours)) return true;
    const auto holds = [&](const std::string& text) { return check.message.find(text) != std::string::npos; };
    return yours.size() + expected.size() > short_values && holds(yours) && holds(expected);
}

/// What is observed: "solids" of "two androids/solids".
std::string_view observed_in(const CheckResult& check)
{
    const std::string_view name = check.name;
    return name.substr(std::min(name.rfind('/'), name.size()));
}

/// May what a check looks at be the reason? Not where the same is wrong in cases that look at something else.
bool may_be_reason(const CheckResult& check, const std::vector<const CheckResult*>& failing)
{
    return !check.about.empty() && std::ranges::none_of(failing, [&](const CheckResult* other) {
        return other != &check && !other->held_back && observed_in(*other) == observed_in(check) &&
               other->about != check.about;
    });
}

/// `told` stands above it: what the check only repeats of it is left out. Where no reason is known, what the check
/// looks at may be one: `is_reason`.
void add_first_failing(Block& block, const CheckResult& check, std::string_view told, bool is_reason,
                       const Paint& paint)
{
    const std::string words = words_and_points(check);
    const std::string name = shorten(paint.safe(check.name), block.room() - display_width(words) - 2, paint.ellipsis());
    block.labelled("check", {fmt::format("{}  {}", paint(Tone::strong, name), words)});
    const std::string& message = repeats_first(check) && !check.headline.empty() ? check.headline : check.message;
    if (told.find(message) == std::string_view::npos) block.labelled("", excerpt(message, block.room(), paint));
    if (is_reason) block.sentence("", "Looks at: " + check.about);
    if (check.first_difference) {
        block.sentence("first", check.first_difference->where);
        block.labelled("", side_by_side(*check.first_difference, block.room(), paint));
        if (const std::string& question = check.first_difference->question; !question.empty())
            block.labelled("asked", code_lines(question, block.room(), paint));
    }
    if (check.simplest) add_other_question(block, "simplest", *check.simplest, paint);
    block.labelled("there", wrap(paint.safe_lines(check.sketch), block.room()));
    for (const auto& [kind, path] : check.artefacts)
        block.sentence(shorten(paint.safe(kind), Block::label_width - 2, paint.ellipsis()), path);
}

/// The visible checks that fail: the first is the one to look at.
std::vector<const CheckResult*> failing_checks(const UnitResult& unit)
{
    std::vector<const CheckResult*> failing;
    for (const CheckResult& check : unit.checks)
        if (!check.hidden && fails(check)) failing.push_back(&check);
    std::ranges::stable_sort(failing, {}, failing_order);
    return failing;
}

/// "1.5 / 2  the line's words", for a unit that is marked by a rubric.
void add_rubric(Block& block, const UnitResult& unit)
{
    for (std::size_t i = 0; i < unit.rubric.size(); ++i) {
        const RubricScore& line = unit.rubric[i];
        block.sentence(i == 0 ? "rubric" : "",
                       fmt::format("{} / {}  {}", points_text(line.score), points_text(line.max_score), line.words));
    }
}

void add_others(Block& block, const UnitResult& unit, const std::vector<const CheckResult*>& failing,
                const Paint& paint)
{
    std::vector<std::string> others;
    std::vector<std::string> unmeasured;
    for (std::size_t i = 1; i < failing.size(); ++i)
        if (!failing[i]->held_back)
            (failing[i]->unjudged == Unjudged::wrong_answers ? unmeasured : others).push_back(failing[i]->name);
    std::string also;
    if (!others.empty()) also = fmt::format("{} not right yet", fmt::join(others, ", "));
    if (!unmeasured.empty())
        also += fmt::format("{}{} not measured while answers are wrong", also.empty() ? "" : "; ",
                            fmt::join(unmeasured, ", "));
    if (!also.empty()) block.sentence("also", also);
    std::vector<const CheckResult*> hidden;
    for (const CheckResult& check : unit.checks)
        if (check.hidden && fails(check)) hidden.push_back(&check);
    for (std::size_t i = 0; i < hidden.size(); ++i) {
        block.sentence(i == 0 ? "hidden" : "", hidden[i]->name + ": " + words_and_points(*hidden[i]));
        // Once for all that a line of the statement is about.
        const bool last = i + 1 == hidden.size() || hidden[i + 1]->about != hidden[i]->about;
        if (last && may_be_reason(*hidden[i], failing)) block.sentence("", "Looks at: " + hidden[i]->about);
        const auto end = hidden.begin() + static_cast<std::ptrdiff_t>(i);
        const bool told =
            std::any_of(hidden.begin(), end,
                        [&](const CheckResult* other) { return other->practice == hidden[i]->practice; }) ||
            (!failing.empty() && failing.front()->common == hidden[i]->practice);
        if (std::ranges::all_of(failing, [](const CheckResult* check) { return check->depends.empty(); }) &&
            !hidden[i]->depends.empty())
            block.sentence("", "On practice inputs, " + hidden[i]->depends);
        if (!told && !hidden[i]->practice.empty()) block.sentence("", "On practice inputs: " + hidden[i]->practice);
    }
    // Of a visible check that fails there is an example above.
    if (!failing.empty()) return;
    const auto example =
        std::ranges::find_if(hidden, [](const CheckResult* one) { return one->practice_example.has_value(); });
    if (example != hidden.end()) add_other_question(block, "practice", *(*example)->practice_example, paint);
    for (const CheckResult* one : hidden)
        if (const auto picture = one->artefacts.find(practice_picture); picture != one->artefacts.end())
            block.sentence("practice", picture->second);
}

}

std::string unit_details(const UnitResult& unit, int width, const Paint& paint, const std::string& folder)
{
    const Verdict verdict = shown_verdict(unit);
    const std::vector<const CheckResult*> failing = failing_checks(unit);
    const CheckResult* shown = failing.empty() ? nullptr : failing.front();
    const bool hidden_fails =
        std::ranges::any_of(unit.checks, [](const CheckResult& check) { return check.hidden && fails(check); });

    Block block(width, paint);
    block.blank();
    const std::string words =
        fmt::format("{}, {} of {} points", in_words(verdict), points_text(unit.score), points_text(unit.max_score));
    const std::string id = shorten(paint.safe(unit.id), width - display_width(words) - 6, paint.ellipsis());
    std::string result =
        fmt::format("\n  {} {}  {}", paint.mark(verdict), paint(Tone::strong, id), paint(tone_of(verdict), words));
    const bool ran = !never_ran(unit.verdict);
    block.labelled(ran ? "note" : "", excerpt(unit.message, block.room(), paint));
    if (ran) add_last_question(block, unit, shown, paint);
    if (ran && shown != nullptr)
        add_first_failing(block, *shown, unit.message, main_reasons(unit).empty() && may_be_reason(*shown, failing),
                          paint);
    if (shown == nullptr && hidden_fails)
        block.sentence(
            "check",
            "Every check that you can see is right, but a hidden one is not. Its inputs are others of the kind "
            "that is told below.");
    if (ran) add_pattern(block, unit, failing);
    if (ran) add_code_place(block, unit, shown, paint);
    add_reasons(block, unit);
    if (ran) add_others(block, unit, failing, paint);
    add_rubric(block, unit);
    if (!unit.output.empty()) {
        std::vector<std::string> lines = excerpt(unit.output, block.room() - 2, paint);
        for (std::string& line : lines) line = paint(Tone::quiet, paint.symbol("│ ", "| ")) + line;
        block.labelled("printed", lines);
    }
    block.labelled("next", next_steps(unit, shown, folder, paint));
    return result + block.take();
}

}
