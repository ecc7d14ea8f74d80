#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/input/glfw.hpp>

namespace umbral::pipeline {

/// A box of space with sides along the axes (ortoedro): `low` goes to -1, and `high` to +1.
///
/// Usually low < high on every axis. Where low > high the picture is mirrored along that axis; where low = high the box
/// is flat.
struct Box {
    glm::vec3 low;
    glm::vec3 high;
};

/// The matrix P that maps the box to the cube [-1, 1]³ of normalised device coordinates. z keeps its direction (unlike
/// glOrtho's).
///
/// An axis along which the box is flat is mapped to 0. Column vectors, as GLM has them: P[3] is the translation.
/// Course: "Matriz de proyección P", section 3.5 of topic 1.
[[nodiscard]] glm::mat4 projection_of(const Box& region);

/// Where P leads a point, but computed from differences: right to 3e-7 for points in the box, however far from the
/// origin the box is.
///
/// 0 along an axis along which the box is flat.
[[nodiscard]] glm::vec3 ndc_of(const Box& region, const glm::vec3& point);

/// The smallest box round `contents` that has the proportions of a viewport, |Δx| : |Δy| = width : height, and the same
/// centre.
///
/// It is larger than the contents in x or in y, not in both; z stays, and so does the direction of every axis. Contents
/// may be flat; those that are flat in x and y stay so. For a window of no pixels (width or height of 0) the answer is
/// the contents. Course: problem 1.7.
[[nodiscard]] Box visible_region(const Box& contents, int width, int height);

/// What is shown in a window, and who is told how. A window's user pointer leads to one:
/// static_cast<Viewer*>(glfwGetWindowUserPointer(w)). The pointer may be set to another one at any time, who is told
/// from then on.
class Viewer {
public:
    virtual ~Viewer() = default;
    /// What must be visible. May change while the program runs.
    [[nodiscard]] virtual Box contents() const = 0;
    /// Draw from now on into so many pixels, both > 0, with this projection matrix.
    virtual void show(const glm::ivec2& pixels, const glm::mat4& projection) = 0;
};

/// Registers a callback with GLFW that calls `show` whenever the *framebuffer* gets another size, and calls it once at
/// once, since GLFW promises no event for the first size.
///
/// The projection is that of the visible region of the viewer's present contents. Sizes with a 0, as of a minimised
/// window, give no call. Course: problem 1.7, FGE_CambioTamano.
void keep_proportions(GLFWwindow* window);

}
