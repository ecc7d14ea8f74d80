#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <texturing/upload/probe.hpp>
#include <texturing/upload/state.hpp>
#include <umbral/core/random.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/trace.hpp>

// Linked with the reference; what is expected was worked out by hand, or by a loop over the picture's own bytes.

using namespace umbral;
using namespace umbral::texturing;

namespace {

class Upload : public testing::Test {
protected:
    Upload()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        probe_.emplace();
    }

    [[nodiscard]] std::vector<glm::vec4> read(int unit, const Window& window) const
    {
        return probe_->read(unit, window);
    }

private:
    std::optional<gl::OffscreenContext> context_;
    std::optional<Probe> probe_;
};

/// The mean of the texels of one cell of a picture that is divided into columns x rows.
glm::vec3 mean(const Grid<glm::u8vec3>& picture, int columns, int rows, int column, int row)
{
    const int width = picture.width / columns;
    const int height = picture.height / rows;
    glm::dvec3 sum(0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sum += glm::dvec3(picture.at(column * width + x, row * height + y));
    return glm::vec3(sum / static_cast<double>(width * height));
}

}

TEST_F(Upload, a_texel_is_where_the_picture_has_it)
{
    Grid<glm::u8vec3> picture(3, 2);
    picture.cells = {{10, 11, 12}, {20, 21, 22}, {30, 31, 32}, {40, 41, 42}, {50, 51, 52}, {60, 61, 62}};
    const auto texture = make_texture(picture, {}, false);
    picture.cells.assign(6, glm::u8vec3(0));
    texture->activate(3);
    const std::vector<glm::vec4> cells = read(3, {{0, 0}, {1, 1}, 3, 2});
    ASSERT_EQ(cells.size(), 6U);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const float tens = 10.0F * static_cast<float>(i + 1);
        EXPECT_EQ(cells[i], glm::vec4(tens, tens + 1, tens + 2, 255)) << i;
    }
}

TEST_F(Upload, every_width_and_alignment_gives_every_texel)
{
    constexpr std::uint64_t seed = 41207;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
        const int width = 1 + static_cast<int>(random.below(40));
        const int height = 1 + static_cast<int>(random.below(40));
        const Grid<glm::u8vec3> picture = random_picture(random, width, height);
        const int alignment = 1 << random.below(4);
        glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
        const auto texture = make_texture(picture, {}, false);
        texture->activate(i % units);
        EXPECT_EQ(integer(GL_UNPACK_ALIGNMENT), alignment);
        const std::vector<glm::vec4> cells = read(i % units, {{0, 0}, {1, 1}, width, height});
        for (std::size_t texel = 0; texel < cells.size(); ++texel)
            ASSERT_EQ(cells[texel], glm::vec4(picture.cells[texel], 255)) << width << " x " << height << ": " << texel;
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Upload, wrapping_differs_along_s_and_t)
{
    Grid<glm::u8vec3> picture(2, 1);
    picture.cells = {{255, 0, 0}, {0, 0, 255}};
    const auto texture = make_texture(picture, {Filter::nearest, Wrap::repeat, Wrap::clamp_to_edge}, false);
    texture->activate(0);
    const std::vector<glm::vec4> cells = read(0, {{-1, -3}, {2, 4}, 6, 1});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(cells[i].r, i % 2 == 0 ? 255 : 0) << i;

    const auto clamped = make_texture(picture, {Filter::nearest, Wrap::clamp_to_edge, Wrap::repeat}, false);
    clamped->activate(0);
    const std::vector<glm::vec4> drawn_out = read(0, {{-1, -3}, {2, 4}, 6, 1});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(drawn_out[i].r, i < 3 ? 255 : 0) << i;
}

TEST_F(Upload, half_way_between_two_texels_is_their_mean)
{
    Grid<glm::u8vec3> picture(2, 1);
    picture.cells = {{0, 100, 200}, {100, 50, 0}};
    const auto texture = make_texture(picture, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, false);
    texture->activate(1);
    const glm::vec4 middle = read(1, {{0.25F, 0.25F}, {0.75F, 0.75F}, 1, 1})[0];
    EXPECT_NEAR(middle.r, 50, 1);
    EXPECT_NEAR(middle.g, 75, 1);
    EXPECT_NEAR(middle.b, 100, 1);
}

TEST_F(Upload, mipmaps_give_the_mean_of_what_a_pixel_covers)
{
    constexpr std::uint64_t seed = 41208;
    SCOPED_TRACE(seed);
    Random random(seed);
    const Grid<glm::u8vec3> picture = random_picture(random, 32, 64);
    for (const Filter filter : both_filters) {
        const auto texture = make_texture(picture, {filter, Wrap::repeat, Wrap::repeat}, true);
        texture->activate(0);
        const std::vector<glm::vec4> cells = read(0, {{0, 0}, {1, 1}, 4, 8});
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 4; ++column)
                for (int channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(cells[static_cast<std::size_t>(4 * row + column)][channel],
                                mean(picture, 4, 8, column, row)[channel], 3);
    }
}

TEST_F(Upload, nothing_is_called_before_the_first_activation_and_little_after_it)
{
    gl::begin_trace();
    auto texture = make_texture(Grid<glm::u8vec3>(5, 3, glm::u8vec3(9)), {}, true);
    EXPECT_TRUE(gl::end_trace().calls.empty());
    EXPECT_EQ(living_textures(), 0);

    gl::begin_trace();
    texture->activate(0);
    const gl::Trace first = gl::end_trace();
    EXPECT_EQ(first.uploaded_bytes, 45U);
    EXPECT_EQ(living_textures(), 1);

    gl::begin_trace();
    for (int frame = 0; frame < 10; ++frame) texture->activate(frame);
    const gl::Trace later = gl::end_trace();
    EXPECT_EQ(later.uploaded_bytes, 0U);
    EXPECT_EQ(later.count("glBindTexture"), 10U);
    EXPECT_EQ(later.count("glTexParameteri"), 0U);

    texture.reset();
    EXPECT_EQ(living_textures(), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// The statement's table: the five pictures of the museum.
TEST_F(Upload, the_museum_uploads_each_picture_once)
{
    std::vector<std::unique_ptr<Texture>> textures;
    for (const glm::ivec2 size : {glm::ivec2(150, 150), {66, 66}, {285, 179}, {361, 181}, {1, 1}})
        textures.push_back(make_texture(Grid<glm::u8vec3>(size.x, size.y), {}, true));
    gl::begin_trace();
    for (int frame = 0; frame < 100; ++frame)
        for (std::size_t i = 0; i < textures.size(); ++i) textures[i]->activate(static_cast<int>(i));
    EXPECT_EQ(gl::end_trace().uploaded_bytes, 429639U);
    EXPECT_EQ(living_textures(), 5);
}

TEST_F(Upload, other_units_and_the_active_one_stay_as_they_were)
{
    const Decoys decoys;
    glActiveTexture(GL_TEXTURE7);
    const auto texture = make_texture(Grid<glm::u8vec3>(2, 2, glm::u8vec3(9)), {}, false);
    const auto other = make_texture(Grid<glm::u8vec3>(2, 2, glm::u8vec3(8)), {}, false);
    texture->activate(4);
    other->activate(11);
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE7);
    const std::vector<float> bound = decoys.bound();
    for (std::size_t unit = 0; unit < bound.size(); ++unit)
        EXPECT_EQ(bound[unit], unit == 4 || unit == 11 ? 2 : 1) << unit;
    EXPECT_EQ(read(4, {})[0].r, 9);
    EXPECT_EQ(read(11, {})[0].r, 8);
}

TEST(UploadWithoutContext, a_texture_that_is_never_activated_needs_no_context)
{
    EXPECT_NO_THROW(make_texture(Grid<glm::u8vec3>(2, 2), {}, true).reset());
}
