#include <gtest/gtest.h>

#include <cstring>
#include <string_view>

#include "render/software.hpp"
#include "scenes.hpp"

namespace umbral::render::test {
namespace {

bool includes(const EffectSet& all, const EffectSet& some)
{
    return (number_of(all) & number_of(some)) == number_of(some);
}

template <class Cell>
bool equal_bits(const Grid<Cell>& a, const Grid<Cell>& b)
{
    return a.width == b.width && a.height == b.height &&
           std::memcmp(a.cells.data(), b.cells.data(), a.cells.size() * sizeof(Cell)) == 0;
}

std::vector<scene::Scene> scenes_to_draw()
{
    return {plain(),    first_light(), through_the_near_plane(), around_the_camera(), behind_the_camera(), degenerate(),
            mirrored(), bare()};
}

TEST(Effects, are_numbered_one_to_one)
{
    for (std::size_t number = 0; number < effect_set_count; ++number) EXPECT_EQ(number_of(effect_set(number)), number);
    EXPECT_EQ(number_of(EffectSet{}), 0U);
}

// A kernel without what the scene does not call for draws the same picture, bit by bit, as any with more.
TEST(Effects, absent_ones_change_no_bit_and_count_nothing)
{
    int absent = 0;
    for (const scene::Scene& scene : scenes_to_draw()) {
        const DrawList list = make_draw_list(scene, 96, 64);
        const EffectSet needed = derive_effects(list, scene).set;
        const SoftwarePicture derived = draw_in_software(list, needed, 96, 64);
        int compared = 0;
        for (std::size_t number = 0; number < effect_set_count; ++number) {
            const EffectSet more = effect_set(number);
            if (!includes(more, needed)) continue;
            ++compared;
            const SoftwarePicture picture = draw_in_software(list, more, 96, 64);
            EXPECT_TRUE(equal_bits(derived.frame.color, picture.frame.color)) << number;
            EXPECT_TRUE(equal_bits(derived.frame.depth, picture.frame.depth)) << number;
            EXPECT_TRUE(equal_bits(derived.frame.ids, picture.frame.ids)) << number;
            EXPECT_EQ(derived.counters, picture.counters) << number;
        }
        EXPECT_GE(compared, 1);
        for (const NamedCounter& counter : all_counters)
            for (std::size_t i = 0; i < effect_flags.size(); ++i)
                if (counter.effect != nullptr && counter.effect == std::string_view(effect_names[i]) &&
                    !(needed.*effect_flags[i])) {
                    ++absent;
                    EXPECT_EQ(derived.counters.*counter.value, 0U) << counter.name;
                }
    }
    EXPECT_GT(absent, 10);
}

// Each effect, added to the plain scene alone, is derived alone and counts something; without its flag the picture is
// another one.
TEST(Effects, are_asked_for_one_by_one)
{
    const auto scene_with = [](std::size_t effect) {
        scene::Scene scene = plain();
        switch (effect) {
            case 0:
                scene.textures = {{.name = "squares", .size = 64, .cells = 8}};
                scene.materials[0].texture = 0;
                break;
            case 1: scene.materials[0].specular = glm::vec3(0.5F); break;
            case 2: scene.instances[0].smooth = true; break;
            case 3: scene.lights[0].positional = true; break;
            case 4:
                scene.geometries.push_back({"square", scene::Plane{}});
                scene.instances.push_back(instance("back", 1, {scene::Rotate{{1, 0, 0}, -80}}));
                scene.instances[1].smooth = false;
                scene.instances[1].sides = scene::Sides::both;
                break;
            default: scene.camera.near = 3.5F; break;
        }
        return scene;
    };
    const std::array<std::uint64_t Counters::*, 6> work = {
        &Counters::texture_lookups,  &Counters::specular_evaluations, &Counters::normals_interpolated,
        &Counters::light_directions, &Counters::triangles_turned,     &Counters::triangles_clipped};
    EXPECT_EQ(derive_effects(make_draw_list(plain(), 64, 64), plain()).set, EffectSet{});
    for (std::size_t effect = 0; effect < effect_flags.size(); ++effect) {
        SCOPED_TRACE(effect_names[effect]);
        const scene::Scene scene = scene_with(effect);
        const DrawList list = make_draw_list(scene, 64, 64);
        const Derived derived = derive_effects(list, scene);
        EXPECT_EQ(number_of(derived.set), std::size_t{1} << effect);
        const SoftwarePicture with = draw_in_software(list, derived.set, 64, 64);
        EXPECT_GT(with.counters.*work[effect], 0U);
        EXPECT_FALSE(equal_bits(with.frame.color, draw_in_software(list, EffectSet{}, 64, 64).frame.color));
    }
}

TEST(Effects, name_who_asked)
{
    const scene::Scene scene = first_light();
    const Derived derived = derive_effects(make_draw_list(scene, 64, 64), scene);
    EXPECT_NE(derived.why[0].find("\"ring\""), std::string::npos) << derived.why[0];
    EXPECT_NE(derived.why[3].find("\"lamp\""), std::string::npos) << derived.why[3];
    EXPECT_NE(derived.why[5].find("\"floor\""), std::string::npos) << derived.why[5];
}

TEST(Effects, are_not_asked_for_by_what_cannot_be_seen)
{
    scene::Scene scene = plain();
    scene.lights[0].positional = true;
    scene.instances[0].transforms = {scene::Translate{{0, 0, 40}}};
    scene.instances[0].smooth = true;
    const DrawList list = make_draw_list(scene, 64, 64);
    EXPECT_EQ(derive_effects(list, scene).set, EffectSet{});
    const Counters counters = draw_in_software(list, EffectSet{}, 64, 64).counters;
    EXPECT_EQ(counters.instances_outside, 1U);
    EXPECT_EQ(counters.vertices + counters.triangles + counters.fragments, 0U);
}

// What one counter says must fit the others.
TEST(Counters, add_up)
{
    for (const scene::Scene& scene : scenes_to_draw()) {
        const DrawList list = make_draw_list(scene, 96, 64);
        const SoftwarePicture picture = draw_in_software(list, all_effects, 96, 64);
        const Counters& c = picture.counters;
        EXPECT_EQ(c.fragments, c.depth_rejects + c.fragments_shaded);
        EXPECT_EQ(c.light_evaluations, c.fragments_shaded * list.lights.size());
        EXPECT_LE(c.specular_evaluations, c.light_evaluations);
        EXPECT_LE(c.texture_lookups, c.fragments_shaded);
        EXPECT_EQ(c.instances + c.instances_outside, list.draws.size());
        std::uint64_t covered = 0;
        for (const std::uint32_t id : picture.frame.ids.cells) covered += id != 0 ? 1 : 0;
        EXPECT_LE(covered, c.fragments_shaded);
    }
}

}
}
