#include <umbral/record/driver.hpp>

#include "scenes.hpp"

namespace umbral {
namespace {

using namespace pipeline;

// One case for many pictures: most of a run's time goes into compiling the shaders.
void pictures(Case& what, Recorder& out)
{
    const gl::Program program = mirror_program(what);
    program.require_interface(mirror_interface());
    const auto seen = [&](Scene scene) { return varied(what.vary, std::move(scene)); };
    out.image("lake", draw(out, seen(lake()), program, 384, 288));
    out.image("wall", draw(out, seen(wall(Look::places)), program, 192, 192));
    out.image("light", draw(out, seen(wall(Look::light, -1)), program, 192, 192));
    // The unit of length may be of any size: a part of a unit that is added or compared with shows in one of them.
    const auto unit = [&](float written) { return what.vary.scaled(written, 2); };
    out.image("cut", draw(out, in_units(seen(cut()), unit(400)), program, 192, 192));
    out.image("small cut", draw(out, in_units(seen(cut()), unit(0.002F)), program, 192, 192));
    out.image("bowls", draw(out, seen(bowls(glm::vec3(1))), program, 192, 192));
    // Upside down, and varied, any way round: all that makes triangles run clockwise is a mirror, not where it faces.
    const glm::mat3 turn = what.vary.exact_map(0).matrix() * glm::mat3(-1, 0, 0, 0, -1, 0, 0, 0, 1);
    out.image("mirrored bowls",
              draw(out, turned(in_units(seen(bowls({1, 1, -1})), unit(2e-5F)), turn), program, 192, 192));
    out.image("long normal", draw(out, seen(with_normal(what.vary.scaled(500.0F, 2))), program, 192, 192));
    out.image("short normal", draw(out, seen(with_normal(what.vary.scaled(0.0005F, 2))), program, 192, 192));
    out.image("stretched", draw(out, seen(stretched()), program, 192, 192));
}

void random(Case& what, Recorder& out)
{
    const gl::Program program = mirror_program(what);
    program.require_interface(mirror_interface());
    const glm::vec3 anywhere = opposite_signs(what.random).first;
    const auto [one, other] = opposite_signs(what.random);
    out.image("places", draw(out, random_scene(what.random, Look::places, anywhere), program, 160, 160));
    out.image("first", draw(out, random_scene(what.random, Look::all, one), program, 160, 160));
    out.image("second", draw(out, random_scene(what.random, Look::all, other), program, 160, 160));
}

}

const Driver driver = {
    {"pictures", pictures},
    {"random", random},
};

}
