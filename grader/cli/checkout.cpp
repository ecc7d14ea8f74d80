#include "cli/checkout.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "build/student_header.hpp"
#include "cli/unit_sources.hpp"
#include "model/caps.hpp"
#include "run/descriptor.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

// The file that tells that the parts are there, and the target that makes them (cmake/UmbralUnit.cmake).
fs::path mark_of(const Application& application, const Exercise& unit, UnitParts parts)
{
    return unit_folder(application.tools, unit.id) / (parts == UnitParts::all ? "built" : "answers");
}

enum class State { missing, changed, built };

/// Changed: after `shared`, the last change of what all units are built from, or after one of the unit's own, which
/// could lead to other parts.
State state_of(const fs::path& mark, const Exercise& unit, UnitParts parts, fs::file_time_type shared)
{
    std::error_code missing;
    const fs::file_time_type built = fs::last_write_time(mark, missing);
    if (missing) return State::missing;
    return built < std::max(shared, last_own_change(unit, parts)) ? State::changed : State::built;
}

std::string target_of(const Exercise& unit, UnitParts parts)
{
    return (parts == UnitParts::all ? "unit-" : "answers-") + unit.topic + "-" + unit.name;
}

/// The lines of a build's log that say what is wrong, or its last ones.
std::string errors_in(const fs::path& log)
{
    std::vector<std::string> errors;
    std::vector<std::string> all;
    std::ifstream stream(log);
    for (std::string line; std::getline(stream, line); all.push_back(line))
        if (line.find("rror") != std::string::npos || line.starts_with("FAILED")) errors.push_back(line);
    const std::vector<std::string>& shown = errors.empty() ? all : errors;
    const auto first = errors.empty() ? all.end() - std::min<std::ptrdiff_t>(std::ssize(all), 10) : errors.begin();
    std::string text;
    for (auto line = first; line != shown.end() && line != first + std::min<std::ptrdiff_t>(shown.end() - first, 10);
         ++line)
        text += "\n  " + one_line(*line);
    return text;
}

/// Runs a program with its output in `log`. Its exit status, or -1 if it cannot be started.
int run_into(const fs::path& log, std::vector<std::string> words)
{
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = -1;
    const int failed = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    if (failed != 0) return -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// No other build in this checkout until it goes out of scope; the launcher takes the same lock. Says so if it has to
/// wait for another one.
Descriptor lock_build(const Application& application)
{
    const fs::path& folder = application.layout.build;
    Descriptor lock(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (lock && flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return lock;
    if (lock && errno == EWOULDBLOCK) application.say("another build is running in this checkout; waiting for it");
    if (!lock || flock(lock.get(), LOCK_EX) != 0)
        throw std::runtime_error(fmt::format("cannot build in {}: {}", folder.string(), std::strerror(errno)));
    return lock;
}

/// Builds targets, one build of this folder at a time, as the launcher does too.
void build_targets(const Application& application, const std::vector<std::string>& targets)
{
    const Descriptor lock = lock_build(application);
    const fs::path& folder = application.layout.build;
    const fs::path log = folder / "units.log";
    std::vector<std::string> words{"cmake", "--build", folder.string(), "--target"};
    words.insert(words.end(), targets.begin(), targets.end());
    if (run_into(log, words) != 0)
        throw std::runtime_error(
            fmt::format("building {} failed; the whole log is in {}{}", listed(targets), log.string(), errors_in(log)));
}

/// What CMake keeps under this name in the build's folder: nothing if it is not there.
std::optional<std::string> kept_by_cmake(const fs::path& folder, const std::string& name)
{
    std::ifstream cache(folder / "CMakeCache.txt");
    for (std::string line; std::getline(cache, line);)
        if (line.starts_with(name + ":")) return line.substr(std::min(line.find('=') + 1, line.size()));
    return std::nullopt;
}

bool has_tests(const fs::path& folder) { return kept_by_cmake(folder, "BUILD_TESTING").value_or("ON") == "ON"; }

bool has_libclang(const fs::path& folder)
{
    return std::ranges::none_of(std::array{"LIBCLANG", "LIBCLANG_INCLUDE"}, [&](const char* name) {
        return kept_by_cmake(folder, name).value_or("").ends_with("-NOTFOUND");
    });
}

/// Has the build know the tests' targets too.
void configure_tests(const Application& application)
{
    const fs::path& folder = application.layout.build;
    if (has_tests(folder)) return;
    application.say("configuring the build with its tests");
    const Descriptor lock = lock_build(application);
    const fs::path log = folder / "units.log";
    const auto configure = [&](const fs::path& into, const char* testing) {
        return run_into(into, {"cmake", "-S", application.layout.data.string(), "-B", folder.string(), testing}) == 0;
    };
    if (configure(log, "-DBUILD_TESTING=ON")) return;
    // What was switched on stays so after a failure, and then nothing could be built any more.
    (void)configure(folder / "tests-off.log", "-DBUILD_TESTING=OFF");
    throw UsageError(
        fmt::format("this is one of the tests' programs, and they cannot be configured here; they need the packages of "
                    "cmake/debian-packages-test.txt, which `./umbral test` installs. The whole log is in {}{}",
                    log.string(), errors_in(log)));
}

/// An installation has everything but the precompiled header.
void have_header(const Application& application)
{
    if (is_header_ready(application.tools, application.layout.includes)) return;
    application.say("preparing headers for this compiler; this takes some seconds, once");
    make_header(application.tools, application.layout.includes);
}

}

bool are_built(const Application& application, std::span<const Exercise> units)
{
    if (application.layout.installed) return true;
    const fs::file_time_type shared = last_shared_change(application.tools);
    return std::ranges::all_of(units, [&](const Exercise& unit) {
        return state_of(mark_of(application, unit, UnitParts::all), unit, UnitParts::all, shared) == State::built;
    });
}

void have_built(const Application& application, std::span<const Exercise> units, UnitParts parts)
{
    if (application.layout.installed) return have_header(application);
    const fs::file_time_type shared = last_shared_change(application.tools);
    std::vector<std::string> missing;
    std::vector<std::string> changed;
    std::vector<std::string> targets;
    std::vector<fs::path> marks;
    for (const Exercise& unit : units) {
        const fs::path mark = mark_of(application, unit, parts);
        const State state = state_of(mark, unit, parts, shared);
        if (state == State::built) continue;
        (state == State::changed ? changed : missing).push_back(unit.name);
        targets.push_back(target_of(unit, parts));
        marks.push_back(mark);
    }
    if (targets.empty()) return;
    const auto say = [&](const char* what, const std::vector<std::string>& names) {
        if (!names.empty())
            application.say(fmt::format(fmt::runtime(what),
                                        names.size() == 1 ? "a unit" : fmt::format("{} units", names.size()),
                                        listed(names)));
    };
    say("building {} for the first time: {}", missing);
    say("bringing {} up to date, whose sources were changed: {}", changed);
    build_targets(application, targets);
    // The build leaves a mark as it is where a change leads to nothing new; then it would be asked each time.
    for (const fs::path& mark : marks) fs::last_write_time(mark, fs::file_time_type::clock::now());
}

fs::path have_program(const Application& application, const std::string& name)
{
    const fs::path program = application.tools.programs / name;
    if (!fs::exists(program) && application.layout.installed)
        throw UsageError(fmt::format(
            "this needs the program {}, which students' packages do not hold; install umbral-instructor", name));
    if (!fs::exists(program)) {
        application.say(fmt::format("building {} for the first time", name));
        build_targets(application, {name});
    }
    return program;
}

fs::path have_finder(const Application& application, std::string_view purpose)
{
    if (application.layout.installed)
        throw UsageError(
            fmt::format("{} by umbral-mutate, which packages do not hold: call it in a checkout", purpose));
    const fs::path& folder = application.layout.build;
    if (!has_libclang(folder)) {
        // It may be there by now.
        const Descriptor lock = lock_build(application);
        (void)run_into(folder / "units.log", {"cmake", folder.string()});
    }
    if (!has_libclang(folder))
        throw UsageError(
            fmt::format("{} by libclang, which this machine lacks: apt-get install libclang-14-dev, and "
                        "call it again",
                        purpose));
    return have_program(application, "umbral-mutate");
}

bool may_have_finder(const Application& application)
{
    return !application.layout.installed && has_libclang(application.layout.build);
}

fs::path have_fresh_program(const Application& application, const std::string& name, bool of_tests)
{
    if (of_tests) configure_tests(application);
    const fs::path program = application.tools.programs / name;
    application.say(fs::exists(program) ? fmt::format("bringing {} up to date", name)
                                        : fmt::format("building {} for the first time", name));
    build_targets(application, {name});
    return program;
}

}
