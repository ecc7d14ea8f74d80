#include "cli/run_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/application.hpp"
#include "cli/config.hpp"
#include "cli/hand_over.hpp"
#include "cli/settle_process.hpp"
#include "model/nearest.hpp"
#include "text/escape.hpp"

namespace umbral::grader {
namespace {

/// Names and paths of the user's may hold anything; a terminal gets nothing of it that it would obey.
void say(const std::string& text) { (void)std::fputs(escape_terminal(text, {.lines = true}).c_str(), stderr); }

/// An empty name or number is a variable of a script that was never set. To a file system it is the current folder, or
/// nothing at all.
void refuse_empty(std::span<char* const> words)
{
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word.empty()) throw UsageError("the argument after '" + std::string(words[i - 1]) + "' is empty");
        if (word.starts_with("--") && word.find('=') == word.size() - 1)
            throw UsageError("'" + std::string(word) + "' gives no value");
    }
}

/// `umbral help check` is what other programs have for `umbral check --help`.
std::vector<char*> in_place_of_help(std::span<char* const> given)
{
    std::vector<char*> words(given.begin(), given.end());
    if (words.empty() || std::string_view(words.front()) != "help") return words;
    words.erase(words.begin());
    words.push_back(const_cast<char*>("--help"));
    return words;
}

void refuse_unknown_command(const std::vector<std::string>& known, std::span<char* const> given)
{
    if (given.empty() || *given.front() == '-') return;
    if (std::ranges::find(known, given.front()) != known.end()) return;
    throw UsageError("there is no command '" + std::string(given.front()) + "'" +
                     did_you_mean(nearest(given.front(), known)) + " `umbral --help` shows them all");
}

/// Whether a path is one that the call names, or lies below one.
bool is_named(const std::filesystem::path& path, std::span<char* const> words)
{
    const auto absolute = [](const std::filesystem::path& any) {
        std::error_code unknown;
        const std::filesystem::path full = std::filesystem::absolute(any, unknown).lexically_normal();
        return full.has_filename() ? full : full.parent_path();
    };
    const std::filesystem::path full = absolute(path);
    return !path.empty() && std::ranges::any_of(words, [&](std::string_view word) {
        if (word.starts_with("--")) word.remove_prefix(std::min(word.find('='), word.size() - 1) + 1);
        const std::filesystem::path named = absolute(word);
        return !word.empty() && std::ranges::mismatch(named, full).in1 == named.end();
    });
}

/// The command that the words name, if another program has it. Options may stand before it.
const ListedCommand* command_elsewhere(std::span<char* const> words, std::span<const ListedCommand> commands)
{
    const auto command = std::ranges::find_if(words, [](std::string_view word) { return !word.starts_with('-'); });
    if (command == words.end()) return nullptr;
    const auto listed = std::ranges::find(commands, std::string_view(*command), &ListedCommand::name);
    return listed == commands.end() || listed->add != nullptr ? nullptr : &*listed;
}

int run(std::span<char* const> words, std::span<const ListedCommand> commands)
{
    const std::vector<char*> given = in_place_of_help(words.subspan(std::min<std::size_t>(words.size(), 1)));
    // Before all else: the other program reads the units itself, and is as strict with the words.
    if (const ListedCommand* const command = command_elsewhere(given, commands)) {
        const Application where = make_application_without_units();
        if (command->needs_sources && where.layout.installed)
            throw UsageError(fmt::format(
                "umbral {} needs Umbral's sources, which packages do not hold: call ./umbral {} in a checkout",
                command->name, command->name));
        hand_over_to_authors(where, {given.begin(), given.end()});
    }
    Application application = make_application();
    CommandLine line("umbral",
                     "Umbral: exercises in computer graphics, checked against a reference that runs beside your code.",
                     std::string("umbral ") + config::version);
    line.program().footer(
        "Exit status: 0 all right; 1 the work falls short; 2 the command cannot be carried out as given; 3 a fault of "
        "Umbral's own.");
    for (const ListedCommand& one : commands) {
        // What cannot be done here is not offered.
        if (one.needs_sources && application.layout.installed) continue;
        const Command command = line.program().command(one.name, one.summary);
        if (one.add != nullptr) one.add(command, application);
    }
    refuse_empty(words);
    refuse_unknown_command(line.commands(), given);
    if (const std::string complaint = line.run(given); !complaint.empty()) {
        say(complaint);
        return exit_usage;
    }
    return application.exit_status;
}

}

int run_program(std::span<char* const> words, std::span<const ListedCommand> commands)
{
    settle_process();
    try {
        return run(words, commands);
    } catch (const UsageError& error) {
        say(std::string("umbral: ") + error.what() + "\n");
        return exit_usage;
    } catch (const std::filesystem::filesystem_error& error) {
        // A disk that is full or a folder that is closed is the user's to mend, where the user named it.
        const bool named = is_named(error.path1(), words.subspan(1)) || is_named(error.path2(), words.subspan(1));
        say(std::string(named ? "umbral: " : "umbral: a fault of Umbral's own: ") + error.what() + "\n");
        return named ? exit_usage : exit_fault;
    } catch (const std::exception& error) {
        say(std::string("umbral: a fault of Umbral's own: ") + error.what() + "\n");
        return exit_fault;
    }
}

}
