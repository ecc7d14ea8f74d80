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

/// Sorted by their places, and numbered from 1.
[[nodiscard]] std::vector<Mutant> numbered(std::vector<Mutant> mutants);

/// The two operands of a binary operator, also of an overloaded one, and the operator between them; `left` is null of
/// what is none.
struct Binary {
    const Node* left = nullptr;
    const Node* right = nullptr;
    std::string word;
};
[[nodiscard]] Binary binary_of(const Syntax& syntax, const Node& node);

/// The changes of an expression itself, not of its parts: see operators.cpp for which.
void mutate_expression(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants);

/// A mutant of `node` in the form of an expression.
void add_change(const Syntax& syntax, const Node& node, const char* kind, const std::string& replacement,
                std::vector<Mutant>& mutants);

}
