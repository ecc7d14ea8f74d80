#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>

#include "model/nearest.hpp"

namespace umbral::grader {

const Option& Option::required() const
{
    option_->required();
    return *this;
}

const Option& Option::called(const std::string& value) const
{
    option_->type_name(value);
    return *this;
}

const Option& Option::with_default() const
{
    option_->capture_default_str();
    return *this;
}

const Option& Option::between(std::size_t least, std::size_t most) const
{
    option_->check(CLI::Range(least, most));
    return *this;
}

const Option& Option::one_of(const std::vector<std::string>& words) const
{
    option_->check(CLI::IsMember(words));
    return *this;
}

const Option& Option::existing_folder() const
{
    option_->check(CLI::ExistingDirectory);
    return *this;
}

const Option& Option::excludes(const std::string& other) const
{
    option_->excludes(other);
    return *this;
}

Command Command::command(const std::string& name, const std::string& summary) const
{
    return Command(*app_->add_subcommand(name, summary));
}

Option Command::option(const std::string& name, std::string& to, const std::string& meaning) const
{
    return Option(*app_->add_option(name, to, meaning));
}
Option Command::option(const std::string& name, std::vector<std::string>& to, const std::string& meaning) const
{
    return Option(*app_->add_option(name, to, meaning));
}
Option Command::option(const std::string& name, std::size_t& to, const std::string& meaning) const
{
    return Option(*app_->add_option(name, to, meaning));
}
Option Command::option(const std::string& name, unsigned& to, const std::string& meaning) const
{
    return Option(*app_->add_option(name, to, meaning));
}
Option Command::option(const std::string& name, std::optional<std::size_t>& to, const std::string& meaning) const
{
    return Option(*app_->add_option(name, to, meaning));
}
Option Command::flag(const std::string& name, bool& to, const std::string& meaning) const
{
    return Option(*app_->add_flag(name, to, meaning));
}

void Command::also_called(const std::string& name) const { app_->alias(name); }
void Command::footer(const std::string& text) const { app_->footer(text); }
void Command::runs(std::function<void()> action) const { app_->callback(std::move(action)); }

void Command::passes_words_on() const
{
    app_->set_help_flag();
    app_->prefix_command();
}
void Command::has_help() const { app_->set_help_flag("-h,--help", "Print this help message and exit"); }
std::vector<std::string> Command::rest() const { return app_->remaining(); }
bool Command::has_named_command() const { return !app_->get_subcommands().empty(); }

namespace {

template <class Parse>
std::string complaint_of(CLI::App& app, const Parse& parse)
{
    try {
        parse();
        return "";
    } catch (const CLI::ParseError& error) {
        std::ostringstream complaint;
        (void)app.exit(error, std::cout, complaint);
        return complaint.str();
    }
}

/// What there is to say of the first option that its command does not have. The parser would take what follows it for
/// an argument first, and complain of that.
std::string unknown_option(const CLI::App& app, std::span<char* const> words)
{
    const CLI::App* command = nullptr;
    for (const std::string_view word : words) {
        if (command == nullptr) {
            if (word.starts_with('-')) continue;
            const auto all = app.get_subcommands({});
            const auto found = std::ranges::find(all, word, &CLI::App::get_name);
            if (found == all.end() || (*found)->get_prefix_command()) return "";
            command = *found;
            continue;
        }
        const std::string option(word.substr(0, word.find('=')));
        if (option == "--") return "";
        if (!option.starts_with("--") || command->get_option_no_throw(option) != nullptr) continue;
        std::vector<std::string> known;
        for (const CLI::Option* one : command->get_options())
            for (const std::string& name : one->get_lnames()) known.push_back("--" + name);
        return "umbral: " + command->get_name() + " has no option '" + option + "'" +
               did_you_mean(nearest(option, known)) + " `umbral " + command->get_name() + " --help` shows all it has\n";
    }
    return "";
}

}

CommandLine::CommandLine(const std::string& name, const std::string& summary, const std::string& version)
    : app_(std::make_unique<CLI::App>(summary, name))
{
    app_->set_version_flag("--version", version);
    app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Command CommandLine::program() const { return Command(*app_); }

std::vector<std::string> CommandLine::commands() const
{
    std::vector<std::string> names;
    for (const CLI::App* command : app_->get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::string CommandLine::run(std::span<char* const> words)
{
    if (std::string complaint = unknown_option(*app_, words); !complaint.empty()) return complaint;
    // CLI11 takes the last word first.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    return complaint_of(*app_, [&] { app_->parse(std::move(reversed)); });
}

std::string CommandLine::run(const std::string& line)
{
    return complaint_of(*app_, [&] { app_->parse(line); });
}

}
