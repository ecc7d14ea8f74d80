#include "run/warm_gl.hpp"

#include <array>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/program.hpp>

namespace umbral::grader {

std::string warm_gl()
{
    // One for the life of the process: runs are forks and end with _exit.
    static const gl::OffscreenContext context;
    const gl::Framebuffer target(16, 16);
    const gl::Program program(
        {"warm.vert", "#version 330\nin vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }\n"},
        {"warm.frag", "#version 330\nout vec4 color;\nvoid main() { color = vec4(1); }\n"});
    constexpr std::array positions{glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(0, 1, 0)};
    constexpr std::array<std::uint32_t, 3> indices{0, 1, 2};
    const gl::Mesh triangle(positions, {}, indices);
    target.clear();
    triangle.draw(program);
    (void)target.read_pixels();
    return gl::backend_description();
}

}
