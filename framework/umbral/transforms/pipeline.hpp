#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <stdexcept>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// A pop() that no push() came before.
class EmptyStack : public std::logic_error {
public:
    EmptyStack() : std::logic_error("pop: the stack is empty; each pop needs a push before it") {}
};

/// Solids that a pipeline can draw, each in its own master coordinates, with the axis y, and closed by discs.
enum class Primitive : std::uint32_t {
    half_sphere = 1,  ///< radius 1, centre at the origin, the half with y >= 0
    cylinder = 2,     ///< radius 1, from y = 0 to y = 1
};

/// What drawing functions draw with: a modelview matrix M with its stack, a colour, a line width, and a few things to
/// draw.
///
/// All that is drawn goes through M as it is at that moment: a place p of the object is seen at M · p. The course's
/// Cauce: behind it may be OpenGL's fixed function, a program with uniforms, or a list of what was asked for; a drawing
/// function cannot tell.
///
/// A function is *neutral* if it leaves matrix, depth of the stack, colour and line width as it found them. Figures are
/// neutral.
class Pipeline {
public:
    virtual ~Pipeline() = default;

    /// M := view, and the stack is empty (fijarMatrizVista). For the start of a frame; figures do not call it.
    virtual void set_view(const glm::mat4& view) = 0;
    /// M := M · transformation (compMM, glMultMatrixf): it acts on the object before all that was composed earlier.
    virtual void compose(const glm::mat4& transformation) = 0;
    /// Puts a copy of M on the stack (pushMM, glPushMatrix).
    virtual void push() = 0;
    /// M := the top of the stack, which is taken off (popMM, glPopMatrix). Throws EmptyStack.
    virtual void pop() = 0;

    /// What is drawn from now on has this colour, red, green, blue in [0, 1]. Not part of the stack: push and pop leave
    /// it alone.
    virtual void set_color(const glm::vec3& color) = 0;
    [[nodiscard]] virtual glm::vec3 color() const = 0;
    /// In pixels; not part of the stack either.
    virtual void set_line_width(float width) = 0;
    [[nodiscard]] virtual float line_width() const = 0;
    /// What the picture was cleared with.
    [[nodiscard]] virtual glm::vec3 background() const = 0;

    /// Lines from each place to the next, in the plane z = 0: open, so the last place is not joined with the first
    /// (GL_LINE_STRIP).
    virtual void draw_polyline(std::span<const glm::vec2> places) = 0;
    /// Filled triangles in the plane z = 0, three corners each, in any sense of rotation (GL_TRIANGLES). Later ones lie
    /// on top.
    virtual void fill_triangles(std::span<const glm::vec2> corners) = 0;
    /// A solid, lit.
    virtual void draw(Primitive primitive) = 0;
};

/// Something that draws itself, and is neutral.
using Figure = std::function<void(Pipeline&)>;

}
