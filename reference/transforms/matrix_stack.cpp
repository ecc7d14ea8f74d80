// Based on: the course's class CauceProgramable, which keeps what OpenGL kept itself until its version 3.0
// (M. Segal, K. Akeley. The OpenGL Graphics System: A Specification. Version 2.1, 2006, section 2.11.2).

#include <algorithm>
#include <cmath>
#include <umbral/transforms/matrix_stack.hpp>
#include <vector>

namespace umbral::transforms {
namespace {

/// Double throughout, rounded when asked for: a chain of products in float would drift, and the determinant of a matrix
/// that shrinks to 1e-13 underflows.
class ReferenceStack final : public MatrixStack {
public:
    void set_view(const glm::mat4& view) override
    {
        view_ = view;
        model_ = glm::dmat4(1);
        stack_.clear();
    }

    void compose(const glm::mat4& transformation) override { model_ = model_ * glm::dmat4(transformation); }

    void push() override { stack_.push_back(model_); }

    void pop() override
    {
        if (stack_.empty()) throw EmptyStack();
        model_ = stack_.back();
        stack_.pop_back();
    }

    [[nodiscard]] glm::mat4 modelview() const override { return glm::mat4(view_ * model_); }

    // From M itself and not by products of normal matrices: one inverse, and the view may scale too.
    [[nodiscard]] glm::mat3 normal_matrix() const override
    {
        const glm::dmat3 m(view_ * model_);
        // The cofactors, cross products of columns, are the inverse transpose times the determinant; its sign is what a
        // mirror turns round.
        const glm::dmat3 cofactors(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
        double largest = 0;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
        return glm::mat3(cofactors / std::copysign(largest, dot(m[0], cofactors[0])));
    }

private:
    glm::dmat4 view_{1};
    glm::dmat4 model_{1};
    std::vector<glm::dmat4> stack_;
};

}

std::unique_ptr<MatrixStack> make_matrix_stack() { return std::make_unique<ReferenceStack>(); }

void draw_simple_figure(Pipeline& pipeline)
{
    constexpr glm::vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    constexpr glm::vec2 triangle[] = {{0.1F, 0.1F}, {0.5F, 0.1F}, {0.2F, 0.7F}};
    pipeline.fill_triangles(square);
    const glm::vec3 color = pipeline.color();
    pipeline.set_color(pipeline.background());
    pipeline.fill_triangles(triangle);
    pipeline.set_color(color);
}

void draw_complex_figure(Pipeline& pipeline, const Figure& figure)
{
    // The columns: what becomes of x axis, y axis, z axis, and origin.
    const glm::mat4 diamond({1, -1, 0, 0}, {-1, -1, 0, 0}, {0, 0, 1, 0}, {2, 2, 0, 1});
    const glm::mat4 rectangle({2, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}, {3, 1, 0, 1});
    figure(pipeline);
    for (const glm::mat4& place : {diamond, rectangle}) {
        pipeline.push();
        pipeline.compose(place);
        figure(pipeline);
        pipeline.pop();
    }
}

}
