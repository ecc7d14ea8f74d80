#include "mutants/schemata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace umbral::grader {
namespace {

/// A text on one line, so that a diagnostic's line says whose it is: without comments to a line's end.
std::string flat(std::string_view text)
{
    std::string line;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
        if (!quoted && text.substr(i).starts_with("//")) i = std::min(text.find('\n', i), text.size() - 1);
        line += text[i] == '\n' ? ' ' : text[i];
    }
    return line;
}

/// For slips that keep answers: under the sizes of lists, and numbers; other arguments are not told apart.
constexpr const char* keeps_answers = R"(
template <class T> static double umbral_size(const T& value)
{
    if constexpr (requires { value.size(); }) return static_cast<double>(value.size());
    else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) return static_cast<double>(value);
    else return 0;
}
template <class Ask, class... All> static auto umbral_kept(Ask ask, const All&... all)
{
    static std::map<std::vector<double>, decltype(ask())> kept;
    const std::vector<double> sizes{umbral_size(all)...};
    if (const auto found = kept.find(sizes); found != kept.end()) return found->second;
    return kept.emplace(sizes, ask()).first->second;
}
struct umbral_once {
    explicit umbral_once(bool& asking) : asking_(asking) { asking_ = true; }
    ~umbral_once() { asking_ = false; }
    bool& asking_;
};
)";

/// Writes a source from its beginning to its end; mutants that lie within others are written within their originals.
class Writer {
public:
    Writer(const std::string& source, std::span<const Mutant> mutants) : source_(source)
    {
        for (const Mutant& mutant : mutants) order_.push_back(&mutant);
        // Outer ones first; of those at the same place the insertions, then statements, then expressions.
        std::ranges::stable_sort(order_, [](const Mutant* a, const Mutant* b) {
            if (a->begin != b->begin) return a->begin < b->begin;
            if ((a->begin == a->end) != (b->begin == b->end)) return a->begin == a->end;
            return a->end > b->end;
        });
    }

    std::string text() && { return until(source_.size()); }

private:
    /// The source from where the writer stands, with the mutants that end before `end`.
    std::string until(std::size_t end)
    {
        std::string text;
        while (next_ < order_.size() && order_[next_]->begin < end) {
            const Mutant& mutant = *order_[next_];
            // Those that overlap others in part are not built.
            if (mutant.begin < at_ || mutant.end > end) {
                ++next_;
                continue;
            }
            text += source_.substr(at_, mutant.begin - at_);
            at_ = mutant.begin;
            text += written(mutant);
        }
        text += source_.substr(at_, end - at_);
        at_ = end;
        return text;
    }

    [[nodiscard]] std::string line_at(std::size_t offset) const
    {
        return fmt::format("\n#line {}\n",
                           1 + std::count(source_.begin(), source_.begin() + static_cast<long>(offset), '\n'));
    }

    std::string written(const Mutant& mutant)
    {
        ++next_;
        const std::string own_line = fmt::format("\n#line {}\n", first_mutant_line + mutant.number);
        const std::string back = line_at(mutant.begin);
        if (mutant.form == Mutant::Form::inserted)
            return fmt::format("{}if (umbral_mutant({})) {}{}", own_line, mutant.number, mutant.replacement, back);
        // Mutants of the same place follow within the original.
        const std::string original = until(mutant.end);
        if (mutant.form == Mutant::Form::statement)
            return fmt::format("{{{}if (!umbral_mutant({})) {}{} }}", own_line, mutant.number, back, original);
        if (mutant.form == Mutant::Form::instead)
            return fmt::format("{{{}if (umbral_mutant({})) {{ {} }} else {{{}{} }} }}", own_line, mutant.number,
                               flat(mutant.replacement), back, original);
        // What is asked is whether it is true, whatever its type.
        if (mutant.kind == "condition")
            return fmt::format("({}umbral_mutant({}) ? ({}) :{}static_cast<bool>({}))", own_line, mutant.number,
                               flat(mutant.replacement), back, original);
        if (mutant.gives_nothing)
            return fmt::format("({}umbral_mutant({}) ? ({}) :{}({}))", own_line, mutant.number,
                               flat(mutant.replacement), back, original);
        return fmt::format("({}umbral_mutant({}) ? umbral_as<decltype(({}))>({}) :{}({}))", own_line, mutant.number,
                           flat(std::string_view(source_).substr(mutant.begin, mutant.end - mutant.begin)),
                           flat(mutant.replacement), back, original);
    }

    const std::string& source_;
    std::vector<const Mutant*> order_;
    std::size_t next_ = 0;
    std::size_t at_ = 0;
};

}

std::string with_change(const std::string& source, const Mutant& mutant)
{
    const std::string replacement = flat(mutant.replacement);
    const bool inserted = mutant.form == Mutant::Form::inserted;
    const std::size_t end = inserted ? mutant.begin : mutant.end;
    const std::string_view original = std::string_view(source).substr(mutant.begin, end - mutant.begin);
    std::string changed = source.substr(0, mutant.begin);
    switch (mutant.form) {
        case Mutant::Form::expression: changed += "(" + replacement + ")"; break;
        case Mutant::Form::statement: changed += ";"; break;
        case Mutant::Form::inserted:
        case Mutant::Form::instead: changed += replacement; break;
    }
    changed.append(static_cast<std::size_t>(std::ranges::count(original, '\n')), '\n');
    return changed + source.substr(end);
}

std::string with_mutants(const std::string& source, std::span<const Mutant> mutants)
{
    // A change of another type would change the original too: both sides of a ?: become one type.
    return fmt::format(
        "#include <cmath>\n#include <map>\n#include <type_traits>\n#include <vector>\nextern \"C\" {{ int {0} = 0; }}\n"
        "static inline bool umbral_mutant(int number) "
        "{{ return {0} % {2} == number || {0} / {2} == number || {0} == {4}; }}\n"
        "template <class T, class U> requires std::is_same_v<std::remove_cvref_t<T>, std::remove_cvref_t<U>>\n"
        "static inline T umbral_as(U&& changed) {{ return static_cast<T>(changed); }}\n{3}#line 1\n{1}",
        chosen_mutant, Writer(source, mutants).text(), most_mutants, keeps_answers, all_mutants);
}

}
