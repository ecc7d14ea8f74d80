#include <algorithm>
#include <array>
#include <utility>

#include "mutants/expressions.hpp"
#include "mutants/find_mutants.hpp"

namespace umbral::grader {
namespace {

using Text = std::string_view;

/// What stands for an operator instead, and what such a change is called.
struct Exchange {
    Text one;
    Text other;
    const char* kind;
};

constexpr Exchange operators[] = {
    {"<", "<=", "comparison"},  {"<=", "<", "comparison"},  {">", ">=", "comparison"},  {">=", ">", "comparison"},
    {"==", "!=", "comparison"}, {"!=", "==", "comparison"}, {"+", "-", "arithmetic"},   {"-", "+", "arithmetic"},
    {"*", "/", "arithmetic"},   {"/", "*", "arithmetic"},   {"%", "/", "arithmetic"},   {"&&", "||", "logic"},
    {"||", "&&", "logic"},      {"&", "|", "bits"},         {"|", "&", "bits"},         {"<<", ">>", "bits"},
    {">>", "<<", "bits"},       {"+=", "-=", "arithmetic"}, {"-=", "+=", "arithmetic"}, {"*=", "/=", "arithmetic"},
    {"/=", "*=", "arithmetic"}, {"|=", "&=", "bits"},       {"&=", "|=", "bits"}};

constexpr std::pair<Text, Text> functions[] = {{"sin", "cos"},    {"cos", "sin"},    {"min", "max"},   {"max", "min"},
                                               {"floor", "ceil"}, {"ceil", "floor"}, {"asin", "acos"}, {"acos", "asin"},
                                               {"sinh", "cosh"},  {"cosh", "sinh"}};

/// Functions that their first argument may stand for: what is forgotten when one of them is left out.
constexpr std::array<Text, 17> droppable{"clamp",     "normalize", "normalise", "abs",  "fabs",  "floor",
                                         "ceil",      "round",     "fract",     "sqrt", "mod",   "fmod",
                                         "transpose", "inverse",   "copysign",  "fma",  "length"};

/// Functions that give the same whichever argument comes first.
bool is_symmetric(Text name)
{
    return name == "dot" || name == "min" || name == "max" || name == "hypot" || name == "distance";
}

bool is_operator(Text text)
{
    return std::ranges::any_of(operators, [&](const Exchange& one) { return one.one == text; });
}

void mutate_binary(const Syntax& syntax, const Node& node, const Binary& binary, std::vector<Mutant>& mutants)
{
    const std::string left(syntax.of(*binary.left));
    const std::string right(syntax.of(*binary.right));
    // Texts are joined, and nothing else.
    const bool text = node.type.find("basic_string") != std::string::npos;
    if (text && binary.word == "+") return;
    for (const Exchange& one : operators)
        if (one.one == binary.word)
            add_change(syntax, node, one.kind, left + ' ' + std::string(one.other) + ' ' + right, mutants);
    // One of two parts left out.
    const bool sum = binary.word == "+" || binary.word == "-";
    if (sum || binary.word == "*" || binary.word == "/") {
        add_change(syntax, node, sum ? "term left out" : "factor left out", left, mutants);
        if (binary.word == "+" || binary.word == "*")
            add_change(syntax, node, sum ? "term left out" : "factor left out", right, mutants);
    }
    if (binary.word == "&&" || binary.word == "||") {
        add_change(syntax, node, "term left out", left, mutants);
        add_change(syntax, node, "term left out", right, mutants);
    }
}

/// The arguments of a call: what lies behind the opening bracket.
std::vector<const Node*> arguments_of(const Syntax& syntax, const Node& call, std::size_t& bracket)
{
    std::vector<const Node*> arguments;
    std::size_t from = call.begin;
    // The callee, which may be qualified or a member's.
    if (!call.children.empty() && call.children.front().called == call.called &&
        (call.children.front().kind == CXCursor_DeclRefExpr || call.children.front().kind == CXCursor_MemberRefExpr))
        from = call.children.front().end;
    bracket = syntax.text.find('(', from);
    if (bracket == std::string::npos || bracket >= call.end) return {};
    for (const Node& child : call.children)
        if (child.begin > bracket && child.end <= call.end && child.end > child.begin) arguments.push_back(&child);
    return arguments;
}

void mutate_call(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants)
{
    std::size_t bracket = 0;
    const std::vector<const Node*> arguments = arguments_of(syntax, node, bracket);
    const std::string whole(syntax.of(node));
    const auto inside = [&](std::size_t offset) { return offset - node.begin; };
    if (const std::size_t name = bracket - std::min(bracket, node.called.size());
        !node.called.empty() && bracket != std::string::npos && name >= node.begin &&
        Text(syntax.text).substr(name, node.called.size()) == node.called)
        for (const auto& [one, other] : functions)
            if (one == node.called) {
                std::string changed = whole;
                changed.replace(inside(name), one.size(), other);
                add_change(syntax, node, "function", changed, mutants);
            }
    if (!arguments.empty() && is_one_of(node.called, droppable))
        add_change(syntax, node, "call left out", std::string(syntax.of(*arguments.front())), mutants);
    if (arguments.size() == 2 && (node.called == "max" || node.called == "min"))
        for (const Node* argument : arguments)
            add_change(syntax, node, "call left out", std::string(syntax.of(*argument)), mutants);
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
        const Node& one = *arguments[i];
        const Node& other = *arguments[i + 1];
        if (is_symmetric(node.called) || one.type != other.type || syntax.of(one) == syntax.of(other) ||
            one.end > other.begin)
            continue;
        std::string changed = whole;
        changed.replace(inside(other.begin), other.end - other.begin, syntax.of(one));
        changed.replace(inside(one.begin), one.end - one.begin, syntax.of(other));
        add_change(syntax, node, "arguments exchanged", changed, mutants);
    }
}

void mutate_literal(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants)
{
    const std::string text(syntax.of(node));
    if (node.kind == CXCursor_CXXBoolLiteralExpr)
        add_change(syntax, node, "constant", text == "true" ? "false" : "true", mutants);
    else if (node.kind == CXCursor_IntegerLiteral)
        add_change(syntax, node, "constant", text + " + 1", mutants);
    else if (text.find_first_of("123456789") == std::string::npos)
        add_change(syntax, node, "constant", text + " + 1", mutants);
    else
        add_change(syntax, node, "constant", text + " * 2", mutants);
}

}

void mutate_index(const Syntax& syntax, const Node& node, const char* step, std::vector<Mutant>& mutants)
{
    if (node.children.size() < 2) return;
    const Node& index = node.children.back();
    const Node& base = node.children.front();
    if (index.begin < base.end || index.kind == CXCursor_IntegerLiteral) return;
    add_change(syntax, node, "index",
               std::string(syntax.of(base)) + "[" + std::string(syntax.of(index)) + ' ' + step + "]", mutants);
}

void mutate_expression(const Syntax& syntax, const Node& node, std::vector<Mutant>& mutants)
{
    const Binary binary = binary_of(syntax, node);
    if (binary.left != nullptr && is_operator(binary.word)) return mutate_binary(syntax, node, binary, mutants);
    const bool is_index =
        node.kind == CXCursor_ArraySubscriptExpr || (node.kind == CXCursor_CallExpr && node.called == "operator[]");
    const bool is_minus = (node.kind == CXCursor_UnaryOperator || node.called == "operator-") &&
                          node.end - node.begin > 1 && !syntax.of(node).starts_with("--") &&
                          syntax.of(node).starts_with("-");
    if (is_index) return mutate_index(syntax, node, "+ 1", mutants);
    if (is_minus) return add_change(syntax, node, "sign", std::string(syntax.of(node).substr(1)), mutants);
    if (node.kind == CXCursor_UnaryOperator && syntax.of(node).starts_with("!"))
        return add_change(syntax, node, "logic", std::string(syntax.of(node).substr(1)), mutants);
    if (node.kind == CXCursor_CallExpr && !Text(node.called).starts_with("operator"))
        return mutate_call(syntax, node, mutants);
    if (node.kind == CXCursor_IntegerLiteral || node.kind == CXCursor_FloatingLiteral ||
        node.kind == CXCursor_CXXBoolLiteralExpr)
        mutate_literal(syntax, node, mutants);
}

}
