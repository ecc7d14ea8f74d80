#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace umbral::grader {

/// Goes on as another program, `words` its name and arguments. Throws std::runtime_error with `advice` if it cannot be
/// run.
[[noreturn]] inline void replace_process(std::vector<std::string> words, const std::string& advice)
{
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    (void)std::fflush(stdout);
    execvp(arguments.front(), arguments.data());
    throw std::runtime_error(fmt::format("cannot run {} ({}): {}", words.front(), std::strerror(errno), advice));
}

}
