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

}

std::vector<Mutant> find_idle(const Syntax& syntax)
{
    std::vector<Mutant> mutants;
    for (const Node& function : syntax.functions) {
        const Node* const body = running_body(syntax, function);
        if (body == nullptr || body->children.empty() || makes_an_object(function.type)) continue;
        mutants.push_back(early_return(function, *body));
    }
    return numbered(std::move(mutants));
}

}
