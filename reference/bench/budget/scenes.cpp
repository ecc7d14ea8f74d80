#include "scenes.hpp"

#include "scene/scene_json.hpp"

namespace umbral::bench {

std::vector<scene::Scene> budget_scenes(const std::filesystem::path& folder)
{
    const scene::Scene first = scene::read_scene(folder / "first-light.json");
    const scene::Scene whitted = scene::read_scene(folder / "whitted.json");
    const scene::Scene soft = scene::read_scene(folder / "soft-light.json");
    const scene::Scene box = scene::read_scene(folder / "box.json");
    std::vector<scene::Scene> all = {first, whitted, soft, box, first, soft, box, box};
    all[4].title += ", under a hazy sun";
    for (scene::Light& light : all[4].lights) {
        light.half_angle_degrees = light.positional ? 0.0F : 8.0F;
        light.radius = light.positional ? 0.5F : 0.0F;
    }
    all[5].title += ", wide open";
    all[5].camera.lens_radius *= 3;
    all[6].title += ", one bounce";
    all[6].bounces = 1;
    all[7].title += ", a large lamp";
    for (scene::Light& light : all[7].lights) light.radius *= 3;
    return all;
}

}
