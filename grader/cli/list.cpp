#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/application.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

void print_table(const std::vector<Exercise>& exercises, const std::string& language, const TerminalStyle& style)
{
    const Paint paint(style);
    std::string topic;
    for (const Exercise& exercise : exercises) {
        if (exercise.topic != topic) fmt::print("{}{}\n", topic.empty() ? "" : "\n", paint(Tone::strong, topic = exercise.topic));
        const auto title = exercise.title.find(language);
        fmt::print("  {:<28}{:>5}  {}\n", exercise.id, points_text(exercise.points), title == exercise.title.end() ? "" : title->second);
    }
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

void add_list(CLI::App& parser, Application& application)
{
    struct Options {
        bool json = false;
        std::string language = "en";
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = parser.add_subcommand("list", "Shows all units in an order that a student can follow");
    command->add_flag("--json", options->json, "As JSON");
    command->add_option("--language", options->language, "Of the titles")->check(CLI::IsMember({"en", "es"}))->capture_default_str();
    command->callback([&application, options] {
        if (options->json)
            fmt::print("{}\n", as_json(application.exercises).dump(2));
        else
            print_table(application.exercises, options->language, application.style);
    });
}

}
