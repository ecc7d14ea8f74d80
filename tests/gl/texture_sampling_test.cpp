#include <cstdio>
#include <texturing/support.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

// What Mesa reads from a texture, and what the reference of texturing/lookup does.
namespace umbral::texturing {
namespace {

/// Looks up one place for each pixel, in the order of `places`: a texture of coordinates, read without a filter, says
/// where.
const char* const sampling_fragment =
    "#version 330\nuniform sampler2D places;\nuniform sampler2D image;\nout vec4 result;\n"
    "void main() { result = textureLod(image, texelFetch(places, ivec2(gl_FragCoord.xy), 0).xy, 0.0); }\n";

GLint name_of(Wrap wrap) { return wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; }

/// A texture of floats in OpenGL; `rows` begin at the bottom.
class GlTexture {
public:
    GlTexture(int width, int height, const std::vector<glm::vec4>& rows, const Sampler& sampler)
    {
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT,
                     rows.empty() ? nullptr : rows.data());
        const GLint filter = sampler.filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, name_of(sampler.wrap_u));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, name_of(sampler.wrap_v));
    }
    GlTexture(const GlTexture&) = delete;
    GlTexture& operator=(const GlTexture&) = delete;
    ~GlTexture() { glDeleteTextures(1, &name_); }

    [[nodiscard]] GLuint name() const { return name_; }

private:
    GLuint name_ = 0;
};

constexpr int side = 128;  ///< places a row of one draw

/// The colours at side * side places.
std::vector<glm::vec4> sampled(const Grid<glm::vec4>& texture, const Sampler& sampler,
                               const std::vector<glm::vec2>& places)
{
    std::vector<glm::vec4> upside_down;  // a grid begins at the top, OpenGL at the bottom
    for (int row = texture.height - 1; row >= 0; --row)
        for (int column = 0; column < texture.width; ++column) upside_down.push_back(texture.at(column, row));
    std::vector<glm::vec4> wide;
    for (const glm::vec2& place : places) wide.emplace_back(place, 0, 0);

    const GlTexture where(side, side, wide, {});
    const GlTexture target(side, side, {}, {});
    const GlTexture image(texture.width, texture.height, upside_down, sampler);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.name(), 0);
    glViewport(0, 0, side, side);
    const gl::Program program(gl::vertex_source(gl::plain_vertex), gl::fragment_source(sampling_fragment));
    program.set("places", 0);
    program.set("image", 1);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, where.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, image.name());
    gl::rectangle(-1, 1, -1, 1).draw(program);
    std::vector<glm::vec4> colours(places.size());
    glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, colours.data());
    gl::check_errors("sampling a texture");
    glActiveTexture(GL_TEXTURE0);
    glDeleteFramebuffers(1, &framebuffer);
    return colours;
}

float largest(const glm::vec4& v) { return std::max(std::max(v.x, v.y), std::max(v.z, v.w)); }

class SamplingTest : public gl::GlTest {
protected:
    static constexpr std::uint64_t seed = 20276;
    Random random{seed};

    SamplingTest() { RecordProperty("seed", std::to_string(seed)); }

    /// side * side places within `reach` of the unit square's corner.
    std::vector<glm::vec2> places(float reach)
    {
        std::vector<glm::vec2> all;
        for (int i = 0; i < side * side; ++i) {
            const float u = random.uniform(-reach, reach);
            all.emplace_back(u, random.uniform(-reach, reach));
        }
        return all;
    }
};

}

// Away from borders by 1e-4 of a texel, where float decides as exact arithmetic does, the texel is the same one.
TEST_F(SamplingTest, nearest_reads_the_same_texels)
{
    std::size_t compared = 0;
    for (const glm::ivec2 size : {glm::ivec2(8, 8), {5, 7}, {1, 1}, {1, 6}, {16, 3}})
        for (const Wrap wrap_u : both_wraps)
            for (const Wrap wrap_v : both_wraps) {
                const Grid<glm::vec4> texture = random_texture(random, size.x, size.y);
                const Sampler sampler{Filter::nearest, wrap_u, wrap_v};
                const std::vector<glm::vec2> where = places(3);
                const std::vector<glm::vec4> colours = sampled(texture, sampler, where);
                for (std::size_t i = 0; i < where.size(); ++i) {
                    const glm::vec2 rest = where[i] * glm::vec2(size) - glm::round(where[i] * glm::vec2(size));
                    if (std::min(std::abs(rest.x), std::abs(rest.y)) < 1e-4F) continue;
                    ++compared;
                    ASSERT_EQ(lookup(texture, sampler, where[i]), colours[i])
                        << "seed " << seed << ", at " << where[i].x << ", " << where[i].y;
                }
            }
    std::printf("%zu nearest texels, all the same\n", compared);
    EXPECT_GT(compared, 300'000U);
}

// OpenGL lets drivers round the weights of a blend to a few bits; Mesa blends textures of floats in float.
TEST_F(SamplingTest, bilinear_blends_alike)
{
    float worst = 0;
    std::size_t compared = 0;
    for (const glm::ivec2 size : {glm::ivec2(8, 8), {5, 7}, {1, 1}, {1, 6}, {16, 3}})
        for (const Wrap wrap_u : both_wraps)
            for (const Wrap wrap_v : both_wraps) {
                const Grid<glm::vec4> texture = random_texture(random, size.x, size.y);
                const Sampler sampler{Filter::bilinear, wrap_u, wrap_v};
                const std::vector<glm::vec2> where = places(3);
                const std::vector<glm::vec4> colours = sampled(texture, sampler, where);
                for (std::size_t i = 0; i < where.size(); ++i) {
                    const float error = largest(abs(lookup(texture, sampler, where[i]) - colours[i]));
                    worst = std::max(worst, error);
                    ++compared;
                    ASSERT_LE(error, 1e-5F) << "seed " << seed << ", at " << where[i].x << ", " << where[i].y;
                }
            }
    std::printf("%zu blends, off by at most %.3g\n", compared, double{worst});
    RecordProperty("worst", std::to_string(worst));
}

}
