#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "attack/rehearsal.hpp"

namespace umbral::grader::attack {

/// Two tables in Markdown: the settings, with how many attacks held in each; and the attacks, with what came of each,
/// and in how many settings (in which, where they differ). `rehearsals` is by the setting's name.
[[nodiscard]] std::string markdown(std::span<const Attack> attacks, const std::map<std::string, Rehearsal>& rehearsals);

}
