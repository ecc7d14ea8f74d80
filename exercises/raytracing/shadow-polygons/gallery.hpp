#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/shapes.hpp>
#include <optional>
#include <umbral/record/ask.hpp>

#include "../cast.hpp"
#include "polygons.hpp"

/// A gallery of flat polygons between two mirrors, by a lamp, whose shadows are polygons: ray-cast.
namespace umbral::raytracing {

struct GalleryFace {
    FlatPolygon polygon;
    glm::vec3 color;
    bool checkered = false;
    std::optional<std::size_t> mirror = std::nullopt;
    std::vector<FlatPolygon> shadows = {};
};

/// Faces within a ball, so that rays that pass it are soon done.
struct GalleryThing {
    std::vector<GalleryFace> faces;
    glm::vec3 centre{0};
    float radius = 0;
};

struct Gallery {
    std::vector<GalleryThing> things;
    std::vector<FlatPolygon> mirrors;
    std::vector<MirrorView> views;
    glm::vec3 lamp;
};

inline GalleryThing thing_of(std::vector<GalleryFace> faces)
{
    GalleryThing thing{std::move(faces)};
    float count = 0;
    for (const GalleryFace& face : thing.faces)
        for (const glm::vec3& corner : face.polygon) thing.centre += corner, count += 1;
    thing.centre /= count;
    for (const GalleryFace& face : thing.faces)
        for (const glm::vec3& corner : face.polygon)
            thing.radius = std::max(thing.radius, 1.001F * distance(corner, thing.centre));
    return thing;
}

inline GalleryThing solid(const shapes::Shape& shape, const glm::mat4& model, const glm::vec3& color)
{
    std::vector<GalleryFace> faces;
    const auto at = [&](std::size_t i) { return glm::vec3(model * glm::vec4(shape.positions[shape.indices[i]], 1)); };
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        // At poles triangles are lines.
        if (length(cross(at(i + 1) - at(i), at(i + 2) - at(i))) > 1e-4F)
            faces.push_back({{at(i), at(i + 1), at(i + 2)}, color});
    }
    return thing_of(std::move(faces));
}

inline GalleryThing block(const glm::vec3& corner, const glm::vec3& size, const glm::vec3& color)
{
    const glm::vec3 x(size.x, 0, 0);
    const glm::vec3 y(0, size.y, 0);
    const glm::vec3 z(0, 0, size.z);
    const std::vector<FlatPolygon> sides = {rectangle(corner + z, x, y), rectangle(corner, y, x),
                                            rectangle(corner, z, y),     rectangle(corner + x, y, z),
                                            rectangle(corner + y, z, x), rectangle(corner, x, z)};
    std::vector<GalleryFace> faces;
    for (const FlatPolygon& side : sides) faces.push_back({side, color});
    return thing_of(std::move(faces));
}

inline glm::vec3 normal_of(const FlatPolygon& polygon)
{
    return normalize(cross(polygon[1] - polygon[0], polygon[2] - polygon[0]));
}

/// Whether a point of the plane lies in a polygon that turns about `normal`; how far from the nearest side, at least.
inline bool lies_in(const FlatPolygon& polygon, const glm::vec3& normal, const glm::vec3& p, float inset = 0)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec3& a = polygon[i];
        const glm::vec3 side = polygon[i + 1 < polygon.size() ? i + 1 : 0] - a;
        if (dot(cross(side, p - a), normal) < inset * length(side)) return false;
    }
    return polygon.size() >= 3;
}

struct GalleryHit {
    const GalleryFace* face = nullptr;
    glm::vec3 normal{0};
    float t = 1e30F;
};

inline GalleryHit first_hit(const Gallery& gallery, const glm::vec3& from, const glm::vec3& direction, float t_min)
{
    GalleryHit hit;
    for (const GalleryThing& thing : gallery.things) {
        const glm::vec3 off = thing.centre - from;
        const float along = dot(off, direction) / dot(direction, direction);
        const glm::vec3 beside = off - along * direction;
        if (dot(beside, beside) > thing.radius * thing.radius) continue;
        for (const GalleryFace& face : thing.faces) {
            const glm::vec3 normal = normal_of(face.polygon);
            const float speed = dot(normal, direction);
            if (speed >= 0) continue;
            const float t = dot(normal, face.polygon[0] - from) / speed;
            if (t <= t_min || t >= hit.t || !lies_in(face.polygon, normal, from + t * direction)) continue;
            hit = {&face, normal, t};
        }
    }
    return hit;
}

/// The light that a face sends from a point of it; a matt one.
inline glm::vec3 light_from(const Gallery& gallery, const GalleryHit& hit, const glm::vec3& p)
{
    glm::vec3 color = hit.face->color;
    if (hit.face->checkered && (static_cast<int>(std::floor(p.x * 1.5F) + std::floor(p.z * 1.5F)) & 1) != 0)
        color *= glm::vec3(0.30F, 0.24F, 0.22F);
    const glm::vec3 to_lamp = gallery.lamp - p;
    const float away = length(to_lamp);
    float cosine = std::max(0.0F, dot(hit.normal, to_lamp) / away);
    for (const FlatPolygon& shadow : hit.face->shadows)
        if (cosine > 0 && lies_in(shadow, hit.normal, p)) cosine = 0;
    const glm::vec3 sky =
        mix(glm::vec3(0.10F, 0.08F, 0.07F), glm::vec3(0.12F, 0.16F, 0.25F), 0.5F + 0.5F * hit.normal.y);
    return color * (sky + cosine * 14.0F / (3 + away * away) * glm::vec3(1.25F, 1.0F, 0.72F));
}

/// The view into mirror `next` that goes on from another one, or from the eye, at a point of the mirror.
inline const MirrorView* view_after(const Gallery& gallery, const MirrorView* last, std::size_t next,
                                    const glm::vec3& normal, const glm::vec3& p)
{
    for (const MirrorView& view : gallery.views) {
        const std::size_t before = last == nullptr ? 0 : last->path.size();
        if (view.path.size() != before + 1 || view.path.back() != next) continue;
        if (last != nullptr && !std::equal(last->path.begin(), last->path.end(), view.path.begin())) continue;
        if (lies_in(view.window, normal, p)) return &view;
    }
    return nullptr;
}

/// What is seen along a ray: in a mirror, what its view's eye sees behind the mirror's plane.
inline glm::vec3 light_along(const Gallery& gallery, glm::vec3 from, glm::vec3 direction)
{
    const MirrorView* view = nullptr;
    glm::vec3 silver(1);
    float t_min = 0;
    for (int bounce = 0; bounce < 12; ++bounce) {
        const GalleryHit hit = first_hit(gallery, from, direction, t_min);
        if (hit.face == nullptr) return silver * glm::vec3(0.012F, 0.016F, 0.03F);
        const glm::vec3 p = from + hit.t * direction;
        if (!hit.face->mirror) return silver * light_from(gallery, hit, p);
        if (!lies_in(hit.face->polygon, hit.normal, p, 0.07F))
            return silver * light_from(gallery, {hit.face, hit.normal, hit.t}, p);
        view = view_after(gallery, view, *hit.face->mirror, hit.normal, p);
        silver *= glm::vec3(0.86F, 0.90F, 0.89F);
        if (view == nullptr) return silver * glm::vec3(0.10F, 0.13F, 0.16F);
        from = view->eye;
        direction = p - from;
        t_min = 1.0001F;
    }
    return glm::vec3(0);
}

/// Floor and walls, two mirrors that face each other, and solids of triangles.
inline Gallery gallery_without_light()
{
    Gallery gallery;
    gallery.lamp = {0.5F, 3.7F, 0.9F};
    gallery.mirrors = {rectangle({-2.5F, 0.25F, -2.75F}, {5.0F, 0, -0.2F}, {0, 2.75F, 0}),
                       rectangle({3.2F, 0.1F, 5.0F}, {-6.4F, 0, 0.45F}, {0, 3.2F, 0})};
    for (std::size_t i = 0; i < gallery.mirrors.size(); ++i)
        gallery.things.push_back(thing_of({{gallery.mirrors[i], {0.85F, 0.55F, 0.18F}, false, i}}));
    gallery.things.push_back(
        thing_of({{rectangle({-4, 0, 6}, {8, 0, 0}, {0, 0, -9.6F}), {0.80F, 0.74F, 0.66F}, true}}));
    gallery.things.push_back(thing_of({{rectangle({-4, 0, -3.6F}, {8, 0, 0}, {0, 5, 0}), {0.40F, 0.44F, 0.55F}}}));
    gallery.things.push_back(thing_of({{rectangle({-4, 0, 6}, {0, 0, -9.6F}, {0, 5, 0}), {0.50F, 0.33F, 0.27F}}}));
    gallery.things.push_back(thing_of({{rectangle({4, 0, -3.6F}, {0, 0, 9.6F}, {0, 5, 0}), {0.27F, 0.42F, 0.40F}}}));
    const auto place = [](const glm::vec3& at, float size, float turn) {
        return glm::rotate(glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(size)), turn,
                           normalize(glm::vec3(0.4F, 1, 0.2F)));
    };
    gallery.things.push_back(block({-0.45F, 0, -1.55F}, {0.9F, 0.7F, 0.9F}, {0.75F, 0.72F, 0.68F}));
    gallery.things.push_back(solid(shapes::icosphere(0), place({0, 1.45F, -1.1F}, 0.62F, 0.4F), {0.90F, 0.45F, 0.10F}));
    gallery.things.push_back(
        solid(shapes::sphere(4, 2), place({-1.35F, 0.75F, 0.2F}, 0.55F, 0.7F), {0.12F, 0.42F, 0.55F}));
    gallery.things.push_back(
        solid(shapes::sphere(3, 2), place({1.45F, 0.62F, -0.35F}, 0.5F, 1.4F), {0.62F, 0.12F, 0.16F}));
    gallery.things.push_back(block({0.75F, 0, 0.75F}, {0.4F, 0.4F, 0.4F}, {0.30F, 0.52F, 0.28F}));
    return gallery;
}

/// The picture: shadows and mirrors as the unit has them.
inline Image gallery_picture(Variation& vary, Recorder& out, int width, int height)
{
    Gallery gallery = gallery_without_light();
    gallery.lamp = vary.near(gallery.lamp, 0.6F);
    const glm::vec3 eye = vary.near(glm::vec3(1.35F, 2.15F, 4.6F), 0.3F);
    for (GalleryThing& thing : gallery.things)
        for (GalleryFace& face : thing.faces)
            for (const GalleryThing& other : gallery.things)
                for (const GalleryFace& caster : other.faces) {
                    if (&caster == &face || &other == &thing) continue;
                    FlatPolygon shadow =
                        ask<shadow_polygon>(out, glm::vec4(gallery.lamp, 1), caster.polygon, face.polygon);
                    if (shadow.size() >= 3 && shadow.size() < 20) face.shadows.push_back(std::move(shadow));
                }
    gallery.views = ask<mirror_views>(out, eye, gallery.mirrors, 6);
    gallery.views.resize(std::min<std::size_t>(gallery.views.size(), 60));
    return ray_traced(width, height, {eye, {-0.25F, 1.2F, -1.6F}, 0.44F},
                      [&](const Ray& ray) { return light_along(gallery, ray.origin, ray.direction); });
}

}
