#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/config.hpp"
#include "cli/goal_pictures.hpp"
#include "cli/paths.hpp"
#include "report/html/pages.hpp"
#include "report/paint.hpp"
#include "unit/pictures.hpp"

namespace umbral::grader {
namespace {

/// A unit that has no title in that language is listed by its English one, which every unit has.
std::string title_in(const Exercise& exercise, const std::string& language)
{
    const auto title = exercise.title.find(language);
    return title == exercise.title.end() ? exercise.title.at("en") : title->second;
}

void print_table(const std::vector<Exercise>& exercises, const std::string& language, const TerminalStyle& style)
{
    const Paint paint(style);
    std::string topic;
    for (const Exercise& exercise : exercises) {
        if (exercise.topic != topic)
            fmt::print("{}{}\n", topic.empty() ? "" : "\n", paint(Tone::strong, topic = exercise.topic));
        fmt::print("  {:<28}{:>5}  {}\n", exercise.id, points_text(exercise.points), title_in(exercise, language));
    }
}

/// "12 checks: numbers, image; 2 hidden, 3 hard".
std::string checks_in_words(const Exercise& exercise)
{
    std::vector<std::string> kinds;
    for (const Check& check : exercise.checks)
        if (const std::string kind = to_string(check.judge); std::ranges::find(kinds, kind) == kinds.end())
            kinds.push_back(kind);
    std::string text = fmt::format("{} checks: {}", exercise.checks.size(), fmt::join(kinds, ", "));
    const auto hidden = std::ranges::count(exercise.checks, true, &Check::hidden);
    const auto hard = std::ranges::count(exercise.checks, true, &Check::hard);
    if (hidden != 0) text += fmt::format("; {} hidden", hidden);
    if (hard != 0) text += fmt::format("{} {} hard", hidden != 0 ? "," : ";", hard);
    return text;
}

/// The place of a problem of the course, as its units name it: "problem 2.24" is the 24th of the second part.
std::optional<std::pair<int, int>> problem_of(const std::string& course)
{
    constexpr std::string_view word = "problem ";
    if (!course.starts_with(word)) return std::nullopt;
    std::pair<int, int> place;
    const char* const end = course.data() + course.size();
    const auto part = std::from_chars(course.data() + word.size(), end, place.first);
    if (part.ptr == end || *part.ptr != '.') return std::nullopt;
    if (std::from_chars(part.ptr + 1, end, place.second).ptr != end) return std::nullopt;
    return place;
}

void print_problems(const std::vector<Exercise>& exercises)
{
    std::map<std::pair<int, int>, std::vector<std::string>> units;
    for (const Exercise& exercise : exercises)
        for (const std::string& course : exercise.course)
            if (const auto problem = problem_of(course))
                units[*problem].push_back(fmt::format("[{0}](../exercises/{0}/README.md)", exercise.id));
    fmt::print("\n## The course's problems\n\n| problem | units |\n|---|---|\n");
    for (const auto& [problem, links] : units)
        fmt::print("| {}.{} | {} |\n", problem.first, problem.second, fmt::join(links, ", "));
}

/// docs/units.md: paths are relative to that folder.
void print_markdown(const std::vector<Exercise>& exercises, const std::string& language)
{
    fmt::print(
        "# The units\n\nMade by `umbral list --markdown`; `umbral list --html FILE` shows them with the pictures that "
        "the reference draws.\n");
    std::string topic;
    for (const Exercise& exercise : exercises) {
        if (exercise.topic != topic)
            fmt::print(
                "\n## {0}\n![The goal pictures of {0}](pictures/units-{0}.png)\n\n| unit | | course | checked "
                "|\n|---|---|---|---|\n",
                exercise.topic);
        topic = exercise.topic;
        fmt::print("| [{}](../exercises/{}/README.md) | {} | {} | {} |\n", exercise.name, exercise.id,
                   title_in(exercise, language), fmt::join(exercise.course, ", "), checks_in_words(exercise));
    }
    print_problems(exercises);
}

void write_catalogue(const Application& application, const std::string& language, const std::string& file)
{
    expect_writable(file);
    const std::vector<Exercise>& exercises = application.exercises;
    std::vector<html::CatalogueEntry> entries(exercises.size());
    draw_goal_pictures(application, exercises, [&](Worker& worker, std::size_t unit) {
        const Exercise& exercise = exercises[unit];
        const std::optional<Image> goal = goal_picture(worker, exercise);
        entries[unit] = {exercise.topic,
                         exercise.id,
                         title_in(exercise, language),
                         exercise.points,
                         exercise.course,
                         checks_in_words(exercise),
                         goal ? html::encode(*goal) : html::Picture()};
    });
    write_output(file, html::catalogue_html(entries, language, config::version));
    fmt::print("{}\n", Paint(application.style).safe(file));
}

nlohmann::json as_json(const std::vector<Exercise>& exercises)
{
    nlohmann::json units = nlohmann::json::array();
    for (const Exercise& exercise : exercises)
        units.push_back({{"id", exercise.id},
                         {"title", exercise.title},
                         {"files", exercise.files},
                         {"points", exercise.points},
                         {"course", exercise.course},
                         {"uses", exercise.uses},
                         {"digest", exercise.digest}});
    return {{"format", "umbral-list"}, {"version", 1}, {"score_unit", "millipoints"}, {"units", units}};
}

}

void add_list(Command command, Application& application)
{
    struct Options {
        bool json = false;
        bool markdown = false;
        std::string language = "en";
        std::string html;
    };
    auto options = std::make_shared<Options>();
    command.flag("--json", options->json, "As JSON");
    command.option("--language", options->language, "Of the titles").one_of({"en", "es"}).with_default();
    command.flag("--markdown", options->markdown, "As a page of Markdown, which docs/units.md is");
    command.option("--html", options->html, "Write a page with the pictures that the reference draws").called("FILE");
    command.runs([&application, options] {
        application.warn_of_broken();
        if (!options->html.empty())
            write_catalogue(application, options->language, options->html);
        else if (options->markdown)
            print_markdown(application.exercises, options->language);
        else if (options->json)
            fmt::print("{}\n", as_json(application.exercises).dump(2));
        else
            print_table(application.exercises, options->language, application.style);
    });
}

}
