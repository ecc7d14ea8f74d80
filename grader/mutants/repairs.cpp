#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "mutants/expressions.hpp"
#include "mutants/find_mutants.hpp"

namespace umbral::grader {
namespace {

using Text = std::string_view;

/// What breaks work and mends none.
constexpr std::array<Text, 4> only_breaks{"early return", "error not thrown", "kept answer", "float for double"};

/// So many other variables of the same type are tried, the nearest first.
constexpr std::size_t most_variables = 4;

constexpr std::array<Text, 3> letters[] = {{"x", "y", "z"}, {"r", "g", "b"}, {"s", "t", "p"}};

constexpr std::array<std::pair<Text, Text>, 4> turned_round{{{"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}}};

constexpr std::array<Text, 6> of_angles{"sin", "cos", "tan", "rotate", "angleAxis", "perspective"};

/// Looks for what may be missing, in one function after the other.
class RepairFinder {
public:
    explicit RepairFinder(const Syntax& syntax) : syntax_(syntax) {}

    void function(const Node& function)
    {
        const Node* const body = running_body(syntax_, function);
        if (body == nullptr) return;
        variables_.clear();
        for (const Node& child : function.children) declared(child);
        visit(*body);
    }

    [[nodiscard]] std::vector<Mutant> found() && { return std::move(mutants_); }

private:
    void visit(const Node& node)
    {
        if (has_no_run(syntax_, node)) return;
        const bool assigns = is_assignment(node);
        comparison(node);
        rounded(node);
        number(node);
        if (node.kind == CXCursor_CallExpr) angles(node);
        if (node.kind == CXCursor_ArraySubscriptExpr || node.called == "operator[]")
            mutate_index(syntax_, node, "- 1", mutants_);
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            const Node& child = node.children[i];
            visit(child);
            // What is written to is a place, not a value.
            if (!assigns || i > 0) value(child);
        }
        declared(node);
    }

    void declared(const Node& node)
    {
        if ((node.kind == CXCursor_VarDecl || node.kind == CXCursor_ParmDecl) && !node.called.empty())
            variables_.push_back({node.called, node.type});
    }

    [[nodiscard]] bool is_assignment(const Node& node) const
    {
        if (node.kind == CXCursor_CompoundAssignOperator) return true;
        if (node.kind == CXCursor_UnaryOperator)
            return syntax_.of(node).starts_with("++") || syntax_.of(node).starts_with("--") ||
                   syntax_.of(node).ends_with("++") || syntax_.of(node).ends_with("--") ||
                   syntax_.of(node).starts_with("&");
        return binary_of(syntax_, node).word == "=" || node.called == "operator=";
    }

    void add(const Node& node, const char* kind, const std::string& replacement)
    {
        add_change(syntax_, node, kind, replacement, mutants_);
    }

    /// A named or computed value: its sign, its length, its form.
    void value(const Node& node)
    {
        const bool named = node.kind == CXCursor_DeclRefExpr || node.kind == CXCursor_MemberRefExpr;
        const bool called = node.kind == CXCursor_CallExpr && !Text(node.called).starts_with("operator");
        const std::string text(syntax_.of(node));
        if (text.empty()) return;
        if (named || called) {
            if (is_real(node.type) || is_vector(node.type)) add(node, "sign", "-(" + text + ")");
            if (is_vector(node.type) && node.called != "normalize")
                add(node, "normalised", "glm::normalize(" + text + ")");
            if (is_matrix(node.type)) {
                add(node, "matrix", "glm::transpose(" + text + ")");
                add(node, "matrix", "glm::inverse(" + text + ")");
            }
        }
        if (named && is_real(node.type)) add(node, "root", "((" + text + ") * (" + text + "))");
        if (is_real(node.type) && has_any_size(syntax_, node))
            add(node, "limited", "((" + text + ") < 0 ? 0 * (" + text + ") : (" + text + "))");
        const bool computed = called || !binary_of(syntax_, node).word.empty();
        if (computed && !is_assignment(node) && (is_real(node.type) || is_vector(node.type))) {
            add(node, "factor", "(" + text + ") * 2.0F");
            add(node, "factor", "(" + text + ") * 0.5F");
        }
        if (called && is_real(node.type) && node.called == "dot") add(node, "root", "std::sqrt(" + text + ")");
        if (node.kind == CXCursor_BinaryOperator && is_integer(node.type) && !is_assignment(node)) {
            add(node, "one more or less", "(" + text + ") + 1");
            add(node, "one more or less", "(" + text + ") - 1");
        }
        if (node.kind == CXCursor_MemberRefExpr) component(node, text);
        if (node.kind == CXCursor_DeclRefExpr) variable(node, text);
    }

    void component(const Node& node, std::string text)
    {
        if (!text.ends_with("." + node.called)) return;
        text.resize(text.size() - node.called.size());
        for (const auto& family : letters)
            if (is_one_of(node.called, family))
                for (const Text other : family)
                    if (other != node.called) add(node, "component", text + std::string(other));
    }

    void variable(const Node& node, const std::string& text)
    {
        const auto own = std::ranges::find(variables_, node.called, &Variable::name);
        if (own == variables_.end() || text != node.called) return;
        std::set<std::string> tried{text};
        for (auto other = variables_.rbegin(); other != variables_.rend() && tried.size() <= most_variables; ++other)
            if (other->type == own->type && tried.insert(other->name).second) add(node, "variable", other->name);
    }

    void comparison(const Node& node)
    {
        const Binary binary = binary_of(syntax_, node);
        for (const auto& [one, other] : turned_round)
            if (binary.left != nullptr && binary.word == one)
                add(node, "comparison",
                    std::string(syntax_.of(*binary.left)) + ' ' + std::string(other) + ' ' +
                        std::string(syntax_.of(*binary.right)));
    }

    /// A whole number made real lies at the edge of its pixel, or is the pixel's centre; a real one is cut or rounded.
    void rounded(const Node& node)
    {
        if (node.kind != CXCursor_CXXStaticCastExpr && node.kind != CXCursor_CXXFunctionalCastExpr) return;
        const std::string text(syntax_.of(node));
        if (is_real(node.type)) {
            add(node, "half", text + " + 0.5F");
            add(node, "half", text + " - 0.5F");
        }
        const std::size_t bracket = text.find('(');
        if (!is_integer(node.type) || bracket == std::string::npos) return;
        const std::string inside = text.substr(bracket, text.size() - bracket);
        for (const char* name : {"std::floor", "std::ceil", "std::round"})
            add(node, "rounding", text.substr(0, bracket) + "(" + name + inside + ")");
    }

    void number(const Node& node)
    {
        const std::string text(syntax_.of(node));
        if (node.kind == CXCursor_IntegerLiteral) add(node, "constant", text + " - 1");
        if (node.kind != CXCursor_FloatingLiteral) return;
        add(node, "constant", text + " / 2");
        add(node, "sign", "-" + text);
    }

    /// Degrees for radians, half or twice an angle.
    void angles(const Node& node)
    {
        if (!is_one_of(node.called, of_angles)) return;
        for (const Node& child : node.children) {
            if (!is_real(child.type)) continue;
            const std::string text(syntax_.of(child));
            for (const char* before : {"glm::radians", "0.5F * ", "2 * "})
                add(child, "angle", before + ("(" + text + ")"));
        }
    }

    const Syntax& syntax_;
    std::vector<Variable> variables_;
    std::vector<Mutant> mutants_;
};

}

std::vector<Mutant> find_repairs(const Syntax& syntax)
{
    RepairFinder finder(syntax);
    for (const Node& function : syntax.functions) finder.function(function);
    std::vector<Mutant> all = std::move(finder).found();
    for (const auto& more : {find_mutants(syntax), find_slips(syntax)})
        std::ranges::copy_if(more, std::back_inserter(all),
                             [](const Mutant& mutant) { return !is_one_of(mutant.kind, only_breaks); });
    std::set<std::tuple<std::size_t, std::size_t, std::string>> seen;
    std::erase_if(
        all, [&](const Mutant& mutant) { return !seen.emplace(mutant.begin, mutant.end, mutant.replacement).second; });
    return numbered(std::move(all));
}

}
