#include "scene/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbral::scene {
namespace {

double wave(double seconds, double period, double phase)
{
    return std::sin(2 * std::numbers::pi * std::remainder(seconds / period + phase, 1.0));
}

struct AtTime {
    double seconds;

    Transform operator()(const Spin& spin) const
    {
        const double degrees = std::remainder(double{spin.degrees_per_second} * seconds, 360.0);
        return Rotate{spin.axis, static_cast<float>(degrees)};
    }
    Transform operator()(const Swing& swing) const
    {
        return Rotate{swing.axis, static_cast<float>(double{swing.degrees} * wave(seconds, swing.period, swing.phase))};
    }
    Transform operator()(const Move& move) const { return Translate{glm::vec3(glm::dvec3(move.velocity) * seconds)}; }
    Transform operator()(const Bob& bob) const
    {
        return Translate{glm::vec3(glm::dvec3(bob.by) * wave(seconds, bob.period, bob.phase))};
    }
    template <class Still>
    Transform operator()(const Still& still) const
    {
        return still;
    }
};

bool moves(const Transform& transform)
{
    return std::holds_alternative<Spin>(transform) || std::holds_alternative<Swing>(transform) ||
           std::holds_alternative<Move>(transform) || std::holds_alternative<Bob>(transform);
}

}

Transform at_time(const Transform& transform, double seconds) { return std::visit(AtTime{seconds}, transform); }

Scene at_time(Scene scene, double seconds)
{
    for (Instance& instance : scene.instances)
        for (Transform& transform : instance.transforms) transform = at_time(transform, seconds);
    return scene;
}

bool moves(const Instance& instance)
{
    return std::any_of(instance.transforms.begin(), instance.transforms.end(),
                       [](const Transform& transform) { return moves(transform); });
}

bool moves(const Scene& scene)
{
    return std::any_of(scene.instances.begin(), scene.instances.end(),
                       [](const Instance& instance) { return moves(instance); });
}

}
