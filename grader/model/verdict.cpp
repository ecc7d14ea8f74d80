#include "model/verdict.hpp"

#include "model/enum_names.hpp"

namespace umbral::grader {
namespace {

constexpr std::array verdict_names{
    EnumNames<Verdict>{Verdict::ok, "ok", "all right"},
    EnumNames<Verdict>{Verdict::partial, "partial", "partly right"},
    EnumNames<Verdict>{Verdict::wrong, "wrong", "wrong"},
    EnumNames<Verdict>{Verdict::not_implemented, "not_implemented", "not implemented yet"},
    EnumNames<Verdict>{Verdict::compile_error, "compile_error", "does not compile"},
    EnumNames<Verdict>{Verdict::interface_mismatch, "interface_mismatch", "does not match the interface"},
    EnumNames<Verdict>{Verdict::forbidden, "forbidden", "uses something forbidden"},
    EnumNames<Verdict>{Verdict::crashed, "crashed", "crashed"},
    EnumNames<Verdict>{Verdict::timeout, "timeout", "took too long"},
    EnumNames<Verdict>{Verdict::out_of_memory, "out_of_memory", "ran out of memory"},
    EnumNames<Verdict>{Verdict::blocked, "blocked", "stopped by the sandbox"},
    EnumNames<Verdict>{Verdict::missing, "missing", "not handed in"},
    EnumNames<Verdict>{Verdict::grader_fault, "grader_fault", "not scored: a fault of the grader"},
};

}

std::string_view to_string(Verdict verdict) { return names_of(verdict_names, verdict, "verdict").in_json; }

std::string_view in_words(Verdict verdict) { return names_of(verdict_names, verdict, "verdict").in_words; }

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

Verdict verdict_from(std::string_view name) { return value_named(verdict_names, name, "verdict"); }

}
