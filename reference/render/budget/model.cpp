#include "render/budget/model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace umbral::render::budget {
namespace {

/// Far below a level of 255, so that logarithms exist where a picture has no noise at all.
constexpr double least_error = 1e-9;

double log_error(const Noise& point) { return std::log(std::max(point.error, least_error)); }

const Cut& cut_of(const std::vector<Cut>& cuts, int value)
{
    const auto found = std::ranges::find(cuts, value, &Cut::value);
    if (found == cuts.end()) throw std::invalid_argument("budget: expected a depth and bounces of the model");
    return *found;
}

/// Of a number of rays that is a power of two: between measured ones straight in logarithms, beyond them by the slope;
/// never more for more rays.
double noise_of_power(const Model& model, int rays)
{
    const std::vector<Noise>& points = model.noise;
    double least = points.front().error;
    if (rays <= points.front().rays) return least;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double share =
            std::log(1.0 * rays / points[i - 1].rays) / std::log(1.0 * points[i].rays / points[i - 1].rays);
        if (share <= 1)
            return std::min(least, std::exp(std::lerp(log_error(points[i - 1]), log_error(points[i]), share)));
        least = std::min(least, points[i].error);
    }
    return least * std::pow(1.0 * rays / points.back().rays, noise_slope(model));
}

/// What is reached comes first, then what `first` of a prediction is least of, then `second`; what is not reached is
/// approached by the other measure.
template <class IsReached>
Choice best_of(const Model& model, double Predicted::*first, double Predicted::*second, const IsReached& is_reached)
{
    const auto rank = [&](const Choice& choice) {
        return std::tuple(!choice.reached, choice.predicted.*(choice.reached ? first : second),
                          choice.predicted.*(choice.reached ? second : first));
    };
    std::vector<Choice> all;
    for (const Cut& depth : model.depths)
        for (const Cut& bounces : model.bounces)
            for (const int rays : numbers_of_rays()) {
                const Setting setting{rays, depth.value, bounces.value};
                const Predicted predicted = predict(model, setting);
                all.push_back({setting, predicted, is_reached(predicted), 0});
            }
    Choice best = *std::ranges::min_element(all, {}, rank);
    best.compared = static_cast<int>(all.size());
    return best;
}

}

std::vector<int> numbers_of_rays()
{
    std::vector<int> numbers = {1, 2, 3};
    for (int power = 1; 4 * power < most_rays; power *= 2)
        for (int quarters = 4; quarters < 8; ++quarters) numbers.push_back(quarters * power);
    numbers.push_back(most_rays);
    return numbers;
}

double noise_slope(const Model& model)
{
    const std::size_t count = std::min<std::size_t>(4, model.noise.size());
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (auto point = model.noise.end() - static_cast<std::ptrdiff_t>(count); point != model.noise.end(); ++point) {
        const double rays = std::log(point->rays);
        x += rays;
        y += log_error(*point);
        xx += rays * rays;
        xy += rays * log_error(*point);
    }
    const auto n = static_cast<double>(count);
    const double spread = n * xx - x * x;
    return spread > 0 ? std::min(-0.5, (n * xy - x * y) / spread) : -0.5;
}

double noise_of(const Model& model, int rays)
{
    if (const auto measured = std::ranges::find(model.uneven, rays, &Noise::rays); measured != model.uneven.end())
        return measured->error;
    double sum = 0;
    for (int part = 1; part <= rays; part *= 2)
        if ((rays & part) != 0) sum += std::pow(part * noise_of_power(model, part), 2);
    return std::sqrt(sum) / rays;
}

Predicted predict(const Model& model, const Setting& setting)
{
    const Cut& depth = cut_of(model.depths, setting.depth);
    const Cut& bounces = cut_of(model.bounces, setting.bounces);
    Predicted result;
    result.noise = noise_of(model, setting.rays);
    result.bias = depth.bias + bounces.bias;
    result.error = std::hypot(result.noise, result.bias);
    result.seconds = setting.rays * model.ray_seconds * depth.cost * bounces.cost;
    return result;
}

Choice cheapest(const Model& model, double error)
{
    return best_of(model, &Predicted::seconds, &Predicted::error,
                   [&](const Predicted& predicted) { return predicted.error <= error; });
}

Choice most_accurate(const Model& model, double seconds)
{
    return best_of(model, &Predicted::error, &Predicted::seconds,
                   [&](const Predicted& predicted) { return predicted.seconds <= seconds; });
}

}
