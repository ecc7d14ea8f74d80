#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}

namespace umbral::grader {

/// Numbers beyond this are slips: every job is a thread with programs of its own.
inline constexpr std::size_t most_jobs = 1024;
/// A thousand seeds take days.
inline constexpr std::size_t most_seeds = 10000;

/// One option or argument of a command, while it is declared. Each function returns the option itself.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    const Option& required() const;
    /// What stands for its value in --help: "FILE".
    const Option& called(const std::string& value) const;
    /// --help shows what holds without it.
    const Option& with_default() const;
    /// Refuses any other number.
    const Option& between(std::size_t least, std::size_t most) const;
    /// Refuses any other word.
    const Option& one_of(const std::vector<std::string>& words) const;
    const Option& existing_folder() const;
    /// Refuses both together.
    const Option& excludes(const std::string& other) const;

private:
    CLI::Option* option_;
};

/// A command of the program, while it is declared. CLI11 reads the command line; its header takes four seconds to
/// compile, and so is known to command_line.cpp alone.
class Command {
public:
    explicit Command(CLI::App& app) : app_(&app) {}

    /// A command below this one.
    [[nodiscard]] Command command(const std::string& name, const std::string& summary) const;

    /// Another name, which --help shows beside it.
    void also_called(const std::string& name) const;

    /// An argument ("UNIT") or option ("--out"), and where its value goes, which must outlive the command. Of several
    /// values, where `to` is a list, an argument takes all that stand there.
    Option option(const std::string& name, std::string& to, const std::string& meaning) const;
    Option option(const std::string& name, std::vector<std::string>& to, const std::string& meaning) const;
    Option option(const std::string& name, std::size_t& to, const std::string& meaning) const;
    Option option(const std::string& name, unsigned& to, const std::string& meaning) const;
    Option option(const std::string& name, std::optional<std::size_t>& to, const std::string& meaning) const;
    Option flag(const std::string& name, bool& to, const std::string& meaning) const;

    /// What --help says at its end.
    void footer(const std::string& text) const;
    /// What the command does, once the whole command line has been read.
    void runs(std::function<void()> action) const;
    /// Passes every word on that it does not know, --help too: `rest` gives them once the command runs.
    void passes_words_on() const;
    [[nodiscard]] std::vector<std::string> rest() const;
    /// … but this command below such a one has a --help of its own.
    void has_help() const;
    /// Was one of the commands below it named?
    [[nodiscard]] bool has_named_command() const;

private:
    CLI::App* app_;
};

/// The program's command line: what it takes, and how it is read.
class CommandLine {
public:
    CommandLine(const std::string& name, const std::string& summary, const std::string& version);
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;
    ~CommandLine();

    /// The program itself, to which commands are added; one of them must be named.
    [[nodiscard]] Command program() const;
    /// The names of its commands.
    [[nodiscard]] std::vector<std::string> commands() const;

    /// Reads the words behind the program's name, and runs the command that they name; prints help and version where
    /// they are asked for. Returns what is wrong with the words, ready to be shown; empty if nothing is. Throws what
    /// the command throws.
    [[nodiscard]] std::string run(std::span<char* const> words);
    /// The same from one line, for tests.
    [[nodiscard]] std::string run(const std::string& line);

private:
    std::unique_ptr<CLI::App> app_;
};

}
