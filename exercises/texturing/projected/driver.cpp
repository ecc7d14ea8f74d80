#include <umbral/record/driver.hpp>

#include "points.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace texturing;

// One case for many pictures: most of a run's time goes into compiling the shaders.
void record_pictures(Case& what, Recorder& out)
{
    const auto program = compile(what);
    {
        const Slide rose(rose_window(512));
        out.image("steps", draw(out, *program, varied(what.vary, steps()), 480, 360));
    }
    const Slide braid(braid_tile(128));
    const auto record = [&](const char* name, const Scene& scene) {
        out.image(name, draw(out, *program, varied(what.vary, scene), 160, 120));
    };
    record("wall", wall());
    record("corridor", corridor());
    record("floor", floor_of_two_triangles());
    record("balls", stretched_balls());
    record("shifted lens", shifted_lens());
}

void record_random(Case& what, Recorder& out, const char* name, int count)
{
    const gl::Program& program = compiled(what);
    const Slide slide(random_texture(what.random, 4, 3));
    record_points(out, name, random_points(what.random, count), program);
}

}

const Driver driver = {
    {"pictures", record_pictures},
    {"points", [](Case& c, Recorder& out) { record_random(c, out, "colors", 200); }},
    {"edges",
     [](Case& c, Recorder& out) {
         const gl::Program& program = compiled(c);
         const Slide slide(random_texture(c.random, 4, 3));
         record_points(out, "colors", edges(c.random), program);
     }},
    {"random", [](Case& c, Recorder& out) { record_random(c, out, "colors", 200); }},
};

}
