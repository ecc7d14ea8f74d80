#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "cli/layout.hpp"
#include "manifest/units.hpp"
#include "report/terminal.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What a command ends with; documented in --help and in docs.
enum Exit : int {
    exit_ok = 0,         ///< all is right
    exit_not_right = 1,  ///< the work (or the unit, or the machine) falls short
    exit_usage = 2,      ///< the command cannot be carried out as given
    exit_fault = 3,      ///< a fault of the grader's
};

/// A mistake in how a command was called. Its text says what was expected, what came and what to do.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What all commands share.
struct Application {
    Layout layout;
    Toolchain tools;
    std::vector<Exercise> exercises;
    std::vector<BrokenUnit> broken;  ///< reported by the commands that need them
    TerminalStyle style;
    int exit_status = exit_ok;  ///< set by the command that ran

    /// The exercises named (as "raytracing/sphere", "sphere", or a path that ends so); all if none is. Throws
    /// UsageError with near names, or with the reason if one of them cannot be read, or if UMBRAL_GL names no back end
    /// of OpenGL.
    [[nodiscard]] std::vector<Exercise> chosen(const std::vector<std::string>& names) const;

    /// All exercises that can be read, for commands that get along without the others: which those are is said on the
    /// standard error stream. Throws UsageError if UMBRAL_GL names no back end of OpenGL.
    [[nodiscard]] std::vector<Exercise> readable() const;

    /// For commands that grade the answers themselves. Throws UsageError where their sources are not installed.
    void require_answers() const;

    /// A line on the standard error stream, of what takes time: "building disc for the first time".
    void say(const std::string& what) const;

    /// Says on the standard error stream which units cannot be read, and why; nothing if all can.
    void warn_of_broken() const;
};

/// Where this Umbral lies, and its units. Throws std::runtime_error, and UsageError if there is no folder for what it
/// keeps.
[[nodiscard]] Application make_application();

/// The same without its units, which take a tenth of a second to read: for what another program goes on with.
[[nodiscard]] Application make_application_without_units();

}
