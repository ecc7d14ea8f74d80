
#include "cli/application.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/replace_process.hpp"

namespace umbral::grader {

// The engine is the reference, which the grader must not hold: it is a program of its own, with its own options and its
// own --help.
void add_render(Command command, Application& application)
{
    command.passes_words_on();
    command.runs([&application, command] {
        std::vector<std::string> words = {have_program(application, "umbral-render").string()};
        for (const std::string& word : command.rest()) words.push_back(word);
        replace_process(std::move(words), "build the target umbral-render");
    });
}

}
