#pragma once

#include <string>
#include <vector>

#include "cli/application.hpp"

namespace umbral::grader {

/// Goes on as umbral-authors with these words, the command's name first; it is built if it was not yet. Of the
/// application only where Umbral lies is asked. Throws as have_program does.
[[noreturn]] void hand_over_to_authors(const Application& application, const std::vector<std::string>& words);

}
