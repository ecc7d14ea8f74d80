#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <span>
#include <sstream>

#include "cli/application.hpp"
#include "cli/config.hpp"
#include "cli/nearest.hpp"
#include "text/escape.hpp"

namespace umbral::grader {
namespace {

/// Names and paths of the user's may hold anything; a terminal gets nothing of it that it would obey.
void say(const std::string& text) { (void)std::fputs(escape_terminal(text, {.lines = true}).c_str(), stderr); }

void add_commands(CLI::App& parser, Application& application)
{
    parser.set_version_flag("--version", std::string("umbral ") + config::version);
    parser.require_subcommand(1);
    parser.footer("Exit status: 0 all right; 1 the work falls short; 2 the command cannot be carried out as given; 3 a fault of Umbral's own.");
    add_list(parser, application);
    add_new(parser, application);
    add_check(parser, application);
    add_hint(parser, application);
    add_reset(parser, application);
    add_debug(parser, application);
    add_render(parser, application);
    add_compare(parser, application);
    add_grade(parser, application);
    add_demo(parser, application);
    add_validate(parser, application);
    add_refresh(parser, application);
    add_bench(parser, application);
    add_doctor(parser, application);
}

/// An empty name or number is a variable of a script that was never set. To a file system it is the current folder, or nothing at all.
void refuse_empty(std::span<char* const> words)
{
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word.empty()) throw UsageError("the argument after '" + std::string(words[i - 1]) + "' is empty");
        if (word.starts_with("--") && word.find('=') == word.size() - 1) throw UsageError("'" + std::string(word) + "' gives no value");
    }
}

void refuse_unknown_command(const CLI::App& parser, std::span<char* const> words)
{
    if (words.size() < 2 || *words[1] == '-') return;
    std::vector<std::string> known;
    for (const CLI::App* command : parser.get_subcommands({})) known.push_back(command->get_name());
    if (std::ranges::find(known, words[1]) != known.end()) return;
    throw UsageError("there is no command '" + std::string(words[1]) + "'" + did_you_mean(nearest(words[1], known)) + " `umbral --help` shows them all");
}

int run(int count, char** words)
{
    Application application = make_application();
    CLI::App parser("Umbral: exercises in computer graphics, checked against a reference that runs beside your code.", "umbral");
    add_commands(parser, application);
    const std::span<char* const> all(words, static_cast<std::size_t>(count));
    refuse_empty(all);
    refuse_unknown_command(parser, all);
    try {
        parser.parse(count, words);
    } catch (const CLI::ParseError& error) {
        std::ostringstream complaint;
        const int status = parser.exit(error, std::cout, complaint);
        say(complaint.str());
        return status == 0 ? exit_ok : exit_usage;
    }
    return application.exit_status;
}

}
}

int main(int count, char** words)
{
    using namespace umbral::grader;
    try {
        return run(count, words);
    } catch (const UsageError& error) {
        say(std::string("umbral: ") + error.what() + "\n");
        return exit_usage;
    } catch (const std::exception& error) {
        say(std::string("umbral: a fault of Umbral's own: ") + error.what() + "\n");
        return exit_fault;
    }
}
