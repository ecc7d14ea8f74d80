#pragma once

#include <functional>
#include <stdexcept>
#include <umbral/transforms/parametric_graph.hpp>

#include "../recording_pipeline.hpp"

/// Simple objects to hang into graphs.
namespace umbral::transforms {

/// A drawable of one function.
class Painted final : public Drawable {
public:
    explicit Painted(std::function<void(Pipeline&)> paint) : paint_(std::move(paint)) {}
    void draw(Pipeline& pipeline) const override { paint_(pipeline); }

private:
    std::function<void(Pipeline&)> paint_;
};

inline std::shared_ptr<const Drawable> painted(std::function<void(Pipeline&)> paint)
{
    return std::make_shared<Painted>(std::move(paint));
}

/// Draws a cylinder in a colour whose red channel is its number: what a recording pipeline takes down tells which
/// object it was. Neutral.
inline std::shared_ptr<const Drawable> numbered(int number)
{
    return painted([number](Pipeline& pipeline) {
        const glm::vec3 before = pipeline.color();
        pipeline.set_color({number, 0, 0});
        pipeline.draw(Primitive::cylinder);
        pipeline.set_color(before);
    });
}

/// What a part throws that cannot be drawn.
class Torn : public std::runtime_error {
public:
    Torn() : std::runtime_error("this part cannot be drawn") {}
};

inline FacadeParts numbered_facade() { return {numbered(1), numbered(2), numbered(3)}; }

inline AndroidParts android_parts()
{
    return {painted([](Pipeline& pipeline) { pipeline.draw(Primitive::half_sphere); }),
            painted([](Pipeline& pipeline) { pipeline.draw(Primitive::cylinder); }), painted([](Pipeline& pipeline) {
                const glm::vec3 before = pipeline.color();
                pipeline.set_color(glm::vec3(1));
                pipeline.draw(Primitive::half_sphere);
                pipeline.set_color(before);
            })};
}

}
