#include "cli/application.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <umbral/gl/context.hpp>

#include "cli/config.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

fs::path cache_folder()
{
    if (const char* own = std::getenv("UMBRAL_CACHE")) return own;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg == '/') return fs::path(xdg) / "umbral";
    if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') return fs::path(home) / ".cache" / "umbral";
    return fs::path(config::build_folder) / "cache";
}

std::vector<std::string> words(const char* text)
{
    std::vector<std::string> result;
    std::istringstream stream{std::string(text)};
    // CMake joins lists with semicolons.
    for (std::string word; std::getline(stream, word, ';');) result.push_back(word);
    return result;
}

TerminalStyle style_of_terminal()
{
    TerminalStyle style;
    // https://no-color.org: a variable of that name, not empty, means no colour.
    const char* no_color = std::getenv("NO_COLOR");
    style.color = isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == 0);
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 60) style.width = std::min<int>(size.ws_col, 120);
    return style;
}

bool is_meant(const Exercise& exercise, std::string name)
{
    while (name.ends_with('/')) name.pop_back();
    return name == exercise.id || name == exercise.name || name.ends_with("/" + exercise.id);
}

/// What the spawner would refuse later, as a fault: the user's own variable is the user's to mend.
void check_gl_choice()
{
    const char* const chosen = std::getenv("UMBRAL_GL");
    if (chosen == nullptr || *chosen == 0 || gl::backend_named(chosen)) return;
    throw UsageError(fmt::format("UMBRAL_GL is '{}': expected osmesa or egl, or unset the variable", chosen));
}

}

std::vector<Exercise> Application::chosen(const std::vector<std::string>& names) const
{
    check_gl_choice();
    if (names.empty()) return exercises;
    std::vector<Exercise> result;
    for (const std::string& name : names) {
        const auto before = result.size();
        std::copy_if(exercises.begin(), exercises.end(), std::back_inserter(result), [&](const Exercise& exercise) { return is_meant(exercise, name); });
        if (result.size() > before) continue;
        std::vector<std::string> ids;
        for (const Exercise& exercise : exercises) ids.push_back(exercise.id);
        throw UsageError(fmt::format("there is no unit '{}'; `umbral list` shows them: {}", name, fmt::join(ids, ", ")));
    }
    return result;
}

Application make_application()
{
    const fs::path source = config::source_folder;
    const fs::path build = config::build_folder;
    Application application;
    application.tools = {.exercises = source / "exercises",
                         .reference = source / "reference",
                         .units = build / "units",
                         .programs = build / "bin",
                         .framework = source / "framework",
                         .student_header = build / "student" / "umbral_student.hpp",
                         .cache = cache_folder(),
                         .compiler = config::compiler,
                         .flags = words(config::student_flags)};
    application.exercises = load_exercises(application.tools.exercises);
    application.style = style_of_terminal();
    return application;
}

}
