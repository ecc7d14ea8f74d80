#include "samples.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::bench {

double covered_area(const HalfPlane& edge)
{
    const double a = std::abs(edge.normal.x);
    const double b = std::abs(edge.normal.y);
    // Mirrored so that the covered corner lies at the origin.
    const double c = edge.offset - std::min(0.0, edge.normal.x) - std::min(0.0, edge.normal.y);
    const auto square = [](double x) { return x > 0 ? x * x : 0; };
    return std::clamp((square(c) - square(c - a) - square(c - b) + square(c - a - b)) / (2 * a * b), 0.0, 1.0);
}

HalfPlane random_edge(Random& random, double low, double high)
{
    const double angle = low + (high - low) * random.uniform_double();
    const double x = random.uniform_double();
    const double y = random.uniform_double();
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    return {normal, normal.x * x + normal.y * y};
}

double covered_share(const HalfPlane& edge, const std::vector<glm::dvec2>& samples)
{
    const auto inside =
        std::count_if(samples.begin(), samples.end(), [&](const glm::dvec2& p) { return edge.covers(p); });
    return static_cast<double>(inside) / static_cast<double>(samples.size());
}

std::vector<glm::dvec2> hammersley(int count, const glm::dvec2& shift)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        double inverse = 0;
        double digit = 0.5;
        for (int rest = i; rest > 0; rest /= 2, digit /= 2) inverse += digit * (rest % 2);
        points.emplace_back(glm::fract(glm::dvec2((i + 0.5) / count, inverse) + shift));
    }
    return points;
}

std::vector<glm::dvec2> cells(int count, Random* random)
{
    std::vector<glm::dvec2> points;
    const int side = static_cast<int>(std::lround(std::sqrt(count)));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double dx = random != nullptr ? random->uniform_double() : 0.5;
            const double dy = random != nullptr ? random->uniform_double() : 0.5;
            points.emplace_back((x + dx) / side, (y + dy) / side);
        }
    return points;
}

std::vector<glm::dvec2> independent(int count, Random& random)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform_double();
        points.emplace_back(x, random.uniform_double());
    }
    return points;
}

}
