#pragma once

#include "support/printed.hpp"

namespace umbral::test {

/// Runs `umbral ARGUMENTS` through the shell; `before` may set limits or variables.
inline Printed umbral(const std::string& arguments, const std::string& before = "")
{
    return run(before + " exec " UMBRAL_PROGRAM " " + arguments);
}

}
