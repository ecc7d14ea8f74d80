#include <kit/canonical.hpp>
#include <kit/magnitude.hpp>
#include <kit/refusal.hpp>
#include <kit/row_of.hpp>
#include <kit/varied.hpp>
#include <umbral/meshes/revolution.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "profiles.hpp"
#include "stage.hpp"

namespace umbral {
namespace {

using namespace meshes;

constexpr const char* names_of_triangles =
    "-1 how many: vertices, triangles, normals and coordinates together\n1 triangle\n";

/// Vertices that matter, by their numbers.
using Places = std::vector<std::size_t>;

Places all_places(const Profile& profile, std::uint32_t copies)
{
    Places places(profile.size() * copies);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    return places;
}

void record_vertices(Recorder& out, const TexturedMesh& surface, const Places& places)
{
    out.columns("coordinates", "s, t");
    for (const std::size_t i : places) {
        out.append("positions", row_of(surface.mesh.positions, i));
        out.append("normals", row_of(surface.normals, i));
        out.append("coordinates", row_of(surface.texture_coordinates, i));
    }
}

Profile times(Profile profile, float factor)
{
    for (glm::vec2& point : profile) point *= factor;
    return profile;
}

/// Everything: also how many, and the triangles in any order and begun anywhere. The profile is turned in a unit that
/// is a power of two, and places are recorded without it.
void record_whole(Recorder& out, const Profile& profile, std::uint32_t copies, float unit = 1)
{
    TexturedMesh surface = ask<revolve>(out, times(profile, unit), copies);
    for (glm::vec3& position : surface.mesh.positions) position /= unit;
    record_vertices(out, surface, all_places(profile, copies));
    const auto size = [](const auto& list) { return static_cast<float>(list.size()); };
    out.append("triangles", std::vector<float>{-1, size(surface.mesh.positions), size(surface.mesh.triangles),
                                               size(surface.normals) + size(surface.texture_coordinates)});
    record_indices(out, "triangles", 1, surface.mesh.triangles, 2 * profile.size() * copies);
}

/// A profile that is written down; varied, with a point more on its first side, turned in more copies, in another unit.
void record_written(Case& c, Recorder& out, Profile profile, std::uint32_t copies, float unit = 1)
{
    if (c.vary) profile.insert(profile.begin() + 1, 0.5F * (profile[0] + profile[1]));
    const std::array more{copies + 1, copies + 2, copies + 3};
    record_whole(out, profile, c.vary.one_of(copies, more), unit * other_unit(c.vary, 8));
}

/// The first and the last copy, which must lie in the same place to the last bit.
void record_seam(Recorder& out, const Profile& profile, std::uint32_t copies)
{
    const TexturedMesh surface = ask<revolve>(out, profile, copies);
    Places places;
    for (std::size_t j = 0; j < profile.size(); ++j)
        places.insert(places.end(), {j, profile.size() * (copies - 1) + j});
    record_vertices(out, surface, places);
}

/// Of a surface of very many vertices, the triangles that have one of the last twenty.
void record_last_triangles(Recorder& out, const TexturedMesh& surface, std::size_t vertices)
{
    std::vector<glm::uvec3> triangles = surface.mesh.triangles;
    std::erase_if(triangles, [&](const glm::uvec3& t) { return std::max({t.x, t.y, t.z}) + 20 < vertices; });
    record_indices(out, "triangles", 1, triangles, 40);
}

void record_many(Random& random, Recorder& out)
{
    // Very many copies, of which some are looked at: where errors that add up are largest, and at the quarters of the
    // turn.
    for (const std::uint32_t copies : {1001U, 10'001U, 65'537U}) {
        const TexturedMesh surface = ask<revolve>(out, Profile{{1, 0}, {3.9F, 1}}, copies);
        Places places;
        for (std::uint32_t k = 0; k < 200; ++k)
            places.push_back(2 * std::size_t{copies - 1} * k / 200 + random.below(2 * (copies / 256)));
        for (const std::uint32_t quarter : {1U, 2U, 3U, 4U})
            places.push_back(2 * std::size_t{copies - 1} * quarter / 4 + 1);
        record_vertices(out, surface, places);
        record_last_triangles(out, surface, 2 * std::size_t{copies});
    }
    // Long profiles: tiny, as usual, and huge.
    for (const auto& [points, exponent] : {std::pair{1000U, -80}, {10'000U, 0}, {50'000U, 80}}) {
        const Profile profile = long_profile(points, random);
        const float unit = std::exp2(static_cast<float>(exponent + static_cast<int>(random.below(11))));
        TexturedMesh surface = ask<revolve>(out, times(profile, unit), 4);
        for (glm::vec3& position : surface.mesh.positions) position /= unit;
        Places places;
        for (std::uint32_t k = 0; k < 200; ++k) places.push_back(points + std::size_t{points - 1} * k / 199);
        record_vertices(out, surface, places);
        record_last_triangles(out, surface, 4 * std::size_t{points});
    }
}

void record_attempts(Case& what, Recorder& out)
{
    for (const Attempt& attempt : varied(what.random, what.vary, attempts()))
        record_refusal(out, "outcomes", [&] { return ask<revolve>(out, attempt.profile, attempt.copies); });
}

}

const Driver driver = {
    {"known",
     [](Case& c, Recorder& out) {
         record_written(c, out, {{2, 0}, {2, 3}, {1, 3}}, 5);
         record_written(c, out, {{0, -1}, {1, 0}, {0, 1}}, 9);
         record_written(c, out, semicircle(7), 13);
         out.text("triangles.names", names_of_triangles);
     }},
    {"profiles",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 25; ++i) {
             const Profile profile = some_profile(c.random);
             const std::uint32_t copies = 4 + c.random.below(12);
             record_whole(out, profile, copies, random_unit(c.random, -40, 40));
         }
         out.text("triangles.names", names_of_triangles);
     }},
    {"creases and poles",
     [](Case& c, Recorder& out) {
         record_written(c, out, {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}}, 6);
         record_written(c, out, {{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 3}, {1, 2}}, 8);
         record_written(c, out, {{1, 0}, {2, 0}, {1, 0}}, 5);
         record_written(c, out, {{1, 0}, {2, 0}, {2, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1}, {1, 1}}, 5);
         // Folds: sums of 2^-16 and 2^-24, on either side of the shortest that has a direction.
         record_written(c, out, {{1, 0}, {2, 0}, {1, 0x1p-16F}}, 5);
         record_written(c, out, {{1, 0}, {2, 0}, {1, 0x1p-24F}}, 5);
         // Two points whose distance is less than a step of t.
         record_written(c, out, {{2, 0}, {0.25F, 5}, {0.25F + 0x1p-24F, 5}, {2, 9}}, 12);
         record_written(c, out, profiles::pawn(), 7);
         record_written(c, out, {{0, 0}, {1, 0.5F}, {1, 0.5F}, {2, 2}, {0, 3}}, 5, 0x1p-16F);
         out.text("triangles.names", names_of_triangles);
     }},
    {"seam",
     [](Case& c, Recorder& out) {
         for (const std::uint32_t copies : {4U, 5U, 8U, 13U, 50U, 1000U, 4096U})
             record_seam(out, some_profile(c.random), copies);
     }},
    {"many",
     [](Case& c, Recorder& out) {
         record_many(c.random, out);
         out.text("triangles.names", "1 triangle at one of the last twenty vertices\n");
     }},
    {"refused", [](Case& c, Recorder& out) { record_attempts(c, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("surfaces", picture(out, c.vary)); }},
};

}
