#pragma once

#include <vector>

#include "mutants/mutant.hpp"
#include "mutants/syntax.hpp"

namespace umbral::grader {

/// All mutants of a source, numbered from 1 in the order of their places. Some may not compile, as where types differ:
/// whoever builds them leaves those out.
[[nodiscard]] std::vector<Mutant> find_mutants(const Syntax& syntax);

/// The changes of an expression itself, not of its parts: see operators.cpp for which.
void mutate_expression(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants);

/// A mutant of `node` in the form of an expression.
void add_change(const Syntax& syntax, const Node& node, const char* kind, const std::string& replacement,
                std::vector<Mutant>& mutants);

}
