#pragma once

#include <string_view>

namespace umbral::grader {

/// Does what g++, its assembler or its linker printed hold a sign that the machine lacks something: room on the disk,
/// processes, open files? Signs in lines about a student's file count too: "sphere.cpp:1: error: cannot open …: Too
/// many open files". A student can write such words, so this is a reason to try again, and no proof.
[[nodiscard]] bool mentions_machine_trouble(std::string_view output);

/// Does a line of the output begin with these words?
[[nodiscard]] bool has_line_beginning(std::string_view output, std::string_view words);

/// Does the linker refuse what the files define or want: "mold: error: duplicate symbol: …"? Any other machine would.
[[nodiscard]] bool linker_refuses_files(std::string_view output);

/// Was the compiler, its assembler or its linker ended since a file that it wrote grew beyond what one may?
[[nodiscard]] bool outgrew_the_file_limit(std::string_view output);

/// Does a line end with such a sign that one of the tools prints of itself, "collect2: fatal error: …" or "  what():
/// …", and not of a student's file, nor in a quoted line of it, nor with a name out of it? Then the files are not at
/// fault. A tool that was killed is no such sign: files may take all the memory that there is.
[[nodiscard]] bool tools_are_in_trouble(std::string_view output);

}
