// Prints how much of a highlight each shading method shows on spheres of few triangles: the table in the statement of
// lighting/flat-gouraud-phong. Usage: flat-gouraud-phong-accuracy [SEED [DIRECTIONS]]

#include <cstdio>
#include <cstdlib>
#include <lighting/flat-gouraud-phong/knot.hpp>
#include <umbral/core/random.hpp>

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int directions = count > 2 ? std::atoi(arguments[2]) : 100;
    std::printf("seed %llu, %d directions of light; mean of the brightest pixel of 96 x 96\n",
                static_cast<unsigned long long>(seed), directions);
    constexpr int pixels = 96;
    constexpr glm::vec3 eye(0, 0, 100);
    const glm::mat4 camera = glm::ortho(-1.1F, 1.1F, -1.1F, 1.1F, 1.0F, 200.0F) * glm::translate(glm::mat4(1), -eye);
    const std::pair<const char*, decltype(&draw_flat)> methods[] = {
        {"flat", draw_flat}, {"Gouraud", draw_gouraud}, {"Phong", draw_phong}};
    for (const auto& [name, draw] : methods) {
        std::printf("%-8s", name);
        for (const int n : {8, 16, 32, 64}) {
            const shapes::Shape shape = shapes::sphere(n, n / 2);
            const std::vector<glm::uvec3> triangles = triangles_of(shape);
            Random random(seed);
            double sum = 0;
            for (int i = 0; i < directions; ++i) {
                const glm::mat4 turned = glm::rotate(glm::mat4(1), random.uniform(0, 6), random.unit_vector());
                const std::vector<StagedVertex> vertices = staged(shape, turned, camera, glm::vec2(pixels));
                const glm::vec3 l = normalize(0.7F * random.in_cube() + glm::vec3(0, 0, 1));
                const auto highlight = [&](const SurfacePoint& at) {
                    return glm::vec3(blinn_highlight(at.normal, l, eye - at.position, 50));
                };
                pipeline::Layer layer{Grid<glm::vec3>(pixels, pixels, glm::vec3(0)), Grid<float>(pixels, pixels, 1)};
                draw(vertices, triangles, highlight, layer);
                float most = 0;
                for (const glm::vec3& light : layer.colors.cells) most = std::max(most, light.x);
                sum += double{most};
            }
            std::printf("  %5.3f", sum / directions);
        }
        std::printf("\n");
    }
}
