// The same interface with 113-bit numbers, each answer rounded once.

#include <array>
#include <umbral/transforms/matrix_stack.hpp>
#include <vector>

#include "wide.hpp"

namespace umbral::transforms {
namespace {

/// Columns first, as in GLM.
using Matrix = std::array<std::array<Wide, 4>, 4>;

Matrix exact(const glm::mat4& matrix)
{
    Matrix result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = matrix[column][row];
    return result;
}

Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix result{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k) result[column][row] += a[k][row] * b[column][k];
    return result;
}

class OracleStack final : public MatrixStack {
public:
    void set_view(const glm::mat4& view) override
    {
        view_ = exact(view);
        model_ = exact(glm::mat4(1));
        stack_.clear();
    }
    void compose(const glm::mat4& transformation) override { model_ = product(model_, exact(transformation)); }
    void push() override { stack_.push_back(model_); }
    void pop() override
    {
        if (stack_.empty()) throw EmptyStack();
        model_ = stack_.back();
        stack_.pop_back();
    }

    [[nodiscard]] glm::mat4 modelview() const override
    {
        const Matrix m = product(view_, model_);
        glm::mat4 result;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                result[column][row] =
                    static_cast<float>(m[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)]);
        return result;
    }

    // Entry (row, column) of the inverse transpose is its cofactor over the determinant; scaled here so that the
    // largest entry is 1.
    [[nodiscard]] glm::mat3 normal_matrix() const override
    {
        const Matrix m = product(view_, model_);
        Wide cofactor[3][3];
        Wide largest = 0;
        for (std::size_t column = 0; column < 3; ++column) {
            const auto& next = m[(column + 1) % 3];
            const auto& last = m[(column + 2) % 3];
            for (std::size_t row = 0; row < 3; ++row) {
                const std::size_t below = (row + 1) % 3;
                const std::size_t above = (row + 2) % 3;
                cofactor[column][row] = next[below] * last[above] - next[above] * last[below];
                const Wide size = cofactor[column][row] < 0 ? -cofactor[column][row] : cofactor[column][row];
                if (size > largest) largest = size;
            }
        }
        const Wide determinant = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
        if (determinant < 0) largest = -largest;
        glm::mat3 result;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) result[column][row] = static_cast<float>(cofactor[column][row] / largest);
        return result;
    }

private:
    Matrix view_ = exact(glm::mat4(1));
    Matrix model_ = exact(glm::mat4(1));
    std::vector<Matrix> stack_;
};

}

std::unique_ptr<MatrixStack> make_matrix_stack() { return std::make_unique<OracleStack>(); }

void draw_simple_figure(Pipeline& pipeline)
{
    const glm::vec3 color = pipeline.color();
    pipeline.fill_triangles(std::array<glm::vec2, 6>{{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}}});
    pipeline.set_color(pipeline.background());
    pipeline.fill_triangles(std::array<glm::vec2, 3>{{{0.1F, 0.1F}, {0.5F, 0.1F}, {0.2F, 0.7F}}});
    pipeline.set_color(color);
}

void draw_complex_figure(Pipeline& pipeline, const Figure& figure)
{
    figure(pipeline);
    pipeline.push();
    pipeline.compose(glm::mat4(1, -1, 0, 0, -1, -1, 0, 0, 0, 0, 1, 0, 2, 2, 0, 1));
    figure(pipeline);
    pipeline.pop();
    pipeline.push();
    pipeline.compose(glm::mat4(2, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 3, 1, 0, 1));
    figure(pipeline);
    pipeline.pop();
}

}
