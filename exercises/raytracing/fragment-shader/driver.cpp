#include <umbral/record/driver.hpp>

#include "scenes.hpp"

namespace umbral {
namespace {

using namespace raytracing;

// One case for the pictures of each shader: compiling takes the most time.
void record_balls(Case& what, Recorder& out)
{
    const auto program = compile_ray_tracer(what);
    out.image("evening", drawn(out, *program, varied(what.vary, evening()), 320, 240));
    out.image("matt", drawn(out, *program, varied(what.vary, matt()), 128, 96));
    out.image("one level", drawn(out, *program, varied(what.vary, mirrors(1)), 96, 72));
    out.image("four levels", drawn(out, *program, varied(what.vary, mirrors(4)), 128, 96));
}

void record_sponges(Case& what, Recorder& out)
{
    const auto program = compile_distance_field(what);
    out.image("carved", drawn(out, *program, varied(what.vary, carved()), 160, 120));
    out.image("cube", drawn(out, *program, varied(what.vary, drilled(0)), 64, 48));
    out.image("drilled", drawn(out, *program, varied(what.vary, drilled(2)), 144, 108));
}

}

const Driver driver = {
    {"balls", record_balls},
    {"sponge", record_sponges},
    {"rays",
     [](Case& c, Recorder& out) {
         record_rays(out, "balls", c.once([&] { return compile_ray_tracer(c); }), random_ball_rays(c.random, 250));
     }},
    {"marches",
     [](Case& c, Recorder& out) {
         record_rays(out, "sponge", c.once([&] { return compile_distance_field(c); }),
                     random_sponge_rays(c.random, 200));
     }},
};

}
