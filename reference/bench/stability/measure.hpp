#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "row.hpp"

namespace stability {

/// How far one form of a function was off.
struct Errors {
    double worst = 0;  ///< in the row's unit; infinite where the answer is not finite, or there is none
    double median = 0;
};

/// A row, measured.
struct Result {
    Row row;
    Call call;
    std::uint32_t asked = 0;  ///< questions whose right answer is a float
    Errors naive;
    Errors reference;
    double used = 0;           ///< the reference's worst error over what it may be off; more than 1 is a failure
    std::vector<float> worst;  ///< the question on which the reference was worst
    Answer naive_answer;       ///< there
    Answer reference_answer;
    Answer oracle_answer;
    std::vector<float> naive_worst;  ///< the question on which the textbook's formula was worst
    Answer naive_worst_answer;
    Answer naive_worst_oracle;
    bool naive_exceeds = false;  ///< whether the textbook's formula breaks what the header promises
};

/// Whether there is neither NaN nor infinity in it.
[[nodiscard]] bool is_finite(const Answer& answer);

/// The distance to the next float, of one as large as `value`.
[[nodiscard]] double ulp_of(float value);

/// How far an answer is off, in the row's unit.
[[nodiscard]] double error_of(Unit unit, const Answer& given, const Answer& right);

/// All rows on `count` questions each, the same for the same seed. Throws std::logic_error if a row has no call.
[[nodiscard]] std::vector<Result> measured(std::uint32_t count, std::uint64_t seed);

[[nodiscard]] std::string unit_text(Unit unit);

/// The functions with the references, and with the oracles, in one order.
[[nodiscard]] std::vector<Call> reference_calls();
[[nodiscard]] std::vector<Call> oracle_calls();

}
