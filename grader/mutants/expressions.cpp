#include "mutants/expressions.hpp"

#include <array>

namespace umbral::grader {
namespace {

constexpr std::array<std::string_view, 8> of_any_size{"determinant", "tan", "atan", "atan2",
                                                      "pow",         "mix", "lerp", "fma"};

std::string trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

}

bool has_any_size(const Syntax& syntax, const Node& node)
{
    if (node.kind == CXCursor_BinaryOperator) return true;
    if (node.called == "dot" && node.children.size() > 2)
        return syntax.of(node.children[node.children.size() - 1]) != syntax.of(node.children[node.children.size() - 2]);
    return is_one_of(node.called, of_any_size);
}

const Node* running_body(const Syntax& syntax, const Node& function)
{
    if (function.children.empty() || function.children.back().kind != CXCursor_CompoundStmt) return nullptr;
    const Node& body = function.children.back();
    const std::string_view head = std::string_view(syntax.text).substr(function.begin, body.begin - function.begin);
    const bool computed =
        head.find("constexpr") != std::string_view::npos || head.find("consteval") != std::string_view::npos;
    return computed ? nullptr : &body;
}

bool has_no_run(const Syntax& syntax, const Node& node)
{
    const std::string_view text = syntax.of(node);
    return node.kind == CXCursor_StaticAssert || node.kind == CXCursor_TypeAliasDecl ||
           (node.kind == CXCursor_DeclStmt &&
            (text.starts_with("constexpr") || text.starts_with("static") || text.starts_with("using")));
}

Binary binary_of(const Syntax& syntax, const Node& node)
{
    const bool overloaded = node.kind == CXCursor_CallExpr && std::string_view(node.called).starts_with("operator");
    if (node.kind != CXCursor_BinaryOperator && node.kind != CXCursor_CompoundAssignOperator && !overloaded) return {};
    std::vector<const Node*> operands;
    for (const Node& child : node.children)
        if (!overloaded || child.called != node.called || child.end - child.begin > 3) operands.push_back(&child);
    if (operands.size() != 2 || operands[0]->end > operands[1]->begin) return {};
    const std::string_view between =
        std::string_view(syntax.text).substr(operands[0]->end, operands[1]->begin - operands[0]->end);
    return {operands[0], operands[1], trimmed(between)};
}

void add_change(const Syntax& syntax, const Node& node, const char* kind, const std::string& replacement,
                std::vector<Mutant>& mutants)
{
    Mutant mutant;
    mutant.begin = node.begin;
    mutant.end = node.end;
    mutant.line = node.line;
    mutant.replacement = replacement;
    mutant.kind = kind;
    mutant.change = std::string(syntax.of(node)) + " → " + replacement;
    mutant.gives_nothing = node.type == "void";
    mutants.push_back(std::move(mutant));
}

}
