#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/input/glfw.hpp>

namespace umbral::interaction {

/// What a viewer of 3D scenes understands: gestures, whatever device they come from.
class Commands {
public:
    virtual ~Commands() = default;
    /// Turn the view by a drag: screen coordinates to the right and **up** since the last command of this drag.
    virtual void orbit(glm::dvec2 drag) = 0;
    /// Move the view by a drag, counted in the same way.
    virtual void pan(glm::dvec2 drag) = 0;
    /// Multiply the distance to what is looked at by `factor` > 0.
    virtual void zoom(double factor) = 0;
    /// Look at the scene as at the beginning.
    virtual void reset() = 0;
    /// Show the scene in way 1, 2 or 3.
    virtual void view_mode(int mode) = 0;
    /// Draw into this many pixels, both > 0, with `aspect` = width / height.
    virtual void viewport(int width, int height, double aspect) = 0;
};

/// What is being dragged.
enum class Drag { none, orbit, pan };

/// What a window's user pointer points to when install_callbacks is called: where gestures go, and room for what the
/// callbacks must remember from one event to the next. One for each window.
struct Controls {
    Commands* commands = nullptr;       ///< never null
    Drag drag = Drag::none;             ///< yours to use
    int drag_button = 0;                ///< yours: the button that began the drag
    glm::dvec2 last_cursor{0};          ///< yours: where the pointer was when the last command was given
    GLFWkeyfun previous_key = nullptr;  ///< yours: the key callback that was there before
};

/// Registers callbacks with GLFW that turn this window's events into commands to its Controls (see the user pointer),
/// and gives the first viewport at once, since GLFW promises no event for it.
///
/// - Dragging with the left button orbits; with the right one, or the left one pressed while Shift is down, it pans.
///   Each motion of the pointer gives one command, with the motion since the one before (at first: since the press,
///   where glfwGetCursorPos says) and y turned up. The button that began a drag ends it; until then, other buttons do
///   nothing. Moves without a drag, and all other buttons, give nothing.
/// - The wheel's y offset zooms by 1.1^-offset, fractions included: away from the user means nearer. x offsets, and 0,
///   give nothing.
/// - When pressed (not when repeated or released): R resets, 1 to 3 (not those of the keypad) choose the view mode,
///   unless Control, Alt or Super is down; Escape asks the window to close (glfwSetWindowShouldClose), whatever else is
///   down. After that, every key event is passed on to the key callback that was there before, if there was one.
/// - Another size of the *framebuffer* gives a viewport; sizes with a 0, as of a minimised window, give none, neither
///   now nor at first.
///
/// Course: "Modelo de eventos de GLFW", FGE_PulsarLevantarBotonRaton, FGE_MovimientoRaton, FGE_Scroll,
/// FGE_CambioTamano.
void install_callbacks(GLFWwindow* window);

}
