#include <fmt/format.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

float running(std::span<const float> numbers)
{
    float sum = 0;
    for (const float number : numbers) sum += number;
    return sum;
}

float pairwise(std::span<const float> numbers)
{
    if (numbers.size() <= 8) return running(numbers);
    const std::size_t half = numbers.size() / 2;
    return pairwise(numbers.first(half)) + pairwise(numbers.subspan(half));
}

float compensated(std::span<const float> numbers)
{
    float sum = 0;
    float lost = 0;
    for (const float number : numbers) {
        const float term = number - lost;
        const float next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

float in_double(std::span<const float> numbers)
{
    double sum = 0;
    for (const float number : numbers) sum += double{number};
    return static_cast<float>(sum);
}

}

Knob measure_summation(Means& means)
{
    constexpr std::uint64_t seed = 20;
    const int repeats = means.quick ? 40 : 400;
    Study study = study_of("summation", "Adding up in float",
                           fmt::format("Sums of N uniform numbers in [0, 1), as an accumulated frame or a mean of "
                                       "samples makes them: {} sums each against one of long double; seed {}.",
                                       repeats, seed),
                           "ns per number", {{"rms", "relative error of the sum, RMS", "2⁻²⁴"}}, 1e9, "numbers");
    const std::vector<std::pair<std::string, float (*)(std::span<const float>)>> methods = {
        {"float", running}, {"pairwise", pairwise}, {"compensated", compensated}, {"double", in_double}};
    for (const int count : {100, 1000, 10'000, 100'000}) {
        Random random(seed);
        std::vector<std::vector<double>> errors(methods.size());
        std::vector<float> numbers(static_cast<std::size_t>(count));
        for (int repeat = 0; repeat < repeats; ++repeat) {
            long double exact = 0;
            for (float& number : numbers) exact += number = random.uniform();
            for (std::size_t i = 0; i < methods.size(); ++i)
                errors[i].push_back(static_cast<double>((methods[i].second(numbers) - exact) / exact) * 0x1p24);
        }
        const std::string situation = fmt::format("{}", count);
        study.knob.situations.push_back({situation, fmt::format("{} numbers", count), static_cast<double>(count)});
        for (std::size_t i = 0; i < methods.size(); ++i)
            study.trials.push_back({methods[i].first,
                                    methods[i].first,
                                    static_cast<double>(count),
                                    {{"rms", root_mean_square(errors[i])}},
                                    static_cast<double>(count),
                                    [numbers, sum = methods[i].second] { keep(sum(numbers)); },
                                    situation});
    }
    study.laws = {{"float", "rms", "numbers", 0.5,
                   "N roundings of sums that grow to the last add up like a random walk: √N of them.",
                   "Within one power of two all roundings are multiples of one step."},
                  {"pairwise", "rms", "numbers", 0, "Only log N roundings lie on the way of each number.",
                   "The root of a logarithm still rises a little."},
                  {"compensated", "rms", "numbers", 0, "What is lost is carried along: one rounding remains.", ""},
                  {"double", "rms", "numbers", 0, "With 29 more bits only the last rounding, to float, is seen.", ""}};
    return finish(std::move(study), means);
}

}
