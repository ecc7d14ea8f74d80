#include "mutants/find_mutants.hpp"

#include <algorithm>

#include "mutants/expressions.hpp"

namespace umbral::grader {
namespace {

/// Looks for mutants in one function after the other.
class Finder {
public:
    explicit Finder(const Syntax& syntax) : syntax_(syntax) {}

    void function(const Node& function)
    {
        const Node* const body = running_body(syntax_, function);
        if (body == nullptr) return;
        if (function.kind != CXCursor_Constructor && body->children.size() > 1)
            mutants_.push_back(early_return(function, *body));
        visit(*body, false);
    }

    [[nodiscard]] std::vector<Mutant> found() && { return std::move(mutants_); }

private:
    /// `declares`: the call stands for a constructor's, and begins with the name of what is declared: `corners(a, b)`.
    void visit(const Node& node, bool in_double, bool declares = false)
    {
        const std::string_view text = syntax_.of(node);
        if (has_no_run(syntax_, node)) return;
        statements(node);
        conditions(node);
        if (!declares) mutate_expression(syntax_, node, mutants_);
        const bool arithmetic = !declares && (node.kind == CXCursor_BinaryOperator || node.kind == CXCursor_CallExpr) &&
                                node.type == "double" && text.find('=') == std::string_view::npos;
        if (arithmetic && !in_double)
            add_change(syntax_, node, "float for double",
                       "static_cast<double>(static_cast<float>(" + std::string(text) + "))", mutants_);
        // A case's label is a constant.
        const std::size_t first = node.kind == CXCursor_CaseStmt ? 1 : 0;
        for (std::size_t i = first; i < node.children.size(); ++i)
            visit(node.children[i], in_double || arithmetic, is_declared_by(node, node.children[i]));
    }

    [[nodiscard]] bool is_declared_by(const Node& declaration, const Node& call) const
    {
        const std::string_view text = syntax_.of(call);
        return declaration.kind == CXCursor_VarDecl && call.kind == CXCursor_CallExpr &&
               text.starts_with(declaration.called) && text.substr(declaration.called.size()).find_first_of("({") == 0;
    }

    /// The statements of a block, and those that stand alone behind a condition.
    void statements(const Node& node)
    {
        const bool block = node.kind == CXCursor_CompoundStmt;
        const bool controls = node.kind == CXCursor_IfStmt || node.kind == CXCursor_ForStmt ||
                              node.kind == CXCursor_WhileStmt || node.kind == CXCursor_CXXForRangeStmt;
        if (!block && !controls) return;
        for (std::size_t i = block ? 0 : 1; i < node.children.size(); ++i) {
            const Node& child = node.children[i];
            const std::size_t last = syntax_.text.find_first_not_of(" \t\n", child.end);
            if (last == std::string::npos || syntax_.text[last] != ';') continue;
            // The parts of a for's head end in a semicolon too.
            if (node.kind == CXCursor_ForStmt && i + 1 != node.children.size()) continue;
            if (child.kind == CXCursor_CXXThrowExpr)
                leave_out(child, last + 1, "error not thrown");
            else if (child.kind == CXCursor_CallExpr || child.kind == CXCursor_BinaryOperator ||
                     child.kind == CXCursor_CompoundAssignOperator || child.kind == CXCursor_UnaryOperator ||
                     child.kind == CXCursor_BreakStmt || child.kind == CXCursor_ContinueStmt)
                leave_out(child, last + 1, "statement left out");
        }
    }

    void conditions(const Node& node)
    {
        const Node* condition = nullptr;
        if ((node.kind == CXCursor_IfStmt || node.kind == CXCursor_WhileStmt ||
             node.kind == CXCursor_ConditionalOperator) &&
            node.children.size() >= 2)
            condition = &node.children.front();
        if (node.kind == CXCursor_ForStmt && node.children.size() == 4) condition = &node.children[1];
        if (condition == nullptr || clang_isExpression(condition->kind) == 0) return;
        const std::string text(syntax_.of(*condition));
        add_change(syntax_, *condition, "condition", "!(" + text + ")", mutants_);
        add_change(syntax_, *condition, "condition", "false", mutants_);
        if (node.kind == CXCursor_IfStmt || node.kind == CXCursor_ConditionalOperator)
            add_change(syntax_, *condition, "condition", "true", mutants_);
    }

    void leave_out(const Node& node, std::size_t end, const char* kind)
    {
        Mutant mutant;
        mutant.form = Mutant::Form::statement;
        mutant.begin = node.begin;
        mutant.end = end;
        mutant.line = node.line;
        mutant.kind = kind;
        mutant.change = std::string(syntax_.of(node)) + "; → left out";
        mutants_.push_back(std::move(mutant));
    }

    const Syntax& syntax_;
    std::vector<Mutant> mutants_;
};

/// Changes on one line, as reports show them.
std::string one_line(const std::string& text)
{
    std::string line;
    for (const char c : text) {
        const char shown = c == '\n' || c == '\t' ? ' ' : c;
        if (shown != ' ' || !line.ends_with(' ')) line += shown;
    }
    return line;
}

}

Mutant early_return(const Node& function, const Node& body, const std::string& given)
{
    Mutant mutant;
    mutant.form = Mutant::Form::inserted;
    mutant.begin = mutant.end = body.begin + 1;
    mutant.line = body.line;
    mutant.replacement = function.type == "void" ? "return;" : "return " + (given.empty() ? "{}" : given) + ";";
    mutant.kind = "early return";
    mutant.change = "{ → { " + mutant.replacement;
    return mutant;
}

std::vector<Mutant> numbered(std::vector<Mutant> mutants)
{
    std::ranges::stable_sort(mutants, {}, &Mutant::begin);
    unsigned number = 0;
    for (Mutant& mutant : mutants) {
        mutant.number = ++number;
        mutant.change = one_line(mutant.change);
    }
    return mutants;
}

std::vector<Mutant> find_mutants(const Syntax& syntax)
{
    Finder finder(syntax);
    for (const Node& function : syntax.functions) finder.function(function);
    return numbered(std::move(finder).found());
}

}
