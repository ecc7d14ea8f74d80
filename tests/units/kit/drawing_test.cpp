#include <gtest/gtest.h>

#include <kit/drawing.hpp>
#include <umbral/core/random.hpp>

// What is drawn, against each pixel's own distance from the line, or against samples that are looked up side by side.
namespace umbral {
namespace {

constexpr int width = 61;
constexpr int height = 47;
constexpr glm::vec3 ink_of_test(0.9F, 0.4F, 0.2F);

Drawing empty_drawing() { return {width, height, {-3.05, -2.35}, {3.05, 2.35}}; }

/// The place in pixels, from the left and from the top.
glm::dvec2 in_pixels(const glm::dvec2& place) { return {0.5 * width + 10 * place.x, 0.5 * height - 10 * place.y}; }

/// The picture whose every pixel is covered as `cover` says of its middle.
template <class Cover>
Image covered(Cover cover)
{
    Image picture(width, height);
    const glm::dvec3 below = srgb_decoded(glm::dvec3(ink::night));
    const glm::dvec3 above = srgb_decoded(glm::dvec3(ink_of_test));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = pixel_of(glm::mix(below, above, cover(glm::dvec2(x + 0.5, y + 0.5))));
    return picture;
}

/// But for one code, which rounding may make.
void expect_same(const Image& drawn, const Image& expected, std::uint64_t seed)
{
    for (std::size_t i = 0; i < drawn.cells.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(drawn.cells[i][c], expected.cells[i][c], 1)
                << "seed " << seed << ", x " << i % width << ", y " << i / width;
}

glm::dvec2 random_place(Random& random) { return {random.uniform(-4.0F, 4.0F), random.uniform(-3.0F, 3.0F)}; }

TEST(Drawing, covers_what_is_near_a_line)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const glm::dvec2 from = random_place(random);
        glm::dvec2 to = random_place(random);
        if (seed % 5 == 1) to.y = from.y;
        if (seed % 5 == 2) to.x = from.x;
        if (seed % 5 == 3) to.y = from.y + 1e-9;
        if (seed % 40 == 4) to = from;
        const double thickness = random.uniform(0.5F, 9.0F);
        Drawing drawing = empty_drawing();
        drawing.line(from, to, ink_of_test, thickness);
        const glm::dvec2 a = in_pixels(from);
        const glm::dvec2 b = in_pixels(to);
        expect_same(drawing.picture(), covered([&](const glm::dvec2& p) {
                        const double along = std::clamp(dot(p - a, b - a) / std::max(dot(b - a, b - a), 1e-30), 0., 1.);
                        return std::clamp(0.5 * thickness - distance(p, mix(a, b, along)) + 0.5, 0.0, 1.0);
                    }),
                    seed);
    }
}

TEST(Drawing, covers_what_is_inside_a_polygon)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        std::vector<glm::dvec2> places;
        for (int i = 0; i < 3 + static_cast<int>(seed % 6); ++i) places.push_back(random_place(random));
        if (seed % 3 == 0) places[1].y = places[0].y;
        Drawing drawing = empty_drawing();
        drawing.area(places, ink_of_test);
        expect_same(drawing.picture(), covered([&](const glm::dvec2& middle) {
                        int inside = 0;
                        for (int sample = 0; sample < 16; ++sample) {
                            const glm::dvec2 p = middle + glm::dvec2(sample % 4, sample / 4) / 4.0 - 0.375;
                            // Sides to the right of it, by the side on which it lies of each.
                            int crossed = 0;
                            for (std::size_t i = 0; i < places.size(); ++i) {
                                const glm::dvec2 a = in_pixels(places[i]) - p;
                                const glm::dvec2 b = in_pixels(places[(i + 1) % places.size()]) - p;
                                if ((a.y > 0) != (b.y > 0) && (a.x * b.y - a.y * b.x > 0) == (b.y > a.y)) ++crossed;
                            }
                            inside += crossed % 2;
                        }
                        return inside / 16.0;
                    }),
                    seed);
    }
}

TEST(Drawing, draws_nothing_for_places_that_are_none)
{
    Drawing drawing = empty_drawing();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    drawing.line({0, nan}, {1, 1}, ink_of_test);
    drawing.disc({nan, 0}, 4, ink_of_test);
    drawing.area(std::vector<glm::dvec2>{{0, 0}, {1e9, 0}, {0, 1}}, ink_of_test);
    expect_same(drawing.picture(), covered([](const glm::dvec2&) { return 0.0; }), 0);
}

}
}
