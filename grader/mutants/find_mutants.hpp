#pragma once

#include <vector>

#include "mutants/mutant.hpp"
#include "mutants/syntax.hpp"

namespace umbral::grader {

/// All mutants of a source, numbered from 1 in the order of their places. Some may not compile, as where types differ:
/// whoever builds them leaves those out.
[[nodiscard]] std::vector<Mutant> find_mutants(const Syntax& syntax);

/// The same of slips as students make them, where find_mutants changes one sign of the language after the other:
/// another component, field or variable of the same type; an absolute tolerance in a comparison; a value that loses its
/// sign, is cut or normalised; a loop that leaves out its last round; two statements in the other order; an answer kept
/// for arguments of the same sizes and numbers.
[[nodiscard]] std::vector<Mutant> find_slips(const Syntax& syntax);

/// What students may have to change where their own work is wrong: all of these, and what undoes common oversights: a
/// sign, a unit vector, the other form of a matrix, half or twice an angle, half a pixel, one more or less, rounding, a
/// comparison the other way round, any other component or variable of the same type.
[[nodiscard]] std::vector<Mutant> find_repairs(const Syntax& syntax);

/// Every function returns at once, with nothing. Those that make an object have to give one.
[[nodiscard]] std::vector<Mutant> find_idle(const Syntax& syntax);

/// The same, but with the first argument of the type that is returned, of matrices with the identity if there is none.
[[nodiscard]] std::vector<Mutant> find_echo(const Syntax& syntax);

/// An early return from a function with this body: with `given`, C++, or with nothing.
[[nodiscard]] Mutant early_return(const Node& function, const Node& body, const std::string& given = "");

/// Sorted by their places, and numbered from 1.
[[nodiscard]] std::vector<Mutant> numbered(std::vector<Mutant> mutants);

/// The element of a list one step from the one that is taken, where its place is computed; `step`: "+ 1" or "- 1".
void mutate_index(const Syntax& syntax, const Node& node, const char* step, std::vector<Mutant>& mutants);

/// The changes of an expression itself, not of its parts: see operators.cpp for which.
void mutate_expression(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants);

}
