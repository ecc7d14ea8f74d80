#include <gtest/gtest.h>

#include <bench/scenes/painters.hpp>
#include <bench/scenes/rearrange.hpp>
#include <bench/scenes/shapes.hpp>
#include <bench/scenes/spoil.hpp>
#include <umbral/core/random.hpp>

namespace umbral::bench::scenes {
namespace {

Model one_square(const glm::vec4& color)
{
    Model m;
    m.width = 40;
    m.height = 30;
    m.camera.ortho_height = 3;
    m.encoded = false;
    m.background = {0, 0, 0, 1};
    Batch batch;
    batch.corners = square();
    batch.material.style = Style::plain;
    batch.material.color = color;
    m.batches = {batch};
    return m;
}

// Ten pixels a unit: the square covers columns 10 to 29 and rows 5 to 24, in its own colour.
void expect_square(const Image& image, const glm::u8vec4& color)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool inside = x >= 10 && x < 30 && y >= 5 && y < 25;
            ASSERT_EQ(image.at(x, y), inside ? color : glm::u8vec4(0, 0, 0, 255)) << x << ", " << y;
        }
}

TEST(BenchPainters, draw_what_is_known)
{
    const Model m = one_square({1, 0.2F, 0.6F, 1});
    const glm::u8vec4 color(255, 51, 153, 255);
    for (const Way way : {Way::as_it_is, Way::not_optimised, Way::double_precision})
        expect_square(Painters::software(way).paint(m, Flaw::none, way), color);
    gl::forbid_driver_threads();
    Painters painters(gl::default_backend());
    expect_square(painters.opengl(m, Flaw::none, Way::as_it_is), color);
    if (painters.has(Way::other_gl_back_end))
        expect_square(painters.opengl(m, Flaw::none, Way::other_gl_back_end), color);
}

// One lamp straight above a white square, and nothing but ambient and diffuse: 0.1 + 0.5, encoded by 1/2.2.
TEST(BenchPainters, light_as_written)
{
    Model m = one_square({1, 1, 1, 1});
    m.encoded = true;
    m.ambient = glm::vec3(0.1F);
    m.lights = {{.place = {0, 0, 1, 0}, .color = glm::vec3(0.5F)}};
    m.batches[0].material.style = Style::lit;
    const auto level = [&](Flaw flaw) {
        Model spoilt = m;
        spoil(spoilt, flaw);
        return int{Painters::software(Way::as_it_is).paint(spoilt, flaw, Way::as_it_is).at(20, 15).r};
    };
    const auto encoded = [](double light) {
        return static_cast<int>(std::floor(255 * std::pow(light, 1 / 2.2) + 0.5));
    };
    EXPECT_EQ(level(Flaw::none), encoded(0.6));
    EXPECT_EQ(level(Flaw::ambient_missing), encoded(0.5));
    EXPECT_EQ(level(Flaw::ambient_twice), encoded(0.7));
    EXPECT_EQ(level(Flaw::one_light_missing), encoded(0.1));
    EXPECT_EQ(level(Flaw::gamma_missing), 153);
    EXPECT_EQ(level(Flaw::brightness_5_percent), encoded(0.57));
}

TEST(BenchPainters, rearranging_keeps_the_triangles)
{
    Model m = one_square({1, 1, 1, 1});
    m.batches[0].corners = gem(1);
    const auto area = [](const Model& of) {
        double sum = 0;
        const Triangles& t = of.batches[0].corners;
        for (std::size_t i = 0; i < t.size(); i += 3)
            sum += glm::length(glm::cross(t[i + 1].position - t[i].position, t[i + 2].position - t[i].position));
        return sum;
    };
    const double before = area(m);
    for (const Way way : {Way::triangles_reordered, Way::corners_rotated, Way::triangles_split}) {
        Model other = m;
        rearrange(other, way);
        EXPECT_NEAR(area(other), before, 1e-4 * before) << operator_of(way).name;
        const auto same_place = [](const Vertex& v, const Vertex& w) { return v.position == w.position; };
        EXPECT_FALSE(std::ranges::equal(other.batches[0].corners, m.batches[0].corners, same_place))
            << operator_of(way).name;
    }
    Model less = m;
    spoil(less, Flaw::missing_triangle);
    EXPECT_EQ(less.batches[0].corners.size() + 3, m.batches[0].corners.size());
}

TEST(BenchPainters, meshes_turn_outwards)
{
    constexpr glm::vec2 outline[] = {{0.5F, -0.5F}, {0.6F, 0}, {0.5F, 0.5F}};
    for (const Triangles& mesh : {ball(16, 8), torus(0.3F, 24, 12), box(glm::vec3(0.5F)), gem(1), knot(0.2F, 60, 12),
                                  lathe(outline, 16), vase(16), square(2), ground(2)})
        for (std::size_t i = 0; i < mesh.size(); i += 3) {
            const glm::vec3 n =
                glm::cross(mesh[i + 1].position - mesh[i].position, mesh[i + 2].position - mesh[i].position);
            ASSERT_GT(glm::dot(n, mesh[i].normal + mesh[i + 1].normal + mesh[i + 2].normal), 0) << i / 3;
        }
    for (const Vertex& v : ball(16, 8)) EXPECT_GT(glm::dot(v.position, v.normal), 0.99F);
}

}
}
