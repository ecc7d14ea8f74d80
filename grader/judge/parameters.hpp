#pragma once

#include <any>
#include <stdexcept>

#include "model/exercise.hpp"

namespace umbral::grader {

/// What only the judge of this check takes, as its folder declares it. Throws std::invalid_argument if the check has
/// none of that type.
template <class Parameters>
[[nodiscard]] const Parameters& parameters_of(const Check& check)
{
    if (const auto* parameters = std::any_cast<Parameters>(&check.own)) return *parameters;
    throw std::invalid_argument("check '" + check.name + "': expected the parameters of its judge, \"" +
                                check.judge.name + "\"");
}

}
