#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "picture.hpp"
#include "questions.hpp"

namespace umbral {
namespace {

using namespace raytracing;
using namespace raytracing::whitted;

void name_world(Recorder& out, const BuiltWorld& world)
{
    if (Questions* const questions = out.questions()) questions->set_object(&world, "world", world_in_words(world));
}

void record_direct(Recorder& out, const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                   const glm::vec3& l)
{
    out.columns("light", "red, green, blue");
    out.append("light", ask<direct_light>(out, material, normal, v, l));
}

// Answers that can be worked out by hand: vectors of 3, 4 and 5, whole exponents.
void direct_by_hand(Variation& vary, Recorder& out)
{
    const glm::vec3 up(0, 0, 1);
    lighting::Material matt_red{{}, {0.125F, 0, 0}, {0.5F, 0.25F, 0}, {}, 1};
    lighting::Material shiny{{9, 9, 9}, {0.1F, 0.2F, 0.3F}, {0.5F, 0.5F, 0.5F}, {1, 0.5F, 0.25F}, 2};
    for (lighting::Material* const material : {&matt_red, &shiny})
        for (glm::vec3* const color : {&material->ambient, &material->diffuse, &material->specular})
            *color *= vary.scaled(1.0F, 1.3F);
    record_direct(out, matt_red, up, up, up);
    record_direct(out, matt_red, up, {0.6F, 0, 0.8F}, {0.6F, 0, 0.8F});
    record_direct(out, matt_red, up, {0.6F, 0, 0.8F}, {0, 0.8F, -0.6F});
    record_direct(out, shiny, up, up, up);
    record_direct(out, shiny, up, up, {0.6F, 0, 0.8F});
    record_direct(out, shiny, up, {-0.6F, 0, 0.8F}, {0.6F, 0, 0.8F});
    record_direct(out, shiny, up, {0.6F, 0, 0.8F}, {0.6F, 0, 0.8F});
    record_direct(out, shiny, up, {0.8F, 0, 0.6F}, {0.8F, 0, 0.6F});
    record_direct(out, shiny, up, {0, 0.6F, 0.8F}, {0.6F, 0, 0.8F});
    record_direct(out, shiny, up, {-0.6F, 0, 0.8F}, {1, 0, 0});
    record_direct(out, shiny, {0, 1, 0}, {-0.6F, 0.8F, 0}, {0, -0.6F, 0.8F});
    record_direct(out, shiny, {0.6F, 0.8F, 0}, {0, 1, 0}, {1, 0, 0});
    record_direct(out, shiny, {0.6F, 0.8F, 0}, {0, 0.8F, 0.6F}, {0, 1, 0});
}

void direct_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 normal = random.unit_vector();
        // Every tenth viewer is right above.
        const float sine = i % 10 == 9 ? 0.0F : random.uniform(0, 0.99F);
        const glm::vec3 v = tilted(normal, i % 3 == 2 ? 0.98 : sine, random);
        const glm::vec3 jitter = random.in_cube();
        const glm::vec3 opposite = 2 * dot(normal, v) * normal - v;
        // Anywhere; where the viewer's mirror image stands, so that highlights are seen; and below the horizon there.
        const glm::vec3 l[] = {jitter, opposite + 0.3F * jitter, opposite - 0.45F * normal + 0.1F * jitter};
        lighting::Material material = matt(random).local;
        if (i % 7 == 0) material.specular = random_light_color(random);
        if (i % 7 == 1) material.diffuse = glm::vec3(0);
        if (i % 7 == 2) material.ambient = glm::vec3(0);
        const glm::vec3 towards = i % 20 == 12 ? normal : normalize(l[i % 3]);
        record_direct(out, material, normal, v, towards);
        if (i % 10 != 1) continue;
        // The same place of materials that differ in one number.
        const auto allowed = [](const lighting::Material& one) { return one.shininess >= 1 && one.shininess <= 100; };
        for (const lighting::Material& changed : numbers_changed(random, material, 5, allowed))
            record_direct(out, changed, normal, v, towards);
    }
}

void record(Recorder& out, const Look& look)
{
    name_world(out, look.world);
    (void)look.world.take_rays();
    out.columns("light", "red, green, blue");
    const glm::vec3 light = ask<light_towards>(out, look.world, look.hit, look.v, look.level);
    out.append("light", light);
    out.append("rays", static_cast<float>(look.world.take_rays()));
}

void record(Recorder& out, const BuiltWorld& world, const Ray& ray, int level)
{
    name_world(out, world);
    (void)world.take_rays();
    out.columns("light", "red, green, blue");
    const glm::vec3 light = ask<light_along>(out, world, ray, level);
    out.append("light", light);
    out.append("rays", static_cast<float>(world.take_rays()));
}

void shadows(Recorder& out, Random& random)
{
    std::vector<Look> looks;
    for (int i = 0; i < 60; ++i) add_shadow_pair(looks, i, random);
    for (const Look& look : looks) record(out, look);
}

void sky_and_surface(Recorder& out, Random& random)
{
    for (int i = 0; i < 60; ++i) {
        BuiltWorld world;
        world.global = random_color(random);
        world.levels = 1 + static_cast<int>(random.below(4));
        const glm::vec3 way = random.unit_vector();
        world.balls.push_back({5.0F * way, 1, matt(random)});
        if (i % 5 == 0) world.balls.back().material.local.emission *= std::exp2(random.uniform(4, 14));
        const glm::vec3 aside(perpendicular_to(glm::dvec3(way), random));
        Ray ray{0.5F * aside, way};
        if (i % 4 == 0) ray.direction = random.unit_vector();
        if (i % 4 == 1) ray.t_max = 3;
        if (i % 4 == 2) ray.t_min = 5.5F;
        record(out, world, ray, 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(world.levels + 1))));
    }
}

// Two mirrors that face each other, and a pane of glass between them that bends nothing: rays branch at it, and come
// back for ever.
void levels(Variation& vary, Recorder& out)
{
    Material silver;
    silver.local = {{0.5F, 0.25F, 0.125F}, {0.1F, 0.1F, 0.1F}, {}, {}, 1};
    silver.local.emission *= vary.scaled(1.0F, 1.3F);
    silver.mirrored = vary.near(0.5F, 0.1F);
    silver.mirrored_color = {1, 0.5F, 1};
    Material pane = silver;
    pane.local.emission = {0, 0.125F, 1};
    pane.refracted = vary.near(0.75F, 0.1F);
    pane.refracted_color = {1, 1, 0.5F};
    BuiltWorld world;
    for (const float x : {-2.0F, 2.0F}) world.panels.push_back({{x, -4, -4}, {0, 8, 0}, {0, 0, 8}, silver});
    world.sources.push_back({{0, 5, 1, 0}, {1, 1, 2}});
    const Ray way{{-1, 0.5F, 0.25F}, {1, 0, 0}};
    for (const bool with_pane : {false, true}) {
        if (with_pane) world.panels.push_back({{0.5F, -4, -4}, {0, 8, 0}, {0, 0, 8}, pane});
        for (world.levels = 1; world.levels <= (with_pane ? 6 : 12); ++world.levels) {
            for (int level = 1; level <= world.levels; level += 2) record(out, world, way, level);
            for (int level = world.levels + 1; level <= world.levels + 2; ++level) record(out, world, way, level);
        }
    }
}

// A glass ball and a block of glass, from before and from within.
void glass_bodies(Recorder& out, Random& random)
{
    for (int i = 0; i < 120; ++i) {
        BuiltWorld world;
        Material glass = matt(random);
        glass.refracted = random.uniform(0.5F, 1);
        glass.refracted_color = random_color(random);
        // Every other one is a ball of air in a world of glass.
        glass.index = random.uniform(1.1F, 2);
        if (i / 2 % 2 == 0) glass.index = 1 / glass.index;
        if (i % 3 == 0) glass.mirrored = random.uniform(0.2F, 0.5F);
        const glm::vec3 centre = 2.0F * random.in_cube();
        world.balls.push_back({centre, random.uniform(0.5F, 1.5F), glass});
        add_lights(world, static_cast<std::uint32_t>(i % 3), random);
        world.levels = 2 + static_cast<int>(random.below(3));
        const glm::vec3 way = random.unit_vector();
        const double aside = 0.9 * double{world.balls[0].radius} * random.uniform_double();
        const glm::vec3 off(aside * perpendicular_to(glm::dvec3(way), random));
        record(out, world, {centre + off - (i % 4 == 0 ? 0.0F : 3.0F) * way, way}, 1);
    }
}

void random_worlds(Recorder& out, Random& random)
{
    for (int i = 0; i < 12; ++i) {
        const BuiltWorld world = random_world(random);
        for (int j = 0; j < 25; ++j) {
            const glm::vec3 origin = 7.0F * random.unit_vector();
            const glm::vec3 target = 2.0F * random.in_cube();
            record(out, world, {origin, normalize(target - origin)}, 1);
        }
    }
}

template <class Make>
void looks(Recorder& out, Random& random, int count, Make make)
{
    for (int i = 0; i < count; ++i) {
        Look look = make(random, static_cast<std::uint32_t>(i % 3));
        record(out, look);
        if (i % 8 != 3) continue;
        // The same at another level.
        look.level = look.level < look.world.levels ? look.world.levels : 1;
        record(out, look);
    }
}

void record_picture(Variation& vary, Recorder& out)
{
    ask_in_words(out, [] { return "light_along(world, ray, 1) // of four rays for each pixel"; });
    out.image("glass and mirrors", glass_and_mirrors(vary));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { direct_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { direct_random(out, c.random); }},
    {"sky and surface", [](Case& c, Recorder& out) { sky_and_surface(out, c.random); }},
    {"shadows", [](Case& c, Recorder& out) { shadows(out, c.random); }},
    {"lights",
     [](Case& c, Recorder& out) {
         looks(out, c.random, 150, [](Random& random, std::uint32_t) { return many_lights(random); });
     }},
    {"mirror", [](Case& c, Recorder& out) { looks(out, c.random, 90, mirror_of_the_far_off); }},
    {"glass", [](Case& c, Recorder& out) { looks(out, c.random, 150, glass_before_the_far_off); }},
    {"levels", [](Case& c, Recorder& out) { levels(c.vary, out); }},
    {"glass bodies", [](Case& c, Recorder& out) { glass_bodies(out, c.random); }},
    {"random worlds", [](Case& c, Recorder& out) { random_worlds(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
