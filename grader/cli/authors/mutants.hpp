#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/application.hpp"
#include "mutants/mutant.hpp"

namespace umbral::grader {

/// How `umbral validate --mutants` was called.
struct MutantsOptions {
    std::vector<std::string> units;
    std::size_t jobs = 1;
    bool json = false;
    bool quiet = false;  ///< print only what fails
    std::string markdown;
    MutantFamily family = MutantFamily::syntax;
};

/// Tries small changes of the units' references: each must lose points, or be listed as equivalent.
void validate_mutants(Application& application, const MutantsOptions& options);

}
