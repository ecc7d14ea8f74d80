#include "build/check_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "build/allowed.hpp"
#include "build/counted.hpp"
#include "build/forbidden.hpp"
#include "build/spelling.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

/// "umbral::raytracing::intersect" of "umbral::raytracing::intersect(umbral::Ray const&)".
std::string without_arguments(const std::string& signature) { return signature.substr(0, signature.find('(')); }

std::optional<Objection> missing_interface(const Inspection& inspection)
{
    if (inspection.missing.empty()) return std::nullopt;
    const std::string& declared = inspection.missing.front();
    const std::string bare(last_name(without_arguments(declared)));
    std::vector<std::string> written;
    for (const InspectedFunction& function : inspection.functions)
        if (function.name.find('(') != std::string::npos && last_name(without_arguments(function.name)) == bare)
            written.push_back(as_written(function.name));
    if (written.empty())
        return Objection{Verdict::interface_mismatch,
                         fmt::format("your file does not define {}, which the header declares", as_written(declared))};
    return Objection{Verdict::interface_mismatch,
                     fmt::format("you wrote {}; the header declares {}: make them equal, namespace and const included",
                                 listed(written), as_written(declared))};
}

}

std::optional<Objection> object_to(const Inspection& inspection, const Offered& offered, const Exercise& exercise)
{
    // A forbidden name comes first: it is the reason to tell, even if the interface is wrong as well.
    if (auto forbidden = find_forbidden(inspection, exercise.forbid))
        return Objection{Verdict::forbidden, *std::move(forbidden)};
    if (auto foreign = find_of_other_units(inspection, offered))
        return Objection{Verdict::forbidden, *std::move(foreign)};
    if (auto missing = missing_interface(inspection)) return missing;
    if (exercise.counts_work && !inspection.uncounted.empty())
        return Objection{Verdict::forbidden, fmt::format("{}: the work of this unit is counted, and all of it must be; "
                                                         "write its functions in plain C++, without "
                                                         "attributes, assembler or a counter of your own",
                                                         listed(inspection.uncounted))};
    std::vector<std::string> wanted;
    // A counted call that was not replaced is a way around the count: `__real_memmove`, say.
    const auto evades = [&](const std::string& name) {
        return exercise.counts_work && std::ranges::find(counted_calls, name) != counted_calls.end();
    };
    std::string reason;
    for (const InspectedSymbol& symbol : inspection.undefined) {
        const bool allowed =
            is_allowed_symbol(symbol.name, exercise.gl_calls, exercise.glfw) || offered.symbols.contains(symbol.name);
        if (allowed && !evades(symbol.name)) continue;
        wanted.push_back(symbol.readable);
        const std::string_view what = what_is_wrong_with(symbol.name);
        if (reason.empty() && !what.empty()) reason = fmt::format("; {} {}", symbol.readable, what);
    }
    if (wanted.empty()) return std::nullopt;
    return Objection{
        Verdict::forbidden,
        fmt::format("{}: no unit may call {}{}; allowed are the C++ library, mathematics, C functions that "
                    "compute, the framework and the units this one uses",
                    listed(wanted), wanted.size() == 1 ? "it" : "them", reason)};
}

std::optional<Objection> check_words(const Sources& files, const Exercise& exercise)
{
    for (const auto& [file, text] : files) {
        const std::string bare = without_comments(text);
        // Two halves make a forbidden name for whoever compiles, and none for whoever reads.
        if (!exercise.forbid.empty() && bare.find("##") != std::string::npos)
            return Objection{Verdict::forbidden,
                             fmt::format("{}: words put together by ## are not allowed in this unit", one_line(file))};
        for (const std::string& name : exercise.forbid)
            if (holds_word(bare, name))
                return Objection{Verdict::forbidden,
                                 fmt::format("{}: {} is not allowed in this unit", one_line(file), name)};
    }
    return std::nullopt;
}

}
