#pragma once

#include <array>

#include "cli/command_line.hpp"

namespace umbral::grader {

struct Application;

// Each declares what one command takes, and what it does; the application must outlive the command line. A new command
// is a file with such a function, its declaration, and its line in the table below. Those of authors have theirs in
// authors/commands.hpp.
void add_list(Command command, Application& application);
void add_new(Command command, Application& application);
void add_check(Command command, Application& application);
void add_hint(Command command, Application& application);
void add_reset(Command command, Application& application);
void add_ask(Command command, Application& application);
void add_debug(Command command, Application& application);
void add_render(Command command, Application& application);
void add_compare(Command command, Application& application);
void add_grade(Command command, Application& application);
void add_demo(Command command, Application& application);
void add_doctor(Command command, Application& application);

/// A command as --help lists it.
struct ListedCommand {
    const char* name;
    const char* summary;
    void (*add)(Command command, Application& application) = nullptr;  ///< null: the program umbral-authors has it
    bool needs_sources = false;                                        ///< no installation can run it
};

/// All commands, in the order of --help.
inline constexpr std::array all_commands{
    ListedCommand{"list", "Shows all units in an order that a student can follow", add_list},
    ListedCommand{"new", "Makes a workspace: stubs, statements and goal pictures. Never overwrites your code", add_new},
    ListedCommand{"new-unit",
                  "For authors: writes all files of a new unit, which validates at once. Overwrites nothing", nullptr,
                  true},
    ListedCommand{"check", "Checks your units against the reference, here and offline", add_check},
    ListedCommand{"hint", "Shows a hint for a unit, each a step more than the one before", add_hint},
    ListedCommand{"reset", "Puts a unit's stub back; your file is kept beside it", add_reset},
    ListedCommand{"ask", "Asks your file, the reference and the oracle one question that a report shows", add_ask},
    ListedCommand{"locate", "Looks for the line of your file where a small change would make wrong checks right",
                  nullptr, true},
    ListedCommand{"debug", "Runs one case under gdb: an ordinary program, without sandbox and limits", add_debug},
    ListedCommand{"render", "Draws a scene with the reference engine: umbral render SCENE.json --out PNG", add_render},
    ListedCommand{"compare", "Compares two PNG files as a check of a picture would", add_compare},
    ListedCommand{"grade", "Grades a class: a folder with one folder a submission", add_grade},
    ListedCommand{"demo", "Grades the sample class: ten submissions, from flawless to hostile", add_demo},
    ListedCommand{"validate", "For authors and CI: proves that each unit's checks tell right from wrong"},
    ListedCommand{"refresh",
                  "For authors: writes anew what is made: statements' interface blocks, the schema of manifests"},
    ListedCommand{"bench",
                  "Prints the figures of the documents, measured here: umbral bench NAME; without a name, lists them"},
    ListedCommand{"doctor", "Looks at this machine: compiler, OpenGL, sandbox; a remedy for each thing that is missing",
                  add_doctor}};

}
