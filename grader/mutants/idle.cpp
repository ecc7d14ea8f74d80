#include <string>
#include <string_view>

#include "mutants/expressions.hpp"
#include "mutants/find_mutants.hpp"

namespace umbral::grader {
namespace {

/// Does a function of this type give an object, which whoever called it then uses?
bool makes_an_object(std::string_view type)
{
    return type.find("unique_ptr") != std::string_view::npos || type.find("shared_ptr") != std::string_view::npos;
}

/// What a function gives back that does nothing with what it was given; empty where that is nothing.
std::string given_back(const Node& function)
{
    for (const Node& child : function.children)
        if (child.kind == CXCursor_ParmDecl && !child.called.empty() && child.type == function.type)
            return child.called;
    return function.type.starts_with("glm::mat<") ? function.type + "(1)" : "";
}

std::vector<Mutant> early_returns(const Syntax& syntax, bool gives_back)
{
    std::vector<Mutant> mutants;
    for (const Node& function : syntax.functions) {
        const Node* const body = running_body(syntax, function);
        if (body == nullptr || body->children.empty() || makes_an_object(function.type)) continue;
        mutants.push_back(early_return(function, *body, gives_back ? given_back(function) : ""));
    }
    return numbered(std::move(mutants));
}

}

std::vector<Mutant> find_idle(const Syntax& syntax) { return early_returns(syntax, false); }

std::vector<Mutant> find_echo(const Syntax& syntax) { return early_returns(syntax, true); }

}
