#pragma once

#include <umbral/core/not_implemented.hpp>
#include <umbral/input/glfw.hpp>

namespace umbral::interaction {

/// What callbacks, draw() and update() tell the loop, and the loop obeys. Any of them may change any flag at any time.
struct LoopFlags {
    bool finish = false;   ///< the loop is to end (terminar)
    bool redraw = true;    ///< what is on the screen is out of date (redibujar)
    bool animate = false;  ///< the scene moves by itself (animacion); only run_switching_loop looks at it
};

/// The program that a loop runs. It has registered its callbacks before the loop begins.
class LoopProgram {
public:
    virtual ~LoopProgram() = default;
    /// Draws the scene as it is now (VisualizarEscena). To show it, glfwSwapBuffers, is the loop's work.
    virtual void draw() = 0;
    /// Takes the scene one step further (ActualizarEscena); sets `redraw` if anything moved.
    virtual void update() = 0;
};

/// Runs the program in a window until it is over. This one sleeps whenever nothing has to be drawn, and never calls
/// update(); `animate` means nothing here.
///
/// The loop is **over** as soon as `finish` is set or glfwWindowShouldClose(window) says so: from then on it calls
/// neither draw() nor update(), waits for nothing, and returns; at once if it is over at the beginning. The window
/// **is seen** unless its attribute GLFW_ICONIFIED is set or its framebuffer (glfwGetFramebufferSize) is 0 wide or
/// high. Both are asked anew wherever they are needed, for every call into the program may change them. A round is:
///
/// 1. If `redraw` is set and the window is seen: clear `redraw`, call draw(), call glfwSwapBuffers(window) once, and
///    look whether the loop is over. Flags that draw() sets count: a draw() that sets `redraw` wants to be drawn again.
/// 2. Process events, by one call: glfwPollEvents if there is work at hand, else glfwWaitEvents. Work at hand is a
///    window that is seen and a `redraw` that is set.
/// 3. Look whether the loop is over.
///
/// Registers no callback, changes no flag but `redraw`, which it only clears, and keeps nothing for the next call of a
/// loop.
/// Course: "bucle de gestión de eventos"; terminar, redibujar, VisualizarEscena.
void run_waiting_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags);

/// As run_waiting_loop, for a scene that always moves: a window that is seen is work at hand, so that the loop polls;
/// and a round has a fourth step:
///
/// 4. If the window is seen, call update() once, whether `redraw` is set or not.
///
/// While the window is not seen, the scene stands still and the loop waits.
/// Course: "bucle de gestión de eventos con animaciones"; ActualizarEscena.
void run_animated_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags);

/// Either of them, as `animate` says at the moment: in step 2 a window that is seen is work at hand if `redraw` or
/// `animate` is set; and step 4 calls update() if the window is seen and `animate` is set.
/// Course: "bucle de gestión de eventos genérico"; animacion.
void run_switching_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags);

}
