// alternative: keeps the normal matrix beside the modelling matrix, as the course's class does, and builds the diamond
// of turns and scales
#include <umbral/transforms/matrix_stack.hpp>

namespace umbral::transforms {
namespace {

struct Pair {
    glm::dmat4 places{1};
    glm::dmat3 normals{1};
};

Pair pair_of(const glm::mat4& matrix)
{
    const glm::dmat4 m(matrix);
    return {m, glm::transpose(glm::inverse(glm::dmat3(m)))};
}

Pair operator*(const Pair& a, const Pair& b) { return {a.places * b.places, a.normals * b.normals}; }

class Pairs : public MatrixStack {
public:
    void set_view(const glm::mat4& view) override
    {
        view_ = pair_of(view);
        pairs_.assign(1, Pair{});
    }
    void compose(const glm::mat4& transformation) override { pairs_.back() = pairs_.back() * pair_of(transformation); }
    void push() override { pairs_.push_back(pairs_.back()); }
    void pop() override
    {
        if (pairs_.size() < 2) throw EmptyStack();
        pairs_.pop_back();
    }
    glm::mat4 modelview() const override { return glm::mat4((view_ * pairs_.back()).places); }
    glm::mat3 normal_matrix() const override { return glm::mat3((view_ * pairs_.back()).normals); }

private:
    Pair view_;
    std::vector<Pair> pairs_{Pair{}};
};

}

std::unique_ptr<MatrixStack> make_matrix_stack() { return std::make_unique<Pairs>(); }

void draw_simple_figure(Pipeline& pipeline)
{
    const glm::vec3 before = pipeline.color();
    const std::vector<glm::vec2> lower{{0, 0}, {1, 0}, {0, 1}};
    const std::vector<glm::vec2> upper{{1, 1}, {0, 1}, {1, 0}};
    const std::vector<glm::vec2> hole{{0.2F, 0.7F}, {0.1F, 0.1F}, {0.5F, 0.1F}};
    pipeline.fill_triangles(lower);
    pipeline.fill_triangles(upper);
    pipeline.set_color(pipeline.background());
    pipeline.fill_triangles(hole);
    pipeline.set_color(before);
}

void draw_complex_figure(Pipeline& pipeline, const Figure& figure)
{
    const glm::mat4 one(1);
    pipeline.push();
    figure(pipeline);
    pipeline.compose(glm::translate(one, {2, 2, 0}));
    pipeline.compose(glm::rotate(one, glm::radians(-45.0F), {0, 0, 1}));
    pipeline.compose(glm::scale(one, {std::sqrt(2.0F), -std::sqrt(2.0F), 1}));
    figure(pipeline);
    pipeline.pop();
    pipeline.push();
    pipeline.compose(glm::translate(one, {3, 1, 0}) * glm::scale(one, {2, -1, 1}));
    figure(pipeline);
    pipeline.pop();
}

}
