#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "allowed.hpp"
#include "inputs.hpp"
#include "measure.hpp"
#include "sweeps.hpp"

namespace stability {
namespace {

// Whether each infinity stands where the oracle, rounded, has the same.
bool overflows_alike(const Answer& given, const Answer& right)
{
    if (given.size() != right.size()) return false;
    for (std::size_t i = 0; i < given.size(); ++i)
        if (!std::isfinite(given[i]) && given[i] != right[i]) return false;
    return true;
}

}

FiniteResult finite_sweep(std::uint32_t count, std::uint64_t seed)
{
    const std::vector<Call> calls = reference_calls();
    const std::vector<Call> oracles = oracle_calls();
    FiniteResult result{calls.size(), 0, 0, 0, {}};
    umbral::Random random(seed);
    for (std::size_t at = 0; at < calls.size(); ++at) {
        bool found = false;
        const std::uint64_t before = result.asked;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::optional<std::vector<float>> drawn =
                allowed(calls[at].name, extreme_numbers(calls[at].shape, random));
            if (!drawn) continue;
            const std::vector<float>& x = *drawn;
            ++result.asked;
            try {
                const Answer given = calls[at].answer(x);
                if (is_finite(given)) continue;
                if (overflows_alike(given, oracles[at].answer(x))) {
                    ++result.overflowed;
                } else if (!found) {
                    found = true;
                    result.escapes.push_back({calls[at].name, code_of(calls[at], x)});
                }
            } catch (const std::invalid_argument&) {
                ++result.refused;
            }
        }
        if (result.asked - before < count / 50)
            throw std::logic_error(fmt::format("{}: only {} of {} extreme questions are allowed (allowed.cpp)",
                                               calls[at].name, result.asked - before, count));
    }
    return result;
}

}
