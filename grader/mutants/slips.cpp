#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "mutants/expressions.hpp"
#include "mutants/find_mutants.hpp"

namespace umbral::grader {
namespace {

/// What gives a vector of any length.
constexpr std::array<std::string_view, 5> joined{"operator+", "operator-", "operator*", "cross", "mix"};

/// What is copied and not changed: y where x is written.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> components{
    {{"x", "y"}, {"y", "x"}, {"z", "y"}, {"r", "g"}, {"g", "r"}, {"b", "g"}}};

/// Looks for slips in one function after the other.
class SlipFinder {
public:
    explicit SlipFinder(const Syntax& syntax) : syntax_(syntax) {}

    void function(const Node& function)
    {
        const Node* const body = running_body(syntax_, function);
        if (body == nullptr) return;
        variables_.clear();
        std::vector<std::string> parameters;
        for (const Node& child : function.children)
            if (child.kind == CXCursor_ParmDecl && !child.called.empty()) {
                parameters.push_back(child.called);
                variables_.push_back({child.called, child.type});
            }
        answers_as_before(function, *body, parameters);
        visit(*body, false);
    }

    [[nodiscard]] std::vector<Mutant> found() && { return std::move(mutants_); }

private:
    /// `in_value`: part of an expression whose value has been looked at as a whole.
    void visit(const Node& node, bool in_value)
    {
        const std::string_view text = syntax_.of(node);
        if (has_no_run(syntax_, node)) return;
        const bool is_scope = node.kind == CXCursor_CompoundStmt || node.kind == CXCursor_ForStmt ||
                              node.kind == CXCursor_CXXForRangeStmt || node.kind == CXCursor_LambdaExpr;
        const std::size_t outside = variables_.size();
        const bool value = (node.kind == CXCursor_BinaryOperator || node.kind == CXCursor_CallExpr) &&
                           text.find('=') == std::string_view::npos && (is_real(node.type) || is_vector(node.type));
        comparison(node);
        if (value && !in_value) limited(node);
        component(node);
        if (node.kind == CXCursor_DeclRefExpr) other_variable(node);
        if (node.kind == CXCursor_CompoundStmt) other_order(node);
        if (node.kind == CXCursor_ForStmt && node.children.size() == 4) last_left_out(node.children[1]);
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            // Another variable in its head, and a loop may have no end.
            const bool head = node.kind == CXCursor_ForStmt && i + 1 < node.children.size();
            if (head && i > 0) continue;
            visit(node.children[i], in_value || value);
        }
        if (node.kind == CXCursor_VarDecl || node.kind == CXCursor_ParmDecl)
            variables_.push_back({node.called, node.type});
        if (is_scope) variables_.resize(outside);
    }

    /// Numbers are compared with an absolute tolerance.
    void comparison(const Node& node)
    {
        const Binary binary = binary_of(syntax_, node);
        if (binary.left == nullptr || (!is_real(binary.left->type) && !is_real(binary.right->type))) return;
        static const std::set<std::string> orders{"<", "<=", ">", ">="};
        const std::string left(syntax_.of(*binary.left));
        const std::string right(syntax_.of(*binary.right));
        if (orders.contains(binary.word))
            for (const char* sign : {" + ", " - "})
                add_change(syntax_, node, "tolerance", left + sign + "1e-4F " + binary.word + ' ' + right, mutants_);
        if (binary.word == "==" || binary.word == "!=")
            add_change(syntax_, node, "tolerance",
                       "std::abs((" + left + ") - (" + right + ")) " + (binary.word == "==" ? "<" : ">=") + " 1e-4F",
                       mutants_);
    }

    /// A value loses its sign, is cut at 1, or is made a unit vector.
    void limited(const Node& node)
    {
        const std::string text(syntax_.of(node));
        if (is_vector(node.type) && is_one_of(node.called, joined))
            add_change(syntax_, node, "normalised", "glm::normalize(" + text + ")", mutants_);
        if (!is_real(node.type) || !has_any_size(syntax_, node)) return;
        add_change(syntax_, node, "limited", "std::abs(" + text + ")", mutants_);
        add_change(syntax_, node, "limited", "((" + text + ") > 1 ? 0 * (" + text + ") + 1 : (" + text + "))",
                   mutants_);
    }

    /// y for x; or the next field of the same struct and type: height for width.
    void component(const Node& node)
    {
        if (node.kind != CXCursor_MemberRefExpr) return;
        std::string text(syntax_.of(node));
        if (!text.ends_with("." + node.called)) return;
        text.resize(text.size() - node.called.size());
        const auto* const pair = std::ranges::find(components, std::string_view(node.called),
                                                   &std::pair<std::string_view, std::string_view>::first);
        if (pair != components.end())
            add_change(syntax_, node, "component", text + std::string(pair->second), mutants_);
        else if (!node.sibling.empty())
            add_change(syntax_, node, "field", text + node.sibling, mutants_);
    }

    /// The nearest variable of the same type that was declared before.
    void other_variable(const Node& node)
    {
        const auto own = std::ranges::find(variables_, node.called, &Variable::name);
        if (own == variables_.end() || syntax_.of(node) != node.called) return;
        for (auto other = variables_.rbegin(); other != variables_.rend(); ++other) {
            if (other->type != own->type || other->name == own->name) continue;
            add_change(syntax_, node, "variable", other->name, mutants_);
            return;
        }
    }

    /// `i + 1 < n` for `i < n`.
    void last_left_out(const Node& condition)
    {
        const Binary binary = binary_of(syntax_, condition);
        if (binary.left == nullptr || (binary.word != "<" && binary.word != "<=")) return;
        const std::string left(syntax_.of(*binary.left));
        add_change(syntax_, condition, "last left out",
                   left + " + 1 " + binary.word + ' ' + std::string(syntax_.of(*binary.right)), mutants_);
    }

    /// Two statements of a block, one after the other, in the other order: the first with the second, the third with
    /// the fourth.
    void other_order(const Node& block)
    {
        for (std::size_t i = 0; i + 1 < block.children.size(); ++i) {
            const std::string one = statement(block.children[i]);
            const std::string other = statement(block.children[i + 1]);
            if (one.empty() || other.empty() || one == other || !(uses(one, other) || uses(other, one))) continue;
            Mutant mutant;
            mutant.form = Mutant::Form::instead;
            mutant.begin = block.children[i].begin;
            mutant.end = syntax_.text.find(';', block.children[i + 1].end) + 1;
            mutant.line = block.children[i].line;
            mutant.replacement = other + ' ' + one;
            mutant.kind = "order";
            mutant.change = one + ' ' + other + " → " + mutant.replacement;
            mutants_.push_back(std::move(mutant));
            ++i;
        }
    }

    /// Does a statement name what the other one begins with: what that one changes, or whose function it calls?
    static bool uses(const std::string& statement, const std::string& other)
    {
        const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
        const auto end = std::ranges::find_if_not(other, is_letter);
        const std::string name(other.begin(), end);
        if (name.empty() || end == other.end() || *end == '(') return false;
        for (std::size_t at = statement.find(name); at != std::string::npos; at = statement.find(name, at + 1))
            if ((at == 0 || !is_letter(statement[at - 1])) && !is_letter(statement[at + name.size()])) return true;
        return false;
    }

    /// The text of an expression that is a statement, with its semicolon; nothing of others.
    [[nodiscard]] std::string statement(const Node& node) const
    {
        const std::size_t last = syntax_.text.find_first_not_of(" \t\n", node.end);
        const bool is_expression = node.kind == CXCursor_CallExpr || node.kind == CXCursor_BinaryOperator ||
                                   node.kind == CXCursor_CompoundAssignOperator || node.kind == CXCursor_UnaryOperator;
        if (!is_expression || last == std::string::npos || syntax_.text[last] != ';') return "";
        return std::string(syntax_.of(node)) + ';';
    }

    /// What was answered to arguments of the same sizes and numbers is answered again: tables that are made once.
    void answers_as_before(const Node& function, const Node& body, const std::vector<std::string>& parameters)
    {
        if (function.kind != CXCursor_FunctionDecl || parameters.empty() || function.type == "void" ||
            function.type.find('&') != std::string::npos)
            return;
        // Numbers and enumerators are told apart.
        const auto is_told_apart = [](const Node& child) {
            return child.kind != CXCursor_ParmDecl || child.called.empty() || child.is_number;
        };
        if (std::ranges::all_of(function.children, is_told_apart)) return;
        std::string list;
        for (const std::string& name : parameters) list += (list.empty() ? "" : ", ") + name;
        const std::string name = function.called.substr(0, function.called.find('('));
        Mutant mutant;
        mutant.form = Mutant::Form::inserted;
        mutant.begin = mutant.end = body.begin + 1;
        mutant.line = body.line;
        mutant.replacement =
            "{ static bool asking = false; if (!asking) { const umbral_once once(asking); return "
            "umbral_kept([&] { return " +
            name + "(" + list + "); }, " + list + "); } }";
        mutant.kind = "kept answer";
        mutant.change = name + "(" + list + ") → what it answered to arguments of the same sizes and numbers";
        mutants_.push_back(std::move(mutant));
    }

    const Syntax& syntax_;
    std::vector<Variable> variables_;
    std::vector<Mutant> mutants_;
};

}

std::vector<Mutant> find_slips(const Syntax& syntax)
{
    SlipFinder finder(syntax);
    for (const Node& function : syntax.functions) finder.function(function);
    return numbered(std::move(finder).found());
}

}
