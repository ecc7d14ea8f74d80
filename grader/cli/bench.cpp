#include <CLI/CLI.hpp>

#include "cli/application.hpp"
#include "cli/become.hpp"
#include "cli/checkout.hpp"

namespace umbral::grader {

// What needs the reference, which the grader must not hold, is measured by a program of its own, with its own options and its own --help.
void add_bench(CLI::App& parser, Application& application)
{
    CLI::App* command =
        parser.add_subcommand("bench", "Measures what accuracy costs in time (umbral bench accuracy), and the grader itself (judge, explanations)");
    command->set_help_flag();
    command->prefix_command();
    add_bench_explanations(*command, application);
    add_bench_judges(*command, application);
    command->callback([&application, command] {
        if (!command->get_subcommands().empty()) return;
        std::vector<std::string> words = {have_program(application, "umbral-bench-accuracy").string()};
        for (const std::string& word : command->remaining()) words.push_back(word);
        become(std::move(words), "build the target umbral-bench-accuracy");
    });
}

}
