#pragma once

#include "program.hpp"

/// Case of rubric line 5: the scene from all sides, in windows of other sizes. What is recorded is which material is
/// seen where, so that normals, textures and lights have no part in it.
namespace umbral::texturing {

/// One view: the window gets another size while the camera goes to another place.
struct View {
    const char* name;
    double time;
    glm::ivec2 size;
    CameraPose pose;
};

inline void round_the_can(Case& c, Recorder& out)
{
    std::array<View, 4> views = {{{"from above", 0.4, {560, 420}, {0.3F, 1.15F, 24}},
                                  {"from below", 0.6, {420, 420}, {-0.4F, -0.8F, 30}},
                                  {"tall window", 0.8, {320, 480}, {0.12F, 0.36F, 34}},
                                  {"long lens", 1.0, {640, 400}, {0.9F, 0.2F, 12}}}};
    for (View& view : views) {
        view.size = c.vary.near(view.size, 30);
        view.pose.longitude = c.vary.near(view.pose.longitude, 0.3F);
    }
    std::string script = "0.2 key 4 press\n0.25 key 4 release\n";
    Wanted wanted{.pixels = 1};
    for (const View& view : views) {
        script += std::to_string(view.time) + " resize " + std::to_string(view.size.x) + " " +
                  std::to_string(view.size.y) + "\n";
        wanted.worn.push_back(view.time + 0.18);
        wanted.motion.push_back({view.time, view.pose});
    }
    const Session session(script, wanted);
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double moment = wanted.worn[i];
        tell(out, script, moment);
        const Image worn = session.frame_at(moment).worn;
        out.image(views.at(i).name, worn.width > 0 ? worn : Image(views.at(i).size.x, views.at(i).size.y));
    }
}

}
