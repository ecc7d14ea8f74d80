#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <umbral/raytracing/cylinder_cone.hpp>
#include <vector>

#include "../cast.hpp"
#include "../rays.hpp"

/// The goal picture: a castle on an island at evening, put together of the two surfaces alone.
namespace umbral::raytracing {

enum class Stuff { stone, slate, grass, wood, needles, flag };

/// One of the surfaces, stretched by `size` (radius along x, height, radius along z) and moved to `base`.
struct Piece {
    bool is_cone;
    Stuff stuff;
    glm::vec3 base;
    glm::vec3 size;
};

/// The same ray as the piece's own surface sees it. t stays: origin and direction are stretched alike.
inline Ray as_seen_by(const Piece& piece, const Ray& ray)
{
    return Ray{(ray.origin - piece.base) / piece.size, ray.direction / piece.size, ray.t_min, ray.t_max};
}

inline void add_tower(std::vector<Piece>& pieces, glm::vec3 base, float radius, float height, float roof)
{
    pieces.push_back({false, Stuff::stone, base, {radius, height, radius}});
    const glm::vec3 eaves = base + glm::vec3(0, height, 0);
    const float wide = 1.28F * radius;
    pieces.push_back({false, Stuff::stone, eaves - glm::vec3(0, 0.16F, 0), {1.1F * radius, 0.16F, 1.1F * radius}});
    pieces.push_back({true, Stuff::slate, eaves, {wide, roof, wide}});
    const glm::vec3 top = eaves + glm::vec3(0, 0.97F * roof, 0);
    pieces.push_back({false, Stuff::wood, top, {0.012F, 0.3F, 0.012F}});
    pieces.push_back({true, Stuff::flag, top + glm::vec3(0.075F, 0.19F, 0), {0.075F, 0.11F, 0.004F}});
}

inline void add_fir(std::vector<Piece>& pieces, glm::vec3 base, float height)
{
    pieces.push_back({false, Stuff::wood, base, {0.05F * height, 0.3F * height, 0.05F * height}});
    for (const glm::vec3& tier : {glm::vec3(0.2F, 0.27F, 0.42F), {0.42F, 0.215F, 0.36F}, {0.64F, 0.15F, 0.36F}})
        pieces.push_back({true, Stuff::needles, base + glm::vec3(0, tier.x * height, 0),
                          height * glm::vec3(tier.y, tier.z, tier.y)});
}

/// The height of the island, a flat cone, at this place.
inline float island_height(float x, float z) { return std::max(0.0F, 0.85F * (1 - std::hypot(x / 4.4F, z / 3.2F))); }

inline std::vector<Piece> castle()
{
    std::vector<Piece> pieces = {{true, Stuff::grass, {0, 0, 0}, {4.4F, 0.85F, 3.2F}}};
    add_tower(pieces, {0, 0.5F, -0.2F}, 0.52F, 2.5F, 1.35F);
    add_tower(pieces, {-1.05F, 0.4F, 0.35F}, 0.36F, 1.55F, 0.95F);
    add_tower(pieces, {1.0F, 0.4F, 0.45F}, 0.4F, 1.2F, 0.9F);
    add_tower(pieces, {-0.62F, 0.5F, -0.75F}, 0.27F, 2.35F, 0.95F);
    add_tower(pieces, {0.72F, 0.5F, -0.7F}, 0.25F, 2.0F, 0.85F);
    add_tower(pieces, {-1.85F, 0.25F, -0.3F}, 0.3F, 1.0F, 0.7F);
    add_tower(pieces, {1.85F, 0.25F, -0.15F}, 0.26F, 1.35F, 0.75F);
    add_tower(pieces, {0.05F, 0.35F, 0.95F}, 0.2F, 0.8F, 0.5F);
    pieces.push_back({false, Stuff::stone, {0, 0.3F, 0.1F}, {1.45F, 0.75F, 0.85F}});
    pieces.push_back({false, Stuff::stone, {0, 0.3F, 0}, {0.85F, 1.35F, 0.6F}});
    const glm::vec2 places[] = {{-3.0F, 0.5F},  {-2.55F, 0.95F}, {-3.45F, -0.1F}, {-2.4F, 0.3F},   {2.6F, 0.75F},
                                {3.15F, 0.35F}, {3.55F, -0.3F},  {2.35F, 0.15F},  {-1.75F, 1.45F}, {1.75F, 1.4F},
                                {-2.9F, -0.7F}, {2.8F, -0.75F},  {-0.75F, 1.9F},  {0.95F, 1.75F}};
    for (std::size_t i = 0; i < std::size(places); ++i) {
        const glm::vec2 place = places[i];
        add_fir(pieces, {place.x, island_height(place.x, place.y) - 0.02F, place.y},
                0.55F + 0.11F * static_cast<float>(i * 7 % 5));
    }
    return pieces;
}

/// The nearest piece along a ray of unit direction: its place in the list plus one (0 for none), where it is met, and
/// the place and the outward normal there, as the piece's own surface and as the world have them.
struct PieceHit {
    std::uint32_t id = 0;
    glm::vec3 local{0};
    glm::vec3 point{0};
    glm::vec3 normal{0};
};

/// `meets_cylinder(ray)` and `meets_cone(ray)` are the unit's functions, or the questions what they answer.
template <class MeetsCylinder, class MeetsCone>
PieceHit nearest_piece(MeetsCylinder meets_cylinder, MeetsCone meets_cone, Ray ray, const std::vector<Piece>& pieces)
{
    PieceHit hit;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        // The driver's own test of a ball round the piece, which spares most questions.
        const glm::vec3 middle = piece.base + glm::vec3(0, 0.5F * piece.size.y, 0);
        const glm::vec3 aside = cross(middle - ray.origin, ray.direction);
        const float wide = std::max(piece.size.x, piece.size.z);
        if (dot(aside, aside) > wide * wide + 0.26F * piece.size.y * piece.size.y) continue;
        const Ray local = as_seen_by(piece, ray);
        const std::optional<float> t = piece.is_cone ? meets_cone(local) : meets_cylinder(local);
        if (!t || !(*t < ray.t_max)) continue;
        ray.t_max = *t;
        const glm::vec3 at = local.origin + *t * local.direction;
        const glm::vec3 upright(at.x, piece.is_cone ? 1 - at.y : 0, at.z);
        hit = {static_cast<std::uint32_t>(i + 1), at, ray.origin + *t * ray.direction, normalize(upright / piece.size)};
    }
    return hit;
}

inline PieceHit nearest_piece(const Ray& ray, const std::vector<Piece>& pieces)
{
    return nearest_piece(intersect_unit_cylinder, intersect_unit_cone, ray, pieces);
}

inline const glm::vec3 evening_sun = glm::normalize(glm::vec3(-0.80F, 0.42F, 0.55F));

/// The sky over the lake: from gold at the horizon to blue, with a glow low on the left.
inline glm::vec3 evening_sky(const glm::vec3& direction)
{
    const float height = std::max(0.0F, direction.y);
    const glm::vec3 blue =
        glm::mix(glm::vec3(0.62F, 0.42F, 0.42F), glm::vec3(0.07F, 0.13F, 0.34F), glm::smoothstep(0.02F, 0.62F, height));
    const glm::vec3 gold = glm::mix(glm::vec3(0.95F, 0.52F, 0.25F), blue, glm::smoothstep(0.0F, 0.22F, height));
    const float glow = std::max(0.0F, dot(direction, normalize(glm::vec3(-0.55F, 0.10F, -1))));
    return gold + glm::vec3(0.75F, 0.36F, 0.12F) * std::pow(glow, 18.0F);
}

/// The colour of what a piece is made of, with courses of stone; lit windows send out light of their own.
inline glm::vec3 stuff_color(const Piece& piece, const PieceHit& hit, glm::vec3& emission)
{
    const float round = std::atan2(hit.local.z, hit.local.x) * 0.15915494F;
    const float tall = hit.local.y * piece.size.y;
    switch (piece.stuff) {
        case Stuff::stone: {
            const auto course = static_cast<int>(std::floor(tall / 0.085F));
            const auto row = static_cast<float>(course);
            const float shade = 0.9F + 0.1F * std::sin(12.9F * row + 4 * std::floor(round * 22 + 0.5F * row));
            const float around = glm::fract(round * 8 + 0.3F) - 0.5F;
            const float storey = glm::fract(tall / 0.62F - 0.25F) - 0.5F;
            const bool arched = std::abs(around) < 0.11F && std::abs(storey) < 0.17F - 3.5F * around * around;
            if (arched && tall > 0.3F && piece.size.y > 0.5F) emission = glm::vec3(1.6F, 0.85F, 0.25F);
            return shade * glm::vec3(0.52F, 0.45F, 0.38F);
        }
        case Stuff::slate: {
            const float rows = glm::fract(hit.local.y * 13);
            return (0.8F + 0.2F * rows) * glm::vec3(0.30F, 0.075F, 0.085F);
        }
        case Stuff::grass: return {0.13F, 0.20F, 0.055F};
        case Stuff::wood: return {0.12F, 0.075F, 0.045F};
        case Stuff::needles: return {0.035F, 0.115F, 0.06F};
        default: return {0.9F, 0.62F, 0.08F};
    }
}

/// The light that comes back along a ray: the sun's, the sky's, the windows', and what the lake mirrors.
inline glm::vec3 castle_light(const Ray& ray, const std::vector<Piece>& pieces, int mirrors = 1)
{
    const PieceHit hit = nearest_piece(ray, pieces);
    if (hit.id == 0) {
        if (ray.direction.y >= 0 || mirrors == 0) return evening_sky(ray.direction);
        const glm::vec3 water = ray.origin - ray.origin.y / ray.direction.y * ray.direction;
        const float far = length(water - ray.origin);
        const float wave = 0.02F * std::sin(9 * water.z + 2 * std::sin(1.7F * water.x)) +
                           0.012F * std::sin(23 * water.z - 3 * water.x);
        const glm::vec3 up = normalize(glm::vec3(0.4F * wave, 1, wave * std::min(1.0F, 6 / far)));
        glm::vec3 mirrored = glm::reflect(ray.direction, up);
        mirrored.y = std::abs(mirrored.y);
        const float share = 0.25F + 0.7F * std::pow(1 + ray.direction.y, 4.0F);
        const glm::vec3 deep(0.012F, 0.03F, 0.05F);
        return deep + share * castle_light(Ray{water, mirrored, 1e-3F}, pieces, 0);
    }
    const Piece& piece = pieces[hit.id - 1];
    glm::vec3 emission(0);
    const glm::vec3 color = stuff_color(piece, hit, emission);
    glm::vec3 normal = hit.normal;
    if (dot(normal, ray.direction) > 0) normal = -normal;
    float key = std::max(0.0F, dot(normal, evening_sun));
    if (key > 0 && nearest_piece(Ray{hit.point, evening_sun, 1e-3F}, pieces).id != 0) key = 0;
    const glm::vec3 sky =
        glm::mix(glm::vec3(0.16F, 0.12F, 0.10F), glm::vec3(0.20F, 0.24F, 0.38F), 0.5F + 0.5F * normal.y);
    return emission + color * (1.9F * key * glm::vec3(1.25F, 0.86F, 0.52F) + sky);
}

}
