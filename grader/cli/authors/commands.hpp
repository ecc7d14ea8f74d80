#pragma once

#include <array>
#include <string_view>

#include "cli/commands.hpp"

namespace umbral::grader {

// As in cli/commands.hpp: the commands of umbral-authors, which umbral starts when one of them is named.
void add_new_unit(Command command, Application& application);
void add_locate(Command command, Application& application);
void add_validate(Command command, Application& application);
void add_refresh(Command command, Application& application);
void add_bench(Command command, Application& application);

/// The part of `doctor` that needs attacks: umbral has the other, and starts this one for --attack.
void add_doctor_attacks(Command command, Application& application);

/// A line of the table of all commands, with what umbral does not have of it. No such name does not compile.
consteval ListedCommand of_authors(std::string_view name, void (*add)(Command command, Application& application))
{
    for (const ListedCommand& one : all_commands)
        if (one.name == name) return {one.name, one.summary, add};
    throw "there is no such command";
}

/// All that umbral-authors can be called with.
inline constexpr std::array authors_commands{
    of_authors("new-unit", add_new_unit), of_authors("locate", add_locate), of_authors("validate", add_validate),
    of_authors("refresh", add_refresh),   of_authors("bench", add_bench),   of_authors("doctor", add_doctor_attacks)};

// Added to the command bench.
void add_bench_explanations(Command bench, Application& application);
void add_bench_judges(Command bench, Application& application);
void add_bench_unforeseen(Command bench, Application& application);

}
