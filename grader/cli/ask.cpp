#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "cli/application.hpp"
#include "cli/built_work.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/paths.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rows/tolerance.hpp"
#include "model/caps.hpp"
#include "report/paint.hpp"
#include "worker/ask_question.hpp"

namespace umbral::grader {
namespace {

struct AskOptions {
    std::string unit;
    std::string question;
    std::string file;
    std::string folder = ".";
};

constexpr std::size_t most_differences = 12;

/// "y: 1 and 2 (3.2 ulp)": a number that differs.
std::string number_line(const std::string& name, double mine, double right)
{
    const auto [a, b] =
        telling_apart([&](int digits) { return std::pair(number_text(mine, digits), number_text(right, digits)); });
    // Counts, and what is beside 0 or far off, lie so and so many steps of float apart, which tells nobody anything.
    constexpr double most_ulps = 1e6;
    const bool whole = mine == std::trunc(mine) && right == std::trunc(right);
    const bool measured = std::isfinite(mine) && std::isfinite(right) && right != 0 && !whole &&
                          std::abs(mine - right) < most_ulps * float_ulp(right);
    const std::string distance =
        measured ? fmt::format(" ({})", error_text(Unit::ulps, std::abs(mine - right) / float_ulp(right))) : "";
    return fmt::format("{}{}{} and {}{}", name, name.empty() ? "" : ": ", a, b, distance);
}

/// In which of its numbers one answer differs from another, and by how much.
std::vector<std::string> differences(const Answer& mine, const Answer& right)
{
    std::vector<std::string> lines;
    const bool alike = mine.given && right.given && mine.names == right.names;
    for (std::size_t i = 0; alike && i < right.numbers.size(); ++i) {
        const double a = mine.numbers[i];
        const double b = right.numbers[i];
        if (!equal_or_both_nan(a, b)) lines.push_back(number_line(right.names[i], a, b));
    }
    if (lines.size() > most_differences) {
        const std::size_t more = lines.size() - most_differences;
        lines.resize(most_differences);
        lines.push_back(fmt::format("and {} more", more));
    }
    return lines;
}

/// The elements of "std::vector<int>{1, 2}", sorted; none if it is no list of several.
std::vector<std::string> elements_of(const std::string& text)
{
    const std::size_t begin = text.find('{');
    if (begin == std::string::npos || !text.ends_with('}')) return {};
    std::vector<std::string> elements(1);
    int depth = 0;
    for (const char c : text.substr(begin + 1, text.size() - begin - 2)) {
        depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            elements.emplace_back();
        else if (c != ' ' || !elements.back().empty())
            elements.back() += c;
    }
    std::ranges::sort(elements);
    return elements.size() > 1 ? elements : std::vector<std::string>();
}

/// Is it a list of the same elements in another order?
bool is_reordered(const Answer& mine, const Answer& right)
{
    constexpr std::string_view list = "std::vector<";
    return mine.given && right.given && mine.text.starts_with(list) && right.text.starts_with(list) &&
           !elements_of(mine.text).empty() && elements_of(mine.text) == elements_of(right.text);
}

void print_difference(const Paint& paint, const std::string& what, const Answer& mine, const Answer& right)
{
    if (mine.given == right.given && mine.text == right.text) {
        const bool throws = mine.given && mine.text.starts_with("throws ");
        fmt::print("{} {}.\n", what, throws ? "are the same exception" : mine.given ? "are equal" : "are both missing");
        return;
    }
    if (is_reordered(mine, right)) {
        fmt::print("{} are lists of the same elements in another order, which some units leave free.\n", what);
        return;
    }
    const std::vector<std::string> lines = differences(mine, right);
    fmt::print("{} differ{}\n", what, lines.empty() ? "." : ":");
    for (const std::string& line : lines) fmt::print("  {}\n", paint.safe(line));
}

void print_answer(const Paint& paint, const char* whose, Tone tone, const Answer& answer)
{
    fmt::print("{}{}\n", paint(Tone::quiet, fmt::format("{:<11}", whose)), paint(tone, paint.safe(answer.text)));
}

void ask(Application& application, AskOptions options)
{
    options.folder = workspace_of({&options.unit, 1}, options.folder);
    const Exercise exercise = application.chosen({options.unit}).front();
    if (const std::string why = not_askable(exercise); !why.empty())
        throw UsageError(fmt::format("{} cannot be asked: {}; umbral debug runs a case of it", exercise.id, why));
    if (options.question.empty() == options.file.empty())
        throw UsageError("expected a question, in quotes, or --file with one");
    const std::string question =
        options.file.empty() ? options.question : read_given("--file", options.file, caps::source_file);
    const BuiltWork work = built_work(application, exercise, options.folder);
    Worker worker(application.tools);
    const AskedQuestion asked = ask_question(worker, exercise, work.built, question);
    if (!asked.refused.empty()) throw UsageError("this cannot be asked:\n" + asked.refused);
    const Paint paint(application.style);
    print_answer(paint, "yours", Tone::yours, asked.yours);
    print_answer(paint, "reference", Tone::expected, asked.reference);
    if (asked.oracle) print_answer(paint, "oracle", Tone::expected, *asked.oracle);
    fmt::print("\n");
    print_difference(paint, "Yours and the reference's", asked.yours, asked.reference);
    if (asked.oracle) print_difference(paint, "Yours and the oracle's", asked.yours, *asked.oracle);
    // Whether other answers are right ones is for checks to say; to have none is wrong where there is one.
    if (!asked.yours.given && asked.reference.given) application.exit_status = exit_not_right;
}

}

void add_ask(Command command, Application& application)
{
    auto options = std::make_shared<AskOptions>();
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("QUESTION", options->question, "A call with its arguments, in quotes, as a report shows it");
    command.option("--file", options->file, "A file with the question");
    command.option("--dir", options->folder, "The workspace").with_default();
    command.runs([&application, options] { ask(application, *options); });
}

}
