#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::test {

/// A command that a page of Markdown tells its readers to call.
struct Command {
    std::string text;  ///< as it stands there, without the comment behind it
    int line = 0;      ///< from 1
    int block = -1;    ///< which block of code it stands in, from 0; -1: in a sentence or a table
};

/// Whether this calls Umbral: `umbral WORD…`, `./umbral WORD…`, or a program of the build, perhaps with variables set
/// before it.
[[nodiscard]] bool calls_umbral(std::string_view text);

/// All of a page's commands that call Umbral: of each block of code its lines, also those that say `cd`; in sentences,
/// tables and the comments of a block what stands between backticks.
[[nodiscard]] std::vector<Command> commands_of(std::string_view page);

}
