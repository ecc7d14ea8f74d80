#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "build/submission.hpp"
#include "build/toolchain.hpp"
#include "model/exercise.hpp"
#include "model/verdict.hpp"
#include "run/fresh_memory.hpp"

namespace umbral::grader {

/// What a student's files became.
struct Built {
    Verdict verdict = Verdict::grader_fault;  ///< ok, or why it cannot run
    std::string message;                      ///< diagnostics for the student; if ok, warnings
    std::filesystem::path library;            ///< empty for a unit without C++, or if not ok
    unsigned mutant = 0;                      ///< of the library's mutants the one to run (mutants/); none is 0
    Sources sources;                          ///< the texts that are not C++, for the run
    Sources files;                            ///< all that it was built from; empty of an adopted library
    FreshMemory fresh_memory = FreshMemory::nonsense;  ///< in its runs
    bool keeps_nothing = false;  ///< it has no variables in which a call could leave something for the next one
    std::string mistake;  ///< the unit's known mistake that it is, whose runs serve explanations too; empty for none
    double compile_seconds = 0;            ///< of processor time that it took to compile, when that was
    std::shared_ptr<UnitBudget> budget{};  ///< for what is compiled of the files later: with_zeros.hpp
    bool repeatable = true;  ///< would it come out so on every machine? Not if the compiler ran out of time, or failed
                             ///< without saying why
};

/// Turns a unit's files into a library that defines the unit and can override nothing else. Results, also bad ones, are
/// kept by content, if they are repeatable: the same files, flags and headers are compiled once. Several threads and
/// processes may build at the same time. Throws std::runtime_error only for faults of the grader's.
[[nodiscard]] Built build(const Toolchain& tools, const Exercise& exercise, const Sources& files);

/// The same from a library that CMake made of the files as a student's library is made: one of the unit's mistakes. It
/// is looked at like a student's, but for what only sources show. Nothing is kept.
[[nodiscard]] Built adopt(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                          const std::filesystem::path& library);

}
