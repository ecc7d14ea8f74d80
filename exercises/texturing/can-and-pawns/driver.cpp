#include <umbral/record/driver.hpp>

#include "activation.hpp"
#include "drawn.hpp"
#include "lights.hpp"
#include "program.hpp"
#include "tables.hpp"

namespace umbral {
namespace {

using namespace texturing;

// The program.

/// What is done to the window until a moment.
void tell(Recorder& out, const char* script, double until)
{
    ask_in_words(out, [&] {
        std::string text = "run_lab4(files, earlier);";
        input::EventScript all = input::parse_script(script);
        std::erase_if(all, [&](const input::TimedEvent& event) { return event.time > until; });
        return text + '\n' + input::to_text(all);
    });
}

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

void looks_of_program(Case&, Recorder& out)
{
    const Session session(a_visit, {});
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

void pictures_of_program(Case&, Recorder& out)
{
    const Session session(a_visit, {.pictures = true, .pixels = 2});
    const auto show = [&](const char* name, double time) {
        tell(out, a_visit, time);
        const Image picture = session.frame_at(time).picture;
        out.image(name, picture.width > 0 ? halved(picture) : Image(lab4::width, lab4::height));
    };
    show("5 scene", 0.38);
    show("6 earlier labs", 0.78);
    show("scene again", 0.98);
}

/// What the keys of the light do: pressed, repeated, with Shift, up to the highest latitude, and outside the mode.
constexpr const char* keys_of_light = R"(
0.05 key X press
0.1 key X release
0.2 key 4 press
0.25 key 4 release
0.4 key A press
0.42 key A repeat
0.44 key A repeat
0.46 key A release
0.6 key X press
0.65 key X release
0.8 key LEFT_SHIFT press
0.81 key Z press
0.82 key Z release
0.83 key C press
0.84 key C repeat
0.85 key C release
0.86 key LEFT_SHIFT release
1.0 key RIGHT press
1.05 key RIGHT release
1.2 key A press
1.21 key A repeat
1.22 key A repeat
1.23 key A repeat
1.24 key A repeat
1.25 key A repeat
1.26 key A repeat
1.27 key A repeat
1.28 key A repeat
1.29 key A repeat
1.3 key A repeat
1.31 key A release
1.4 key Z press
1.45 key Z release
1.6 key 4 press
1.61 key 4 release
1.65 key A press
1.66 key A release
1.8 key 4 press
1.85 key 4 release
2.0 key P press
2.05 key P release
)";

void lights_of_program(Case&, Recorder& out)
{
    const Session session(keys_of_light, {});
    out.columns("lights", "directional lights, positional lights, direction/3, place/3, colour/3, colour/3");
    for (int i = 1; i <= 21; i += 2) {
        const double time = 0.1 * i + 0.08;
        tell(out, keys_of_light, time);
        const Frame frame = session.frame_at(time);
        out.append("lights", std::span<const float>(frame.lights));
        out.append("mode", frame.earlier ? 1.0F : 0.0F);
    }
    tell(out, keys_of_light, 3);
    out.text("passed on.names", "1 key: number, action, modifiers\n");
    for (const auto& [key, action, mods] : session.earlier().keys) {
        // Of these the interface leaves open where they go.
        const bool of_light = key == GLFW_KEY_A || key == GLFW_KEY_Z || key == GLFW_KEY_X || key == GLFW_KEY_C;
        if (key == GLFW_KEY_4 || (of_light && action == GLFW_RELEASE)) continue;
        const std::array<float, 4> row = {1, static_cast<float>(key), static_cast<float>(action),
                                          static_cast<float>(mods)};
        out.append("passed on", std::span<const float>(row));
    }
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
    {"4 made once", [](Case& c, Recorder& out) { record_names(out, c.random); }},
    {"4 program", textures_of_program},
    {"5 materials", materials},
    {"5 activated", activated_materials},
    {"5 program", looks_of_program},
    {"pictures", pictures_of_program},
    {"6 directions", directions},
    {"6 lights", lights},
    {"6 program", lights_of_program},
};

}
