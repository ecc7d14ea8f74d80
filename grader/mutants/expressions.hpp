#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mutants/mutant.hpp"
#include "mutants/syntax.hpp"

namespace umbral::grader {

// What all finders of mutants ask of a part of a source's syntax.

/// Is the name among these?
[[nodiscard]] constexpr bool is_one_of(std::string_view name, std::span<const std::string_view> names)
{
    return std::ranges::find(names, name) != names.end();
}

/// What a source declares, in the order of its lines.
struct Variable {
    std::string name;
    std::string type;
};

[[nodiscard]] inline bool is_real(const std::string& type)
{
    return type == "float" || type == "double" || type == "long double";
}

/// Of GLM, whatever its size.
[[nodiscard]] inline bool is_vector(const std::string& type)
{
    return type.starts_with("glm::vec<") || type.starts_with("vec<");
}
[[nodiscard]] inline bool is_matrix(const std::string& type)
{
    return type.starts_with("glm::mat<") || type.starts_with("mat<");
}

[[nodiscard]] inline bool is_integer(const std::string& type)
{
    return type.ends_with("int") || type.ends_with("long") || type.ends_with("char") || type.ends_with("short");
}

/// May the value be negative, and above 1? Of what is called that is known of few functions.
[[nodiscard]] bool has_any_size(const Syntax& syntax, const Node& node);

/// The body of a function that runs; null if it has none, or if the compiler computes it: there is no run that could be
/// given a mutant's number.
[[nodiscard]] const Node* running_body(const Syntax& syntax, const Node& function);

/// Is it made before any run: constants, statics, assertions, aliases?
[[nodiscard]] bool has_no_run(const Syntax& syntax, const Node& node);

/// The two operands of a binary operator, also of an overloaded one, and the operator between them; `left` is null of
/// what is none.
struct Binary {
    const Node* left = nullptr;
    const Node* right = nullptr;
    std::string word;
};
[[nodiscard]] Binary binary_of(const Syntax& syntax, const Node& node);

/// A mutant of `node` in the form of an expression.
void add_change(const Syntax& syntax, const Node& node, const char* kind, const std::string& replacement,
                std::vector<Mutant>& mutants);

}
