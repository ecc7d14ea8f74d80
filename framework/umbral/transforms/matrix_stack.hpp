#pragma once

#include <memory>
#include <umbral/transforms/pipeline.hpp>

namespace umbral::transforms {

/// The matrices of a programmable pipeline: the view V, the modelling matrix N, and a stack. OpenGL's own went with its
/// version 3.1.
///
/// A new one has V = N = identity, and nothing on its stack. The matrices that come in are finite and affine (last row
/// 0 0 0 1) with an invertible 3 x 3 block. Any number of pushes is allowed, until memory ends. Guarantee of the
/// reference, after chains of a hundred thousand matrices: within 1e-7 of the largest entry of a column.
class MatrixStack {
public:
    virtual ~MatrixStack() = default;

    /// V := view, N := identity; nothing is left on the stack.
    virtual void set_view(const glm::mat4& view) = 0;
    /// N := N · transformation.
    virtual void compose(const glm::mat4& transformation) = 0;
    /// Puts a copy of N on the stack.
    virtual void push() = 0;
    /// N := the top of the stack, which is taken off. Throws EmptyStack if there is none; then nothing changes.
    virtual void pop() = 0;

    /// M = V · N.
    [[nodiscard]] virtual glm::mat4 modelview() const = 0;
    /// What takes normals to camera coordinates: the inverse of the transpose of M's 3 x 3 block, or that times any
    /// number > 0, since normals are made unit afterwards.
    [[nodiscard]] virtual glm::mat3 normal_matrix() const = 0;
};

/// Course: CauceProgramable (fijarMatrizVista, compMM, pushMM, popMM).
[[nodiscard]] std::unique_ptr<MatrixStack> make_matrix_stack();

/// The unit square [0,1] x [0,1] filled with the current colour, and on it the triangle (0.1,0.1), (0.5,0.1), (0.2,0.7)
/// filled with the background's. Neutral. Course: problem 2.20, FiguraSimple.
void draw_simple_figure(Pipeline& pipeline);

/// Three copies of `figure`, in this order, and nothing else; neutral. Course: problem 2.21, FiguraCompleja.
///
/// 1. as it is; 2. a diamond: (0,0) goes to (2,2), (1,0) to (3,1), (0,1) to (1,1); 3. the rectangle [3,5] x [0,1],
/// upside down: (0,0) goes to (3,1), (1,0) to (5,1), (0,1) to (3,0).
void draw_complex_figure(Pipeline& pipeline, const Figure& figure);

}
