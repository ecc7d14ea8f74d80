#include <umbral/record/driver.hpp>

#include "probes.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record_points(Recorder& out, std::string_view name, const std::vector<Probe>& probes, const gl::Program& program)
{
    for (const glm::vec3& color : colors_of(probes, program)) out.append(name, color);
}

// One case for many pictures: most of a run's time goes into compiling the shaders.
void record_pictures(Case& what, Recorder& out)
{
    const auto program = compile(what);
    const auto record = [&](const char* name, const Scene& scene) { out.image(name, draw(scene, *program)); };
    record("still life", still_life());
    record("diffuse sphere", diffuse_sphere());
    record("exponents", exponents());
    record("near lamps", near_lamps());
    record("eight lights", eight_lights());
    record("scaled", scaled_things());
    record("coarse smooth", coarse_sphere(false));
    record("coarse flat", coarse_sphere(true));
    record("bowls smooth", bowls(false));
    record("bowls flat", bowls(true));
}

}

const Driver driver = {
    {"pictures", record_pictures},
    {"edges", [](Case& c, Recorder& out) { record_points(out, "colors", edges(), *compile(c)); }},
    {"random",
     [](Case& c, Recorder& out) {
         const auto program = compile(c);
         record_points(out, "points", random_points(c.random), *program);
         out.image("smooth", draw(random_scene(c.random, false), *program));
         out.image("flat", draw(random_scene(c.random, true), *program));
     }},
};

}
