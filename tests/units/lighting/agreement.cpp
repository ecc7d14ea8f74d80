// Prints how far the three ways to draw a lit scene are apart: OpenGL's fixed function, shaders, software.
// Usage: lighting-agreement [--quick]

#include <cstdio>
#include <string_view>
#include <umbral/gl/context.hpp>

#include "three_ways.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

constexpr int size = 256;

void print(const char* name, const LitScene& scene, const gl::Program& program)
{
    const Grid<glm::vec3> fixed = by_fixed_function(scene, size);
    const Grid<glm::vec3> shaders = by_shaders(scene, size, program);
    const Grid<glm::vec3> software = in_software(scene, size);
    const Grid<glm::vec3> vertices = light_at_vertices(scene, size);
    const auto text = [](const Distance& d) { std::printf(" %.1e / %.1e |", d.largest, d.rms); };
    std::printf("| %s |", name);
    text(distance(shaders, software));
    text(distance(fixed, software));
    text(distance(fixed, vertices));
    std::printf("\n");
}

}

int main(int count, char** arguments)
{
    const bool is_quick = count > 1 && std::string_view(arguments[1]) == "--quick";
    const std::vector<int> meshes = is_quick ? std::vector{16, 32} : std::vector{16, 32, 64, 128};
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    const gl::Program program = reference_shaders();
    std::printf(
        "| scene: largest / RMS difference of light | shaders, software | fixed, software | fixed, vertices |\n");
    std::printf("|---|---|---|---|\n");
    for (const int longitudes : meshes)
        print(("matt ball, " + std::to_string(longitudes) + " longitudes").c_str(), ball(longitudes, 0, 1), program);
    for (const int longitudes : meshes)
        print(("shiny ball, " + std::to_string(longitudes) + " longitudes").c_str(), ball(longitudes, 0.5F, 30),
              program);
    LitScene sharp = ball(128, 0.5F, 128);
    print("shiny ball, e = 128", sharp, program);
    sharp.things.front().material.shininess = 400;
    print("shiny ball, e = 400", sharp, program);
    LitScene distant = ball(128, 0.5F, 30);
    distant.lighting.local_viewer = false;
    print("distant viewer", distant, program);
    LitScene flat = ball(32, 0.5F, 30);
    flat.lighting.flat_shading = true;
    print("flat, 32 longitudes", flat, program);
}
