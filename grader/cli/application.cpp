#include "cli/application.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <umbral/gl/context.hpp>

#include "cli/config.hpp"
#include "model/caps.hpp"
#include "model/digest.hpp"
#include "model/nearest.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

fs::path cache_folder(const Layout& layout)
{
    if (const char* own = std::getenv("UMBRAL_CACHE"); own != nullptr && *own != '\0') {
        // Confined programs get its paths, and stand elsewhere.
        fs::path folder = fs::absolute(own);
        if (fs::exists(folder) && !fs::is_directory(folder))
            throw UsageError(fmt::format("UMBRAL_CACHE={}: expected a folder, or nothing yet", own));
        return folder;
    }
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg == '/') return fs::path(xdg) / "umbral";
    if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
        return fs::path(home) / ".cache" / "umbral";
    if (!layout.installed) return layout.build / "cache";
    throw UsageError(
        "there is no folder for what Umbral keeps: HOME is not set. Set UMBRAL_CACHE to a folder of your own");
}

/// In a checkout the build makes it; an installation, which belongs to somebody else, makes its own in the user's
/// cache.
fs::path student_header(const Layout& layout, const fs::path& cache)
{
    if (!layout.installed) return layout.includes;
    return fs::absolute(cache) / "student" / sha256_hex(layout.data.string()).substr(0, 16) /
           layout.includes.filename();
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
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 60)
        style.width = std::min<int>(size.ws_col, 120);
    return style;
}

/// Does `name` mean the unit `id`: "raytracing/sphere", "sphere", or a path that ends so?
bool is_meant(const std::string& id, const std::string& name)
{
    return name == id || id.ends_with("/" + name) || name.ends_with("/" + id);
}

std::string without_slashes(std::string name)
{
    while (name.ends_with('/')) name.pop_back();
    return name;
}

std::string cannot_be_read(const BrokenUnit& unit)
{
    return fmt::format("the unit {} cannot be read: {}", unit.id, unit.reason);
}

[[noreturn]] void refuse_unknown(const std::vector<Exercise>& exercises, const std::string& name)
{
    const bool is_path = name.find('/') != std::string::npos;
    std::vector<std::string> of_topic;
    std::vector<std::string> known;
    for (const Exercise& exercise : exercises) {
        if (exercise.topic == name) of_topic.push_back(exercise.id);
        known.push_back(is_path ? exercise.id : exercise.name);
    }
    if (!of_topic.empty())
        throw UsageError(fmt::format("'{}' is a topic, not a unit; its units: {}", name, listed(of_topic)));
    if (std::error_code unknown; fs::is_directory(name, unknown))
        throw UsageError(
            fmt::format("'{}' is a folder, not a unit; where a command takes a workspace, give it as "
                        "--dir {}, or call the command in it",
                        one_line(name), one_line(name)));
    // Behind the names, so that of two that are as near the unit comes first.
    if (!is_path)
        for (const Exercise& exercise : exercises) known.push_back(exercise.topic);
    throw UsageError(fmt::format("there is no unit '{}'{} `umbral list` shows them all", one_line(name),
                                 did_you_mean(nearest(name, known))));
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
    if (names.empty() && !broken.empty())
        throw UsageError(cannot_be_read(broken.front()) + "\nMend it, or name the units that you mean.");
    if (names.empty()) return exercises;
    std::vector<Exercise> result;
    for (const std::string& typed : names) {
        const std::string name = without_slashes(typed);
        bool known = false;
        for (const Exercise& exercise : exercises) {
            if (!is_meant(exercise.id, name)) continue;
            known = true;
            // Named twice it counts once.
            if (std::ranges::find(result, exercise.id, &Exercise::id) == result.end()) result.push_back(exercise);
        }
        if (known) continue;
        for (const BrokenUnit& unit : broken)
            if (is_meant(unit.id, name)) throw UsageError(cannot_be_read(unit));
        refuse_unknown(exercises, name);
    }
    return result;
}

std::vector<Exercise> Application::readable() const
{
    check_gl_choice();
    warn_of_broken();
    return exercises;
}

void Application::require_answers() const
{
    if (!fs::is_directory(tools.reference))
        throw UsageError(
            fmt::format("this needs the sources of the reference in {}, which students' packages do not hold; install "
                        "umbral-instructor",
                        tools.reference.string()));
}

void Application::say(const std::string& what) const
{
    fmt::print(stderr, "umbral: {}\n", Paint(style).safe(what));
    (void)std::fflush(stderr);
}

void Application::warn_of_broken() const
{
    for (const BrokenUnit& unit : broken)
        fmt::print(stderr, "umbral: warning: {}\n", Paint(style).safe(cannot_be_read(unit)));
}

Application make_application_without_units()
{
    Application application;
    application.layout = own_layout();
    const Layout& layout = application.layout;
    const fs::path cache = cache_folder(layout);
    application.tools = {.exercises = layout.data / "exercises",
                         .reference = layout.data / "reference",
                         .units = layout.build / "units",
                         .programs = layout.build / "bin",
                         .framework = layout.data / "framework",
                         .student_header = student_header(layout, cache),
                         .cache = cache,
                         .compiler = config::compiler,
                         .flags = words(config::student_flags)};
    application.style = style_of_terminal();
    return application;
}

Application make_application()
{
    Application application = make_application_without_units();
    Units units = load_units(application.tools.exercises);
    application.exercises = std::move(units.exercises);
    application.broken = std::move(units.broken);
    return application;
}

}
