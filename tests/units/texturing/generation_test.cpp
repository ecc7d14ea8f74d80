#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <texturing/generation/measure.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>

// Linked with the reference; what is expected is worked out by hand, or in double with the formula of the
// specification.

using namespace umbral;
using namespace umbral::texturing;

namespace {

constexpr std::array all_generations = {Generation::off, Generation::object, Generation::eye};

class GenerationTest : public testing::Test {
protected:
    GenerationTest()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        target_.emplace(8, 8);
        fixed_.emplace();
    }

    [[nodiscard]] glm::vec2 fixed(const Vertex& vertex) const { return fixed_->read(vertex); }

private:
    std::optional<gl::OffscreenContext> context_;
    std::optional<gl::Framebuffer> target_;
    std::optional<FixedProbe> fixed_;
};

glm::dvec2 expected_of(const Vertex& vertex, const Generator& generator)
{
    if (generator.generation == Generation::off) return vertex.tex_coord;
    glm::dvec4 place(vertex.position);
    if (generator.generation == Generation::eye) place = glm::dmat4(vertex.modelview) * place;
    return {dot(glm::dvec4(generator.s_plane), place), dot(glm::dvec4(generator.t_plane), place)};
}

}

TEST(PlaneAlong, is_zero_at_the_origin_and_grows_along_the_axis)
{
    EXPECT_EQ(plane_along({2, 5, -1}, {0, 0, 4}), glm::vec4(0, 0, 4, 4));
    EXPECT_EQ(plane_along({0, 0, 0}, {1, 0, 0}), glm::vec4(1, 0, 0, 0));
    constexpr std::uint64_t seed = 51103;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 origin = 4.0F * random.in_cube();
        const glm::vec3 axis = random.uniform(0, 3) * random.unit_vector();
        const glm::vec4 plane = plane_along(origin, axis);
        EXPECT_NEAR(dot(plane, glm::vec4(origin, 1)), 0, 1e-5);
        EXPECT_NEAR(dot(plane, glm::vec4(origin + axis, 1)), dot(axis, axis), 3e-5);
    }
}

TEST_F(GenerationTest, both_pipelines_give_what_the_formula_says)
{
    constexpr std::uint64_t seed = 51104;
    SCOPED_TRACE(seed);
    Random random(seed);
    const ShaderProbe probe(generator_vertex_shader());
    double worst_fixed = 0;
    double worst_shader = 0;
    for (int i = 0; i < 600; ++i) {
        const Generator generator = random_generator(random, all_generations[random.below(3)]);
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(random_modelview(random)));
        glUseProgram(0);
        set_generator(generator);
        const Vertex vertex = random_vertex(random);
        const glm::dvec2 expected = expected_of(vertex, generator);
        worst_fixed = std::max(worst_fixed, length(glm::dvec2(fixed(vertex)) - expected));
        const glm::vec4 seen = probe.read(vertex, generator, {0.25F, 0.5F});
        worst_shader = std::max(worst_shader, length(glm::dvec2(seen) - expected));
        ASSERT_LT(length(glm::vec2(seen.z, seen.w) - glm::vec2(0.25F, 0.5F)), 1e-6F);
    }
    std::cout << "largest errors: " << worst_fixed << " fixed, " << worst_shader << " shader\n";
    EXPECT_LT(worst_fixed, 2e-5);
    EXPECT_LT(worst_shader, 2e-5);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(GenerationTest, eye_planes_hold_whatever_the_matrix_was)
{
    Vertex vertex;
    vertex.position = {1, 2, 3, 1};
    vertex.modelview = glm::translate(glm::mat4(1), glm::vec3(10, 20, 30));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(value_ptr(glm::scale(glm::mat4(1), glm::vec3(4, 5, 6))));
    set_generator({Generation::eye, {1, 0, 0, 0}, {0, 0, 1, 0.5F}});
    EXPECT_EQ(fixed(vertex), glm::vec2(11, 33.5F));
    set_generator({Generation::object, {1, 0, 0, 0}, {0, 0, 1, 0.5F}});
    EXPECT_EQ(fixed(vertex), glm::vec2(1, 3.5F));
    vertex.tex_coord = {0.25F, 0.75F};
    set_generator({});
    EXPECT_EQ(fixed(vertex), glm::vec2(0.25F, 0.75F));
}

TEST_F(GenerationTest, matrices_and_their_mode_stay_as_they_were)
{
    for (const Generation generation : all_generations)
        for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
            const glm::mat4 modelview = glm::rotate(glm::mat4(1), 0.3F, glm::vec3(0, 1, 0));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(modelview));
            glMatrixMode(mode);
            set_generator({generation});
            GLint found = 0;
            glGetIntegerv(GL_MATRIX_MODE, &found);
            EXPECT_EQ(static_cast<GLenum>(found), mode);
            GLint depth = 0;
            glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
            EXPECT_EQ(depth, 1);
            glm::mat4 kept(0);
            glGetFloatv(GL_MODELVIEW_MATRIX, value_ptr(kept));
            EXPECT_EQ(kept, modelview);
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_GEN_S), generation == Generation::off ? GL_FALSE : GL_TRUE);
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_GEN_T), glIsEnabled(GL_TEXTURE_GEN_S));
        }
}
