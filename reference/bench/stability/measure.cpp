#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "calls.hpp"
#include "inputs.hpp"

// The calls that were compiled with the oracles: see CMakeLists.txt.
namespace umbral_oracle::bench {
std::vector<stability::Call> all_calls();
}

namespace stability {
namespace {

double unit_at(Unit unit, const Answer& right, std::size_t at)
{
    if (unit == Unit::absolute) return 1;
    if (unit == Unit::ulps) return ulp_of(right[at]);
    float largest = 0;
    for (const float value : right) largest = std::max(largest, std::abs(value));
    return ulp_of(largest);
}

// The part of what it may be off that an answer uses; half an ulp is the oracle's own rounding.
double used_by(const Row& row, Numbers x, const Answer& given, const Answer& right)
{
    if (given.size() != right.size() || !is_finite(given)) return std::numeric_limits<double>::infinity();
    double used = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const double may =
            row.bound * unit_at(row.unit, right, i) + ulp_of(right[i]) / 2 + (row.slack == nullptr ? 0 : row.slack(x));
        used = std::max(used, std::abs(double{given[i]} - right[i]) / may);
    }
    return used;
}

double median_of(std::vector<double>& all)
{
    if (all.empty()) return 0;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

std::size_t place_of(const std::vector<Call>& calls, const std::string& name)
{
    const auto found = std::ranges::find_if(calls, [&](const Call& call) { return call.name == name; });
    if (found == calls.end()) throw std::logic_error("the row " + name + " has no call of this name");
    return static_cast<std::size_t>(found - calls.begin());
}

Result measured_row(const Row& row, const Call& reference, const Call& oracle, std::uint32_t count, std::uint64_t seed)
{
    Result result{row, reference, 0, {}, {}, -1, {}, {}, {}, {}, {}, {}, {}, false};
    std::vector<double> naive_errors;
    std::vector<double> errors;
    umbral::Random random(seed);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<float> x = drawn_numbers(reference.shape, random);
        if (row.repair != nullptr) row.repair(x, random);
        const Answer right = oracle.answer(x);
        if (right.empty() || !is_finite(right)) continue;
        ++result.asked;
        const Answer given = reference.answer(x);
        errors.push_back(error_of(row.unit, given, right));
        result.reference.worst = std::max(result.reference.worst, errors.back());
        const Answer naive = row.naive == nullptr ? Answer{} : row.naive(x);
        if (const double used = used_by(row, x, given, right); used > result.used) {
            result.used = used;
            result.worst = x;
            result.naive_answer = naive;
            result.reference_answer = given;
            result.oracle_answer = right;
        }
        if (row.naive == nullptr) continue;
        naive_errors.push_back(error_of(row.unit, naive, right));
        if (used_by(row, x, naive, right) > 1) result.naive_exceeds = true;
        if (naive_errors.back() > result.naive.worst || result.naive_worst.empty()) {
            result.naive.worst = naive_errors.back();
            result.naive_worst = x;
            result.naive_worst_answer = naive;
            result.naive_worst_oracle = right;
        }
    }
    result.naive.median = median_of(naive_errors);
    result.reference.median = median_of(errors);
    return result;
}

}

bool is_finite(const Answer& answer)
{
    return std::ranges::all_of(answer, [](float value) { return std::isfinite(value); });
}

double ulp_of(float value)
{
    const float size = std::abs(value);
    return std::max(double{std::numeric_limits<float>::denorm_min()},
                    double{std::nextafter(size, std::numeric_limits<float>::infinity())} - size);
}

double error_of(Unit unit, const Answer& given, const Answer& right)
{
    if (given.size() != right.size() || !is_finite(given)) return std::numeric_limits<double>::infinity();
    double worst = 0;
    for (std::size_t i = 0; i < given.size(); ++i)
        worst = std::max(worst, std::abs(double{given[i]} - right[i]) / unit_at(unit, right, i));
    return worst;
}

std::vector<Result> measured(std::uint32_t count, std::uint64_t seed)
{
    const std::vector<Call> references = reference_calls();
    const std::vector<Call> oracles = oracle_calls();
    std::vector<Result> results;
    for (const Row& row : all_rows()) {
        const std::size_t at = place_of(references, row.name);
        results.push_back(measured_row(row, references[at], oracles[at], count, seed));
    }
    return results;
}

std::string unit_text(Unit unit)
{
    return unit == Unit::ulps ? "ulp" : unit == Unit::absolute ? "absolute" : "ulp of the largest";
}

std::vector<Call> reference_calls() { return umbral::bench::all_calls(); }
std::vector<Call> oracle_calls() { return umbral_oracle::bench::all_calls(); }

}
