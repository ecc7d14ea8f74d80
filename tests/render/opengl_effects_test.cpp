#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>
#include <umbral/gl/context.hpp>
#include <umbral/gl/trace.hpp>

#include "render/renderers.hpp"
#include "scenes.hpp"

// What effects change in both OpenGL renderers: nothing in the picture where the scene does not call for them, and no
// object and no state is made for absent ones.
namespace umbral::render::test {
namespace {

constexpr int side = 48;

template <class Cell>
bool equal_bits(const Grid<Cell>& a, const Grid<Cell>& b)
{
    return a.cells.size() == b.cells.size() &&
           std::memcmp(a.cells.data(), b.cells.data(), a.cells.size() * sizeof(Cell)) == 0;
}

class OpenGlEffects : public testing::TestWithParam<const char*> {
protected:
    OpenGlEffects() : renderer_(renderer_named(GetParam())) {}

    Frame draw(const DrawList& list, const EffectSet& effects)
    {
        return studio_.draw(renderer_, {list, effects, side, side}).frame;
    }

    /// The calls that draw a scene with no more than it calls for.
    gl::Trace trace(const scene::Scene& scene)
    {
        const DrawList list = make_draw_list(scene, side, side);
        const EffectSet effects = derive_effects(list, scene).set;
        (void)draw(list, effects);  // makes the context
        gl::begin_trace();
        (void)draw(list, effects);
        return gl::end_trace();
    }

    [[nodiscard]] bool is_fixed() const { return std::string(GetParam()) == "gl-fixed"; }

    [[nodiscard]] const Renderer& renderer() const { return renderer_; }
    Studio& studio() { return studio_; }

private:
    const Renderer& renderer_;
    Studio studio_;
};

scene::Scene textured()
{
    scene::Scene scene = plain();
    scene.textures = {{.name = "squares", .size = 64, .cells = 8}};
    scene.materials[0].texture = 0;
    return scene;
}

std::uint64_t calls_with(const gl::Trace& trace, std::string_view name, double argument)
{
    std::uint64_t count = 0;
    for (const gl::TracedCall& call : trace.calls)
        if (call.name == name)
            for (const double one : call.arguments) count += one == argument ? 1 : 0;
    return count;
}

// All combinations where nothing is needed; elsewhere each one added alone, and all of them.
TEST_P(OpenGlEffects, absent_ones_change_no_bit)
{
    for (const scene::Scene& scene : {plain(), textured(), mirrored(), through_the_near_plane()}) {
        const DrawList list = make_draw_list(scene, side, side);
        const std::size_t needed = number_of(derive_effects(list, scene).set);
        const Frame derived = draw(list, effect_set(needed));
        for (std::size_t number = 0; number < effect_set_count; ++number) {
            const bool one_more = std::popcount(number ^ needed) == 1 || number + 1 == effect_set_count;
            if ((number & needed) != needed || (needed != 0 && !one_more)) continue;
            const Frame more = draw(list, effect_set(number));
            EXPECT_TRUE(equal_bits(derived.color, more.color)) << needed << " " << number;
            EXPECT_TRUE(equal_bits(derived.depth, more.depth)) << needed << " " << number;
            EXPECT_TRUE(equal_bits(derived.ids, more.ids)) << needed << " " << number;
        }
    }
}

TEST_P(OpenGlEffects, textures_are_made_only_where_they_are_seen)
{
    const gl::Trace without = trace(plain());
    for (const char* name : {"glGenTextures", "glBindTexture", "glTexImage2D", "glTexEnvi", "glTexParameteri"})
        EXPECT_EQ(without.count(name), 0U) << name;
    const gl::Trace with = trace(textured());
    EXPECT_EQ(with.count("glTexImage2D"), 1U);
    EXPECT_EQ(with.count("glDeleteTextures"), 1U);
    EXPECT_EQ(with.uploaded_bytes - without.uploaded_bytes, 64U * 64U * 16U);

    scene::Scene outside = textured();
    outside.instances.push_back(instance("before", 0));
    outside.materials.push_back({.name = "plain"});
    outside.instances[1].material = 1;
    outside.instances[0].transforms = {scene::Translate{{0, 0, 40}}};
    EXPECT_EQ(trace(outside).count("glTexImage2D"), 0U) << "behind the camera";
}

TEST_P(OpenGlEffects, meshes_of_what_is_outside_are_not_sent)
{
    scene::Scene scene = plain();
    const std::uint64_t one = trace(scene).uploaded_bytes;
    scene.geometries.push_back({"floor", scene::Plane{5, 3}});
    scene.instances.push_back(instance("behind", 1, {scene::Translate{{0, 0, 40}}}));
    EXPECT_EQ(trace(scene).uploaded_bytes, one);
}

TEST_P(OpenGlEffects, state_of_absent_ones_is_not_set)
{
    constexpr double two_side = 0x0B52;
    constexpr double local_viewer = 0x0B51;
    constexpr double color_control = 0x81F8;
    const gl::Trace without = trace(plain());
    for (const double state : {two_side, local_viewer, color_control})
        EXPECT_EQ(calls_with(without, "glLightModeli", state), 0U) << state;
    EXPECT_EQ(without.count("glMaterialf"), 0U) << "the exponent of highlights";
    EXPECT_EQ(without.count("glLightfv"), is_fixed() ? 4U : 0U) << "one light";

    const gl::Trace with = trace(through_the_near_plane());
    EXPECT_EQ(calls_with(with, "glLightModeli", two_side), is_fixed() ? 1U : 0U);
    EXPECT_EQ(calls_with(with, "glLightModeli", local_viewer), is_fixed() ? 1U : 0U);
    EXPECT_EQ(with.count("glMaterialf"), is_fixed() ? 2U : 0U) << "two instances";
    EXPECT_EQ(with.count("glLinkProgram"), is_fixed() ? 0U : 1U);
}

TEST_P(OpenGlEffects, are_counted_and_absent_ones_are_zero)
{
    const auto counts = [&](const scene::Scene& scene, const EffectSet& set) {
        const DrawList list = make_draw_list(scene, side, side);
        return studio().draw(renderer(), {list, set, side, side, true});
    };
    for (const scene::Scene& scene : {plain(), textured(), mirrored(), through_the_near_plane()}) {
        const EffectSet needed = derive_effects(make_draw_list(scene, side, side), scene).set;
        const Drawn drawn = counts(scene, needed);
        const Drawn all = counts(scene, all_effects);
        ASSERT_EQ(drawn.counts.size(), all.counts.size());
        for (std::size_t i = 0; i < drawn.counts.size(); ++i) {
            EXPECT_EQ(drawn.counts[i].value, all.counts[i].value) << drawn.counts[i].name;
            for (std::size_t e = 0; e < effect_flags.size(); ++e) {
                if (drawn.counts[i].effect == nullptr || std::string_view(drawn.counts[i].effect) != effect_names[e])
                    continue;
                EXPECT_EQ(drawn.counts[i].value != 0, needed.*effect_flags[e]) << drawn.counts[i].name;
            }
        }
        const auto covered = std::ranges::count_if(drawn.frame.ids.cells, [](std::uint32_t id) { return id != 0; });
        EXPECT_GE(drawn.counts[4].value, static_cast<std::uint64_t>(covered)) << drawn.counts[4].name;
        EXPECT_LE(drawn.counts[4].value, 4U * side * side);
    }
}

INSTANTIATE_TEST_SUITE_P(Renderers, OpenGlEffects, testing::Values("gl", "gl-fixed"),
                         [](const auto& one) { return std::string(one.param) == "gl" ? "shaders" : "fixed"; });

}
}
