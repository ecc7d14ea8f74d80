#include <umbral/record/driver.hpp>

#include "probes.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record_points(Recorder& out, std::string_view name, const std::vector<Probe>& probes, const gl::Program& program)
{
    std::vector<PointInputs> points;
    for (const Probe& probe : probes) points.push_back(inputs_of(probe));
    record_single_points(
        out, name, "the shaders", points,
        [](const PointInputs&) { return "// a point that lies here in eye coordinates:\n"; },
        [&](const std::vector<PointInputs>& inputs) {
            std::vector<Probe> asked;
            for (const PointInputs& one : inputs) asked.push_back(probe_of(one));
            return colors_of(asked, program);
        });
}

// A scene as one picture.
void record_scene(Recorder& out, std::string_view name, const Scene& scene, const gl::Program& program,
                  const glm::vec3& background = default_background)
{
    ask_scene(out, scene);
    out.image(name, draw(scene, program, background));
}

// A still life with the world turned under it, lights and all, first without the camera and then with it; and in half
// the light, and all of it, on black. Lights are given in eye coordinates: those that turn with the camera stay what
// they are.
void record_laws(Recorder& out, const Scene& still_life, const gl::Program& program)
{
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.9F, normalize(glm::vec3(0.4F, 1, -0.3F)));
    Scene scene = still_life;
    for (Thing& thing : scene.things) thing.model = turned * thing.model;
    record_scene(out, "turned alone", scene, program);
    scene.view = scene.view * inverse(turned);
    record_scene(out, "turned together", scene, program);

    Scene dim = still_life;
    dim.global_ambient *= 0.5F;
    for (Light& light : dim.lights) light.color *= 0.5F;
    for (Thing& thing : dim.things) {
        thing.material.emission = glm::vec3(0);
        thing.material.specular *= 0.4F;
    }
    record_scene(out, "half the light", dim, program, glm::vec3(0));
    dim.global_ambient *= 2.0F;
    for (Light& light : dim.lights) light.color *= 2.0F;
    record_scene(out, "all the light", dim, program, glm::vec3(0));
}

// One case for many pictures: most of a run's time goes into compiling the shaders.
void record_pictures(Case& what, Recorder& out)
{
    const gl::Program& program = compiled(what);
    const auto record = [&](const char* name, const Scene& scene) {
        record_scene(out, name, varied(what.vary, scene), program);
    };
    const Scene still = varied(what.vary, still_life());
    record_scene(out, "still life", still, program);
    record("diffuse sphere", diffuse_sphere());
    record("exponents", exponents());
    record("near lamps", near_lamps());
    record("eight lights", eight_lights());
    record("scaled", scaled_things());
    record("coarse smooth", coarse_sphere(false));
    record("coarse flat", coarse_sphere(true));
    record("bowls smooth", bowls(false));
    record("bowls flat", bowls(true));
    record_laws(out, still, program);
}

}

const Driver driver = {
    {"pictures", record_pictures},
    {"edges", [](Case& c, Recorder& out) { record_points(out, "colors", edges(c.vary), compiled(c)); }},
    {"random",
     [](Case& c, Recorder& out) {
         const gl::Program& program = compiled(c);
         record_points(out, "points", random_points(c.random), program);
         record_scene(out, "smooth", random_scene(c.random, false), program);
         record_scene(out, "flat", random_scene(c.random, true), program);
     }},
};

}
