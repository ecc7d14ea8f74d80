#pragma once

#include "cli/application.hpp"

namespace umbral::grader {

/// Grades a class of the attacks of tests/attacks that do no harm even where they succeed, beside good work, in a
/// scratch folder on this machine; prints a line for each attack, what did not hold of it, and a sum. The exit status
/// says whether all held. Throws UsageError if the attacks are not there.
void attack_this_machine(Application& application);

}
