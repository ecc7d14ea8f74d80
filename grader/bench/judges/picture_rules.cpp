#include "bench/judges/picture_rules.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/picture/image_edges.hpp"
#include "judge/picture/image_metrics.hpp"
#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {
namespace {

/// Luma at half the size, each value the mean of four pixels.
struct HalfLuma {
    int width = 0;
    int height = 0;
    std::vector<double> values;
    [[nodiscard]] double at(int x, int y) const
    {
        return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
    }
};

HalfLuma half_luma(const Picture& picture)
{
    HalfLuma half{std::max(1, picture.width / 2), std::max(1, picture.height / 2), {}};
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            double sum = 0;
            for (int dy = 0; dy < 2; ++dy)
                for (int dx = 0; dx < 2; ++dx) {
                    const auto level = [&](int c) { return picture.row(c, 2 * y + dy)[2 * x + dx]; };
                    sum += picture.colours() == 1 ? level(0) : 0.299 * level(0) + 0.587 * level(1) + 0.114 * level(2);
                }
            half.values.push_back(sum / 4);
        }
    return half;
}

double gradient(const HalfLuma& luma, int x, int y)
{
    double across = 0;
    double down = 0;
    for (int i = -1; i <= 1; ++i) {
        across += luma.at(x + 1, y + i) - luma.at(x - 1, y + i);
        down += luma.at(x + i, y + 1) - luma.at(x + i, y - 1);
    }
    return std::hypot(across, down) / 3;
}

double share_without_similar(const Picture& a, const Picture& b)
{
    constexpr std::uint8_t similar = 10;
    std::size_t count = 0;
    std::vector<std::uint8_t> least(static_cast<std::size_t>(a.width));
    std::vector<std::uint8_t> room(least.size());
    for (int y = 0; y < a.height; ++y) {
        least_difference(a, b, y, least, room);
        count += static_cast<std::size_t>(
            std::ranges::count_if(least, [](std::uint8_t difference) { return difference > similar; }));
    }
    return static_cast<double>(count) / (static_cast<double>(a.width) * a.height);
}

double share_of_changed(const Picture& a, const Picture& b)
{
    const auto difference = channel_difference(a, b);
    return static_cast<double>(std::ranges::count_if(difference, [](std::uint8_t apart) { return apart > 25; })) /
           static_cast<double>(difference.size());
}

}

double gradient_deviation(const Picture& student, const Picture& expected)
{
    constexpr double c = 170;
    const HalfLuma yours = half_luma(student);
    const HalfLuma target = half_luma(expected);
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < yours.height; ++y)
        for (int x = 0; x < yours.width; ++x) {
            const double a = gradient(yours, x, y);
            const double b = gradient(target, x, y);
            const double similarity = (2 * a * b + c) / (a * a + b * b + c);
            sum += similarity;
            squares += similarity * similarity;
        }
    const double count = static_cast<double>(yours.width) * yours.height;
    return std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

double fuzzy_share(const Picture& student, const Picture& expected)
{
    return std::min(share_without_similar(student, expected), share_without_similar(expected, student));
}

OurMeasure our_measure(const Picture& student, const Picture& expected, bool noise)
{
    OurMeasure measure;
    if (noise) {
        const StochasticRule rule = apply_stochastic_rule(student, expected);
        // As many decimal places as there are to the bound: a probability of its square is a ratio of 2.
        measure.worst = std::log(std::max(rule.probability, 1e-300)) / std::log(stochastic_alpha);
    } else if (student.planes != expected.planes) {
        measure.parts = apply_image_rule(student, expected);
        measure.worst = measure.parts.worst();
    }
    return measure;
}

PictureMeasures measure_by_rules(const Picture& student, const Picture& expected, const OurMeasure& ours)
{
    const ImageMetrics metrics = measure_image(student, expected);
    PictureMeasures measures{};
    const auto set = [&](PictureRule rule, double value) { measures[static_cast<std::size_t>(rule)] = value; };
    set(PictureRule::ours, ours.worst);
    set(PictureRule::rmse, metrics.rmse);
    set(PictureRule::psnr, metrics.rmse);
    set(PictureRule::ssim, 1 - metrics.ssim);
    set(PictureRule::gmsd, gradient_deviation(student, expected));
    set(PictureRule::lab, metrics.mean_lab);
    set(PictureRule::pixels, share_of_changed(student, expected));
    set(PictureRule::three_by_three, fuzzy_share(student, expected));
    return measures;
}

}
