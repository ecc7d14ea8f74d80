#include <CLI/CLI.hpp>

#include "cli/application.hpp"
#include "cli/become.hpp"
#include "cli/checkout.hpp"

namespace umbral::grader {

// The engine is the reference, which the grader must not hold: it is a program of its own, with its own options and its own --help.
void add_render(CLI::App& parser, Application& application)
{
    CLI::App* command = parser.add_subcommand("render", "Draws a scene with the reference engine: umbral render SCENE.json --out PNG");
    command->set_help_flag();
    command->prefix_command();
    command->callback([&application, command] {
        std::vector<std::string> words = {have_program(application, "umbral-render").string()};
        for (const std::string& word : command->remaining()) words.push_back(word);
        become(std::move(words), "build the target umbral-render");
    });
}

}
