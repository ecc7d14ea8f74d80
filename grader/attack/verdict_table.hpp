#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "attack/rehearsal.hpp"

namespace umbral::grader::attack {

/// A table in Markdown: one row an attack with what it does, one column a setting with what came of it. `rehearsals` is by the setting's name.
[[nodiscard]] std::string markdown(std::span<const Attack> attacks, const std::map<std::string, Rehearsal>& rehearsals);

}
