#include <umbral/record/driver.hpp>

#include "activation.hpp"
#include "drawn.hpp"
#include "held_keys.hpp"
#include "lights.hpp"
#include "program.hpp"
#include "round_the_can.hpp"
#include "tables.hpp"

namespace umbral {
namespace {

using namespace texturing;

// The program.

/// Frames are looked at in the middle between two of these, which are a fifth of a second apart.
constexpr const char* a_visit = R"(
0.2 key 4 press
0.25 key 4 release
0.4 key P press
0.45 key P release
0.6 key 4 press
0.65 key 4 release
0.8 key 4 press
0.85 key 4 release
1.0 key RIGHT press
1.05 key RIGHT release
1.2 key A press
1.25 key A release
)";

void textures_of_program(Case&, Recorder& out)
{
    const Session session(a_visit, {.uploads = true});
    out.columns("texels", "texels in OpenGL, uploads after the frame of the first");
    for (int i = 1; i <= 13; i += 2) {
        const double time = 0.1 * i + 0.08;
        tell(out, a_visit, time);
        const TexelsSeen seen = session.frame_at(time).texels;
        out.append("texels", glm::vec2(seen[0], seen[1]));
    }
}

void looks_of_program(Case& c, Recorder& out)
{
    const Session session(a_visit, {.start = first_pose(c.vary)});
    out.text("looks.names", "0 moment\n1 thing: M_D/3, M_S/3, e, textured, depth test, place/3, projection/2\n");
    for (int i = 1; i <= 13; i += 2) {
        const double time = 0.1 * i + 0.08;
        tell(out, a_visit, time);
        std::array<float, 15> row{};
        row[1] = static_cast<float>(i);
        out.append("looks", std::span<const float>(row));
        for (const Look& look : session.frame_at(time).looks) {
            row[0] = 1;
            std::copy(look.begin(), look.end(), row.begin() + 1);
            out.append("looks", std::span<const float>(row));
        }
    }
}

void pictures_of_program(Case& c, Recorder& out)
{
    const Session session(a_visit, {.pictures = {0.38, 0.78, 0.98, 1.18},
                                    .pixels = 2,
                                    .motion = {{1.0, {.longitude = 0.9F}}},
                                    .start = first_pose(c.vary)});
    const auto show = [&](const char* name, double time) {
        tell(out, a_visit, time);
        const Image picture = session.frame_at(time).picture;
        out.image(name, picture.width > 0 ? halved(picture) : Image(lab4::width, lab4::height));
    };
    show("5 scene", 0.38);
    show("6 earlier labs", 0.78);
    show("scene again", 0.98);
    show("scene turned", 1.18);
}

}

const Driver driver = {
    {"1 normals", normals},
    {"1 random normals", random_normals},
    {"1 degenerate", odd_normals},
    {"1 cost", cost_of_normals},
    {"2 flat", [](Case& c, Recorder& out) { record_drawn(out, c.random, Shading::flat); }},
    {"2 smooth", [](Case& c, Recorder& out) { record_drawn(out, c.random, Shading::smooth); }},
    {"2 state", state_after_drawing},
    {"3 revolution", known_surfaces},
    {"3 random profiles", random_surfaces},
    {"4 table", [](Case& c, Recorder& out) { record_textures(out, c.random, false); }},
    {"4 generated", [](Case& c, Recorder& out) { record_textures(out, c.random, true); }},
    {"4 made once", [](Case& c, Recorder& out) { record_names(out, c); }},
    {"4 program", textures_of_program},
    {"5 materials", materials},
    {"5 activated", activated_materials},
    {"5 program", looks_of_program},
    {"5 round the can", round_the_can},
    {"pictures", pictures_of_program},
    {"6 directions", directions},
    {"6 lights", lights},
    {"6 program", lights_of_program},
};

}
