#pragma once

#include <array>

#include "cli/command_line.hpp"

namespace umbral::grader {

struct Application;

// Each adds one command to the program; the application must outlive the command line. A new command is a file with
// such a function, its declaration, and its place in the order of --help.
void add_list(Command parser, Application& application);
void add_new(Command parser, Application& application);
void add_new_unit(Command parser, Application& application);
void add_check(Command parser, Application& application);
void add_hint(Command parser, Application& application);
void add_reset(Command parser, Application& application);
void add_ask(Command parser, Application& application);
void add_locate(Command parser, Application& application);
void add_debug(Command parser, Application& application);
void add_render(Command parser, Application& application);
void add_compare(Command parser, Application& application);
void add_grade(Command parser, Application& application);
void add_demo(Command parser, Application& application);
void add_validate(Command parser, Application& application);
void add_refresh(Command parser, Application& application);
void add_bench(Command parser, Application& application);
void add_doctor(Command parser, Application& application);

/// All commands, in the order of --help.
inline constexpr std::array add_commands{add_list, add_new,      add_new_unit, add_check,  add_hint,    add_reset,
                                         add_ask,  add_locate,   add_debug,    add_render, add_compare, add_grade,
                                         add_demo, add_validate, add_refresh,  add_bench,  add_doctor};

// Added to the command bench.
void add_bench_explanations(Command bench, Application& application);
void add_bench_judges(Command bench, Application& application);
void add_bench_unforeseen(Command bench, Application& application);

}
