#include "knee.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbral::bench {
namespace {

constexpr double least_gain = 0.99;

bool is_measured(const Offer& offer)
{
    return std::isfinite(offer.time) && offer.time > 0 && std::isfinite(offer.error);
}

/// The longest time that was measured: the end of every budget.
double dearest(std::span<const Offer> offers)
{
    double most = 0;
    for (const Offer& offer : offers)
        if (is_measured(offer)) most = std::max(most, offer.time);
    return most;
}

/// The smallest error above 0, halved: where logarithms put an error of 0.
double floor_of(std::span<const Offer> offers)
{
    double least = INFINITY;
    for (const Offer& offer : offers)
        if (offer.error > 0) least = std::min(least, offer.error);
    return std::isfinite(least) ? least / 2 : 1;
}

std::string sentence_of(const Knob& knob, const Curve& curve, std::span<const Result> results,
                        std::span<const Offer> offers, std::span<const std::size_t> front,
                        std::optional<std::size_t> knee)
{
    const Measure& measure = measure_of(knob, curve.measure);
    const auto told = [&](std::size_t i) {
        return fmt::format("{}: {} {} at {} {}", results[i].setting, number_text(offers[i].error), measure.unit,
                           number_text(offers[i].time), knob.time_unit);
    };
    if (front.empty()) return "Nothing was measured.";
    if (!knee) {
        if (front.size() == 1) return told(front[0]) + ", and nothing else is better in anything.";
        // Two settings make no bend, and many may lie on one line: then the ends say it.
        return told(front.front()) +
               fmt::format(
                   "; {}: 1/{} of that error for {} times the time.", results[front.back()].setting,
                   number_text(offers[front.front()].error / std::max(offers[front.back()].error, floor_of(offers))),
                   number_text(offers[front.back()].time / offers[front.front()].time));
    }
    const Offer& here = offers[front[*knee]];
    if (*knee + 1 == front.size())
        return told(front[*knee]) +
               fmt::format("; up to {} times the time buys nothing more.", number_text(dearest(offers) / here.time));
    const Offer end{offers[front.back()].time, std::max(offers[front.back()].error, floor_of(offers))};
    // The exponent p of error ~ time^-p: halving the error costs 2^(1/p) times the time.
    const double price = std::exp2(1 / std::log2(gain_of_doubling(here, end)));
    if (price < 100)
        return told(front[*knee]) +
               fmt::format("; beyond it, halving the error costs {} times the time.", number_text(price));
    return told(front[*knee]) + fmt::format("; beyond it, {} times the time leaves {} {}.",
                                            number_text(end.time / here.time), number_text(end.error), measure.unit);
}

}

std::vector<std::size_t> pareto_front(std::span<const Offer> offers)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (is_measured(offers[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return offers[a].time != offers[b].time ? offers[a].time < offers[b].time : offers[a].error < offers[b].error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || offers[i].error < least_gain * offers[front.back()].error) front.push_back(i);
    return front;
}

std::optional<std::size_t> knee_of(std::span<const Offer> offers, std::span<const std::size_t> front)
{
    if (front.empty()) return std::nullopt;
    const double floor = floor_of(offers);
    const auto x = [&](std::size_t i) { return std::log2(offers[front[i]].time); };
    const auto y = [&](std::size_t i) { return std::log2(std::max(offers[front[i]].error, floor)); };
    const double run = std::log2(dearest(offers)) - x(0);
    const double fall = y(0) - y(front.size() - 1);
    std::optional<std::size_t> knee;
    double farthest = 1e-9 * run * fall;
    for (std::size_t i = 1; i < front.size(); ++i) {
        // Twice the area of the triangle over the chord: its height but for a factor that all share.
        const double height = (y(0) - y(i)) * run - (x(i) - x(0)) * fall;
        if (height > farthest) {
            farthest = height;
            knee = i;
        }
    }
    return knee;
}

double gain_of_doubling(const Offer& cheap, const Offer& dear)
{
    return std::exp2(std::log2(cheap.error / dear.error) / std::log2(dear.time / cheap.time));
}

Curve curve_of(const Knob& knob, const std::string& situation, const std::string& measure)
{
    const std::vector<Result> results = results_in(knob, situation);
    std::vector<Offer> offers;
    for (const Result& result : results) offers.push_back({result.time, result.errors.at(measure)});
    const std::vector<std::size_t> front = pareto_front(offers);
    const std::optional<std::size_t> knee = knee_of(offers, front);
    Curve curve{situation, measure, {}, {}, ""};
    for (const std::size_t i : front) curve.front.push_back(results[i].setting);
    if (knee) curve.knee = curve.front[*knee];
    curve.sentence = sentence_of(knob, curve, results, offers, front, knee);
    return curve;
}

std::string number_text(double value)
{
    if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : "infinite";
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (size < 1e-5 || size >= 999'500) return fmt::format("{:.2e}", value);
    if (size < 999.5) {
        // Fixed, with three significant digits and no zeros at the end.
        const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 7);
        std::string text = fmt::format("{:.{}f}", value, decimals);
        if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }
    const double unit = std::pow(10, std::floor(std::log10(size)) - 2);
    std::string digits = fmt::format("{:.0f}", std::round(value / unit) * unit);
    digits.insert(digits.size() - 3, " ");
    return digits;
}

}
