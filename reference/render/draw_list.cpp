#include "render/draw_list.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <umbral/projections/view.hpp>
#include <utility>

#include "render/textures.hpp"
#include "render/visibility.hpp"

namespace umbral::render {
namespace {

constexpr std::size_t not_made = std::numeric_limits<std::size_t>::max();

texturing::Sampler sampler_of(const scene::Texture& texture)
{
    const auto wrap = texture.repeat ? texturing::Wrap::repeat : texturing::Wrap::clamp_to_edge;
    return {texture.bilinear ? texturing::Filter::bilinear : texturing::Filter::nearest, wrap, wrap};
}

Light in_eye_space(const scene::Light& light, const glm::mat4& view)
{
    const glm::dvec4 where = glm::dmat4(view) * glm::dvec4(light.where, light.positional ? 1 : 0);
    if (light.positional) return {glm::vec4(where), light.color, light.radius};
    return {glm::vec4(glm::vec3(normalize(glm::dvec3(where))), 0), light.color,
            std::tan(glm::radians(light.half_angle_degrees))};
}

/// The places of a scene's textures in DrawList::textures, each made when it is first asked for.
class TexturePlaces {
public:
    TexturePlaces(const scene::Scene& scene, DrawList& list)
        : scene_(scene), list_(list), places_(scene.textures.size(), not_made)
    {
    }
    std::size_t place(std::size_t texture)
    {
        if (places_[texture] == not_made) {
            places_[texture] = list_.textures.size();
            const scene::Texture& wanted = scene_.textures[texture];
            list_.textures.push_back({make_texture(wanted), sampler_of(wanted)});
        }
        return places_[texture];
    }

private:
    const scene::Scene& scene_;
    DrawList& list_;
    std::vector<std::size_t> places_;
};

}

DrawList make_draw_list(const scene::Scene& scene, int width, int height, bool for_rays)
{
    const glm::mat4 view = projections::view_matrix(scene.camera.eye, scene.camera.target, scene.camera.up);
    DrawList list;
    list.projection = projection_matrix(scene.camera, static_cast<double>(width) / height);
    list.ambient = scene.ambient;
    list.camera = scene.camera;
    if (list.camera.focus_distance == 0) list.camera.focus_distance = distance(scene.camera.eye, scene.camera.target);
    list.up = glm::vec3(view * glm::vec4(0, 1, 0, 0));
    list.background_top = scene.background_top;
    list.background_bottom = scene.background_bottom;
    list.bounces = scene.bounces;
    list.depth = scene.depth;
    for (const scene::Light& light : scene.lights) list.lights.push_back(in_eye_space(light, view));
    TexturePlaces textures(scene, list);

    std::map<std::pair<std::size_t, bool>, std::size_t> meshes;  // by geometry and smoothness
    for (const scene::Instance& instance : scene.instances) {
        const auto [mesh, is_new] = meshes.try_emplace({instance.geometry, instance.smooth}, list.meshes.size());
        if (is_new)
            list.meshes.push_back(
                make_vertices(make_surface(scene.geometries[instance.geometry].shape), instance.smooth));

        Draw draw;
        draw.id = static_cast<std::uint32_t>(list.draws.size() + 1);
        draw.name = instance.name;
        draw.mesh = mesh->second;
        draw.model_view = glm::mat4(glm::dmat4(view) * glm::dmat4(model_matrix(instance.transforms)));
        const glm::dmat3 linear(draw.model_view);
        draw.normal_matrix = glm::mat3(transpose(inverse(linear)));
        draw.mirrored = determinant(linear) < 0;
        draw.smooth = instance.smooth;
        draw.both_sides = instance.sides == scene::Sides::both;
        draw.material = scene.materials[instance.material];
        draw.specular = draw.material.specular != glm::vec3(0);
        draw.visibility =
            visibility(list.meshes[draw.mesh], list.projection * draw.model_view, guard_band(width, height));
        if (draw.material.texture && (for_rays || draw.visibility != Visibility::outside))
            draw.texture = textures.place(*draw.material.texture);
        if (draw.material.bump && for_rays) draw.bump = textures.place(*draw.material.bump);
        list.draws.push_back(std::move(draw));
    }
    return list;
}

}
