#include "render/effects.hpp"

namespace umbral::render {
namespace {

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

/// The first instance that can be seen and for which `asks` holds, and how many more there are.
template <class Asks>
std::string instances(const DrawList& list, const Asks& asks)
{
    const Draw* first = nullptr;
    std::size_t more = 0;
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside || !asks(draw)) continue;
        if (first == nullptr)
            first = &draw;
        else
            ++more;
    }
    if (first == nullptr) return {};
    return "instance " + quoted(first->name) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

std::string with_material(const std::string& who, const char* what) { return who.empty() ? who : who + what; }

}

Derived derive_effects(const DrawList& list, const scene::Scene& scene)
{
    const std::string any = instances(list, [](const Draw&) { return true; });
    std::array<std::string, effect_flags.size()> asked;
    asked[0] =
        with_material(instances(list, [](const Draw& draw) { return draw.texture.has_value(); }), " has a texture");
    if (!list.lights.empty())
        asked[1] =
            with_material(instances(list, [](const Draw& draw) { return draw.specular; }), " has a specular colour");
    asked[2] = with_material(instances(list, [](const Draw& draw) { return draw.smooth; }), " has smooth shading");
    for (const scene::Light& light : scene.lights)
        if (light.positional && !any.empty() && asked[3].empty())
            asked[3] = "light " + quoted(light.name) + " has a position";
    asked[4] = with_material(instances(list, [](const Draw& draw) { return draw.both_sides; }), " shows both sides");
    asked[5] = with_material(instances(list, [](const Draw& draw) { return draw.visibility == Visibility::crosses; }),
                             " may reach beyond the near plane, the far plane or the guard band");

    const std::array<const char*, effect_flags.size()> absent = {
        "nothing that can be seen has a texture",
        list.lights.empty() ? "there is no light" : "nothing that can be seen has a specular colour",
        "everything that can be seen is flat",
        "every light is far away",
        "nothing shows its back",
        "everything lies well inside the view volume",
    };
    Derived derived;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        derived.set.*effect_flags[i] = !asked[i].empty();
        derived.why[i] = asked[i].empty() ? (any.empty() ? "nothing can be seen" : absent[i]) : asked[i];
    }
    return derived;
}

}
