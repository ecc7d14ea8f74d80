#include <gtest/gtest.h>

#include <interaction/pick-ids/scenes.hpp>
#include <interaction/pick-ids/state.hpp>
#include <optional>
#include <umbral/gl/context.hpp>
#include <umbral/gl/trace.hpp>

// Linked with the reference; what is expected was worked out by hand, or by rays through the pixels' centres.

using namespace umbral;
using namespace umbral::interaction;

namespace {

class PickIds : public testing::Test {
protected:
    PickIds()
    {
        gl::forbid_driver_threads();
        context_.emplace();
    }

private:
    std::optional<gl::OffscreenContext> context_;
};

/// The depth of the nearest point of a triangle in clip coordinates that appears at `place` (in [0, 1], y down), or 2.
double depth_at(const std::array<glm::dvec4, 3>& corners, const glm::dvec2& place)
{
    const glm::dvec2 ndc(2 * place.x - 1, 1 - 2 * place.y);
    glm::dmat3 system;
    for (int i = 0; i < 3; ++i)
        system[i] = {corners[i].x - ndc.x * corners[i].w, corners[i].y - ndc.y * corners[i].w, corners[i].w};
    if (determinant(system) == 0) return 2;
    // Weights with which x = ndc.x w, y = ndc.y w, w = 1.
    const glm::dvec3 weights = inverse(system) * glm::dvec3(0, 0, 1);
    if (weights.x < 0 || weights.y < 0 || weights.z < 0) return 2;
    return weights.x * corners[0].z + weights.y * corners[1].z + weights.z * corners[2].z;
}

std::uint32_t id_by_rays(const PickScene& scene, const glm::ivec2& picture, const glm::ivec2& pixel)
{
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.x || pixel.y >= picture.y) return 0;
    const glm::dvec2 place = (glm::dvec2(pixel) + 0.5) / glm::dvec2(picture);
    double nearest = 1;
    std::uint32_t id = 0;
    for (const PickThing& thing : scene.things) {
        if (thing.id == 0) continue;
        const PickMesh& mesh = scene.meshes[thing.mesh];
        const glm::dmat4 all = glm::dmat4(scene.projection) * glm::dmat4(scene.view) * glm::dmat4(thing.model);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            std::array<glm::dvec4, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) corners[k] = all * glm::dvec4(mesh.positions[mesh.indices[i + k]], 1);
            const double depth = depth_at(corners, place);
            if (depth >= nearest) continue;
            nearest = depth;
            id = thing.id;
        }
    }
    return id;
}

}

TEST(PickIdsColors, known_answers)
{
    EXPECT_EQ(color_of_id(123456), glm::u8vec3(64, 226, 1));
    EXPECT_EQ(color_of_id(0), glm::u8vec3(0, 0, 0));
    EXPECT_EQ(id_of_color({1, 2, 3}), 0x030201U);
    EXPECT_THROW((void)color_of_id(1U << 24U), std::invalid_argument);
    for (std::uint32_t id = 0; id < 1U << 24U; id += 77) ASSERT_EQ(id_of_color(color_of_id(id)), id);
}

TEST(PickIdsNearest, known_answers)
{
    Grid<std::uint32_t> ids(3, 3);
    EXPECT_EQ(nearest_id(ids), 0U);
    ids.cells = {0, 0, 7, 9, 0, 5, 0, 0, 0};
    EXPECT_EQ(nearest_id(ids), 9U);
    ids.at(1, 1) = 4;
    EXPECT_EQ(nearest_id(ids), 4U);
    EXPECT_EQ(nearest_id(Grid<std::uint32_t>(1, 1, 3)), 3U);
}

TEST_F(PickIds, squares_by_hand)
{
    const PickScene scene = squares_by_hand();
    const std::unique_ptr<IdPicker> picker = make_id_picker();
    const auto id_at = [&](int x, int y) { return picker->ids_around(scene, {8, 4}, {x, y}, 0).at(0, 0); };
    EXPECT_EQ(id_at(0, 0), 0x0000FFU);
    EXPECT_EQ(id_at(3, 1), 0x0000FFU) << "before the one that is drawn later";
    EXPECT_EQ(id_at(4, 1), 0x00FF00U);
    EXPECT_EQ(id_at(7, 3), 0x010203U);
    EXPECT_EQ(id_at(3, 3), 0xFFFFFFU);
    EXPECT_EQ(id_at(0, 3), 0U) << "behind the far plane";
    EXPECT_EQ(id_at(8, 3), 0U) << "outside";
}

TEST_F(PickIds, agrees_with_rays_through_pixels)
{
    constexpr std::uint64_t seed = 44001;
    Random random(seed);
    int seen = 0;
    for (int i = 0; i < 6; ++i) {
        const RandomScene made = random_scene(random);
        const EdgesInPicture edges(made.scene, made.picture);
        const std::unique_ptr<IdPicker> picker = make_id_picker();
        const int radius = made.picture.x / 2 + 2;
        const Grid<std::uint32_t> ids = picker->ids_around(made.scene, made.picture, made.picture / 2, radius);
        for (int y = 0; y < ids.height; ++y)
            for (int x = 0; x < ids.width; ++x) {
                const glm::ivec2 pixel = made.picture / 2 - radius + glm::ivec2(x, y);
                if (edges.distance(pixel) < 0.02) continue;
                ASSERT_EQ(ids.at(x, y), id_by_rays(made.scene, made.picture, pixel))
                    << "seed " << seed << ", scene " << i << ", pixel " << pixel.x << ' ' << pixel.y;
                seen += ids.at(x, y) != 0 ? 1 : 0;
            }
    }
    EXPECT_GT(seen, 1000);
}

TEST_F(PickIds, leaves_all_state_as_it_was_whatever_it_was)
{
    constexpr std::uint64_t seed = 44002;
    Random random(seed);
    const OthersWork others;
    const std::unique_ptr<IdPicker> picker = make_id_picker();
    for (int i = 0; i < 50; ++i) {
        const RandomScene made = random_scene(random);
        others.disturb(random);
        const std::vector<float> before = state_row();
        const Grid<std::uint32_t> ids = picker->ids_around(made.scene, made.picture, made.picture / 2, 3);
        ASSERT_EQ(state_row(), before) << "seed " << seed << ", round " << i;
        ASSERT_EQ(others.changed_pixels(), 0) << "seed " << seed << ", round " << i;
        glUseProgram(0);
        const std::unique_ptr<IdPicker> calm = make_id_picker();
        ASSERT_EQ(calm->ids_around(made.scene, made.picture, made.picture / 2, 3).cells, ids.cells) << "seed " << seed;
    }
}

TEST_F(PickIds, makes_objects_once_and_deletes_them)
{
    const PickScene scene = squares_by_hand();
    glUseProgram(0);
    const int before = living_objects();
    std::unique_ptr<IdPicker> picker = make_id_picker();
    EXPECT_EQ(living_objects(), before);
    (void)picker->ids_around(scene, {8, 4}, {1, 1}, 0);
    const int with = living_objects();
    EXPECT_GT(with, before);
    gl::begin_trace();
    (void)picker->ids_around(scene, {8, 4}, {2, 2}, 1);
    EXPECT_EQ(gl::end_trace().count("glGenFramebuffers"), 0U);
    (void)picker->ids_around(scene, {9, 5}, {2, 2}, 1);
    EXPECT_EQ(living_objects(), with);
    picker.reset();
    EXPECT_EQ(living_objects(), before);
}
