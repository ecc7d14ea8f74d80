#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stability {

/// A relation between two answers that holds whatever the right answer is.
struct Relation {
    const char* function;  ///< of a call
    const char* holds;     ///< in words
    void (*change)(std::vector<float>& question);
    void (*expect)(std::vector<float>& answer);  ///< what the first answer must become
    double ulps;                                 ///< of the answer's largest number: roundings on both sides; 0: exact
};

struct SweepResult {
    Relation relation;
    std::uint32_t asked;
    double worst;          ///< in ulps of the answer's largest number
    std::vector<float> x;  ///< the worst question
};

[[nodiscard]] std::vector<SweepResult> swept(std::uint32_t count, std::uint64_t seed);

/// Questions of finite numbers whose answers hold a NaN or an infinity that the header does not announce.
struct Escape {
    std::string function;
    std::string code;
};

/// What asking each function `count` extreme questions gave.
struct FiniteResult {
    std::size_t functions;
    std::uint64_t asked;
    std::uint64_t refused;     ///< by std::invalid_argument
    std::uint64_t overflowed;  ///< the right answer is larger than any float: infinity is right, and so says the oracle
    std::vector<Escape> escapes;  ///< at most one a function
};

[[nodiscard]] FiniteResult finite_sweep(std::uint32_t count, std::uint64_t seed);

}
