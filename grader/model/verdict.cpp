#include "model/verdict.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace umbral::grader {
namespace {

struct Names {
    Verdict verdict;
    std::string_view in_json;
    std::string_view in_words;
};

constexpr std::array names{
    Names{Verdict::ok, "ok", "all right"},
    Names{Verdict::partial, "partial", "partly right"},
    Names{Verdict::wrong, "wrong", "wrong"},
    Names{Verdict::not_implemented, "not_implemented", "not implemented yet"},
    Names{Verdict::compile_error, "compile_error", "does not compile"},
    Names{Verdict::interface_mismatch, "interface_mismatch", "does not match the interface"},
    Names{Verdict::forbidden, "forbidden", "uses something forbidden"},
    Names{Verdict::crashed, "crashed", "crashed"},
    Names{Verdict::timeout, "timeout", "took too long"},
    Names{Verdict::out_of_memory, "out_of_memory", "ran out of memory"},
    Names{Verdict::blocked, "blocked", "stopped by the sandbox"},
    Names{Verdict::missing, "missing", "not handed in"},
    Names{Verdict::grader_fault, "grader_fault", "not scored: a fault of the grader"},
};

const Names& names_of(Verdict verdict)
{
    for (const Names& candidate : names)
        if (candidate.verdict == verdict) return candidate;
    throw std::invalid_argument("verdict: expected one of the " + std::to_string(names.size()) +
                                " declared ones, got number " + std::to_string(static_cast<int>(verdict)));
}

}

std::string_view to_string(Verdict verdict) { return names_of(verdict).in_json; }

std::string_view in_words(Verdict verdict) { return names_of(verdict).in_words; }

bool never_ran(Verdict verdict)
{
    switch (verdict) {
        case Verdict::missing:
        case Verdict::compile_error:
        case Verdict::interface_mismatch:
        case Verdict::forbidden:
        case Verdict::not_implemented:
        case Verdict::grader_fault: return true;
        default: return false;
    }
}

Verdict verdict_from(std::string_view name)
{
    std::string known;
    for (const Names& candidate : names) {
        if (candidate.in_json == name) return candidate.verdict;
        known += (known.empty() ? "" : ", ") + std::string(candidate.in_json);
    }
    throw std::invalid_argument("verdict: expected one of " + known + ", got '" + std::string(name) + "'");
}

}
