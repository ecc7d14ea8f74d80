#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/transforms/parametric_graph.hpp>

#include "../recording_pipeline.hpp"

/// Simple objects to hang into graphs.
namespace umbral::transforms {

/// Matrices of one step.
inline glm::mat4 move(float x, float y, float z = 0) { return glm::translate(glm::mat4(1), {x, y, z}); }
inline glm::mat4 scale(float x, float y, float z = 1) { return glm::scale(glm::mat4(1), {x, y, z}); }
/// Not affine: what it makes of a place has x, y and z in its w too. Determinant 1.
inline glm::mat4 projective(float x, float y, float z)
{
    glm::mat4 matrix = move(x, y, z);
    matrix[0][3] = y;
    matrix[2][3] = -x;
    matrix[3][3] = 1 + x * y - x * z;
    return matrix;
}
inline glm::mat4 turn(float angle, const glm::vec3& axis) { return glm::rotate(glm::mat4(1), angle, axis); }

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

/// What a part throws that cannot be drawn: of any type, and no std::exception.
struct Torn {
    int number = 0;
};

/// House, door and window have these numbers.
inline FacadeParts numbered_facade(int first = 1)
{
    return {numbered(first), numbered(first + 1), numbered(first + 2)};
}

/// A solid in a colour of its own. Neutral.
inline std::shared_ptr<const Drawable> in_color(Primitive primitive, const glm::vec3& color)
{
    return painted([primitive, color](Pipeline& pipeline) {
        const glm::vec3 before = pipeline.color();
        pipeline.set_color(color);
        pipeline.draw(primitive);
        pipeline.set_color(before);
    });
}

inline AndroidParts android_parts()
{
    return {painted([](Pipeline& pipeline) { pipeline.draw(Primitive::half_sphere); }),
            painted([](Pipeline& pipeline) { pipeline.draw(Primitive::cylinder); }),
            in_color(Primitive::half_sphere, glm::vec3(1))};
}

/// Of other objects than all other androids.
inline AndroidParts other_android_parts()
{
    return {in_color(Primitive::half_sphere, {0.7F, 0.2F, 0.1F}), in_color(Primitive::cylinder, {0.1F, 0.3F, 0.8F}),
            in_color(Primitive::half_sphere, {1, 1, 0.5F})};
}

}
