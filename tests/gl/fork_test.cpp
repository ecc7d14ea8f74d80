#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

namespace umbral::gl {
namespace {

using Forks = GlTest;

constexpr int size = 128;
constexpr std::size_t bytes = std::size_t{4} * size * size;

/// A curved, shaded thing: enough arithmetic in the shader for a difference to show.
Image draw()
{
    const Framebuffer target(size, size);
    target.clear({0.2F, 0.4F, 0.6F, 1});
    glEnable(GL_DEPTH_TEST);
    const Program program(vertex_source("#version 330\nin vec3 position; out vec3 place;\nvoid main() { place = "
                                        "position; gl_Position = vec4(position, 1.0); }\n"),
                          fragment_source("#version 330\nin vec3 place; out vec4 result;\nvoid main() { float r = "
                                          "length(place.xy); if (r > 0.95) discard;\n"
                                          "result = vec4(pow(vec3(0.5) + 0.5 * cos(vec3(9.0, 11.0, 13.0) * r), "
                                          "vec3(2.2)), 1.0); gl_FragDepth = r; }\n"));
    rectangle(-1, 1, -1, 1).draw(program);
    return target.read_pixels();
}

/// Draws in a child and gives what it saw; empty if the child failed.
Image draw_in_child()
{
    void* shared = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);  // a child that hangs must not hang the test
        std::memcpy(shared, draw().cells.data(), bytes);
        _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    Image picture;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        picture = Image(size, size);
        std::memcpy(picture.cells.data(), shared, bytes);
    }
    munmap(shared, bytes);
    return picture;
}

TEST_F(Forks, children_draw_the_same_pixels)
{
    const Image first = draw_in_child();  // before the parent has drawn anything
    ASSERT_EQ(first.width, size);
    const Image own = draw();
    const Image after = draw_in_child();
    const Image again = draw_in_child();
    EXPECT_TRUE(first.cells == own.cells);
    EXPECT_TRUE(after.cells == own.cells);
    EXPECT_TRUE(again.cells == own.cells);
    EXPECT_TRUE(draw().cells == own.cells);
    // And it is a picture: the middle is white, the corner the background.
    EXPECT_EQ(own.at(0, 0), glm::u8vec4(51, 102, 153, 255));
    EXPECT_GT(own.at(size / 2, size / 2).r, 240);
}

// A child has only the thread that forked: the driver must not wait for others. (An empty shader cache on the disk is
// what made it hang.)
TEST_F(Forks, the_driver_starts_no_threads)
{
    (void)draw();
    const std::filesystem::directory_iterator threads("/proc/self/task");
    EXPECT_EQ(std::distance(begin(threads), end(threads)), 1);
}

TEST_F(Forks, a_childs_state_stays_in_the_child)
{
    glClearColor(0.5F, 0, 0, 1);
    const pid_t child = fork();
    if (child == 0) {
        glClearColor(1, 1, 1, 1);
        glFinish();
        _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    float color[4] = {};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color);
    EXPECT_EQ(color[0], 0.5F);
}

}
}
