#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <numbers>
#include <umbral/texturing/can_and_pawns.hpp>
#include <vector>

namespace umbral::texturing {

/// The bytes of a file.
using Bytes = std::vector<std::byte>;

/// What lies beside the program. Profiles are PLY files of vertices (x, y, 0) and no faces, going up with the outside
/// on their right: meshes::read_ply reads them.
struct Files {
    Bytes body;     ///< lata-pcue.ply
    Bytes top;      ///< lata-psup.ply
    Bytes bottom;   ///< lata-pinf.ply
    Bytes pawn;     ///< peon.ply
    Picture label;  ///< text-lata-1.jpg, unpacked
    Picture wood;   ///< text-madera.jpg
};

/// Labs 1 to 3, which you hand in with lab 4: their drawing, and the camera that all labs share.
class EarlierLabs {
public:
    virtual ~EarlierLabs() = default;
    /// Clears the picture and draws, with matrices of its own. Expects OpenGL's state as it is at the beginning but for
    /// the viewport: lighting, textures, generation, depth test off, no program in use. Leaves it so.
    virtual void draw() = 0;
    /// What a key does in these labs, the camera's keys among them: as GLFW's callback has it.
    virtual void key(int key, int action, int mods) = 0;
    /// The camera as it is now.
    [[nodiscard]] virtual glm::mat4 view() const = 0;
    /// `aspect` is width / height of the framebuffer.
    [[nodiscard]] virtual glm::mat4 projection(float aspect) const = 0;
};

/// The numbers that the lab leaves open.
namespace lab4 {
inline constexpr int width = 640;  ///< of the window, in screen coordinates
inline constexpr int height = 480;
inline constexpr std::uint32_t copies = 49;  ///< of every profile
inline constexpr glm::vec4 background{0.075F, 0.085F, 0.115F, 1};
inline constexpr std::array<glm::vec3, 3> pawns = {{{-1.5F, 0, 0.05F}, {-0.72F, 0, 1.2F}, {1.15F, 0, 0.5F}}};
inline constexpr glm::vec4 wood_s_plane{1.1F, 0, 0, 0.5F};     ///< s is proportional to x, but for a shift
inline constexpr glm::vec4 wood_t_plane{0, 1.1F, 0, 0};        ///< t to y
inline constexpr float step = std::numbers::pi_v<float> / 36;  ///< of α and β with each press of a key: 5°
}

/// The program, from glfwInit to glfwTerminate.
///
/// It opens one window of lab4::width x lab4::height, installs its callbacks, and draws until the window is to close: a
/// frame at the beginning, and one whenever events changed something (or all the time). Every frame fills the whole
/// framebuffer, whose size may be another than the window's and may change, and ends with glfwSwapBuffers.
///
/// **Keys.** 4, when pressed and not when repeated, enters and leaves the mode of lab 4. In the mode, A increases β by
/// lab4::step when pressed or repeated, Z decreases it (it stays within ±π/2); X increases α, C decreases it; with
/// Shift or without. Every other event of a key, and outside the mode those of A, Z, X and C too, goes to
/// `earlier.key`, as it came; where the events of 4 go, and in the mode the releases of A, Z, X and C, is up to you.
///
/// **Outside the mode** a frame is `earlier.draw()`. **In the mode** it shows, on lab4::background, with
/// `earlier.view()` and `earlier.projection()`, smoothly shaded: the can at the origin, three meshes of which the body
/// has the material label and the two ends have metal; and three pawns, which share one mesh, moved to lab4::pawns: of
/// wood (with generated coordinates), white and black, in this order. Lights: first a directional one of colour
/// (0.85, 0.82, 0.76), at first with α = -40°, β = 35°, which the keys turn; then a positional one of colour
/// (0.22, 0.27, 0.36) at (4, 3, -3).
///
/// Meshes, materials and textures are made when the mode is first drawn, once; none before. Course: lab 4, 4.2.7 to
/// 4.2.9.
void run_lab4(const Files& files, EarlierLabs& earlier);

}
