#include <umbral/record/driver.hpp>

#include "probes.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record_first_pass(Case& what, Recorder& out)
{
    const gl::Program& distances = what.once([&] { return compile_distances(what); });
    record_distances(out, probe_pairs(what.random, 60, {0.2, 1, 0.05}), distances);
    // A lamp's view and a sun's, side by side.
    const glm::vec3 lamp = what.vary.near(glm::vec3(1, 2.2F, 2.5F), 0.5F);
    const glm::vec3 sun = what.vary.near(glm::vec3(-0.6F, 1, 0.8F), 0.4F);
    const Grid<float> lamps = map_of(out, distances, seen_by(lamp_at(lamp, {0.1F, -0.3F, 0}, 55, 1.3F)));
    out.tile("map", 0, 0, lamps.width, lamps.height);
    const Grid<float> suns = map_of(out, distances, seen_by(sun_from(sun, {0, 0, 0}, {2.2F, 1.6F})));
    out.tile("map", lamps.width, 0, suns.width, suns.height);
    Grid<float> both(lamps.width + suns.width, lamps.height);
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x)
            both.at(x, y) = x < lamps.width ? lamps.at(x, y) : suns.at(x - lamps.width, y);
    out.buffer("map", both);
}

void record_pictures(Case& what, Recorder& out)
{
    const auto distances = compile_distances(what);
    const auto shadows = compile_shadows(what);
    const auto record = [&](const char* name, const ShadowScene& scene, int width, int height) {
        out.image(name, picture_of(out, *distances, *shadows, varied(what.vary, scene), width, height));
    };
    record("courtyard", courtyard(), 480, 360);
    record("slopes", slopes(), 240, 160);
    record("coarse map", coarse_map(), 160, 120);
    record("lamp", lamp(), 200, 150);
    record("beyond the map", beyond_the_map(), 160, 120);
    record("stretched", stretched(), 160, 120);
}

void record_pairs(Case& what, Recorder& out)
{
    std::vector<ShadowProbe> probes = probe_pairs(what.random, 100, {});
    const std::vector<ShadowProbe> grazing = probe_pairs(what.random, 20, {0.02, 0.05, 0.05});
    probes.insert(probes.end(), grazing.begin(), grazing.end());
    record_colors(out, probes, compiled_shadows(what));
}

}

const Driver driver = {
    {"pictures", record_pictures},
    {"first pass", record_first_pass},
    {"points", record_pairs},
    // Where the surface faces the light, only the constant is left of the bias, and float may make a cosine above 1; in
    // fine maps, so that what float makes of the angle does not count.
    {"facing",
     [](Case& c, Recorder& out) {
         record_colors(out, probe_pairs(c.random, 40, {1, 1, 0.4, 32}), compiled_shadows(c));
     }},
    {"off the map",
     [](Case& c, Recorder& out) { record_colors(out, probes_off_the_map(c.random, 60), compiled_shadows(c)); }},
    {"random", record_pairs},
};

}
