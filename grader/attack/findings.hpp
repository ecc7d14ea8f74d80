#pragma once

#include <string>
#include <vector>

#include "attack/trial.hpp"

namespace umbral::grader::attack {

/// What of an attack did not hold, each in one sentence; none if it held. Beside what the attack itself expects, this
/// is asked of all: the class is graded to its end; the submission has a report; no unit is a fault of the grader's or
/// worth another maximum than for others; reports and terminal hold neither control characters nor raw markup from the
/// submission nor paths of this machine, and are no larger than the attack's bound; others on this machine cannot read
/// them.
[[nodiscard]] std::vector<std::string> findings(const Attack& attack, const Graded& graded);

/// Where good work's results differ between two gradings, but for times: none if every byte is the same.
[[nodiscard]] std::vector<std::string> changes_of_good(const Graded& before, const Graded& after);

/// "compile_error 0" for each unit of the attack: what came, for tables.
[[nodiscard]] std::string outcome_of(const Attack& attack, const Graded& graded);

}
