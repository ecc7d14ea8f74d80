#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <pipeline/support.hpp>

#include "../units/ulps.hpp"
#include "render/raster.hpp"

// The engine's rasteriser and the reference of pipeline/rasterize-triangle, its plain form: the same fragments, on a
// million triangles of all kinds. Where the engine promises an exact number, bit for bit.
namespace umbral::render::test {
namespace {

using pipeline::Fragment;
using pipeline::Triangle;

constexpr int width = 40;
constexpr int height = 24;

constexpr std::size_t triangles_wanted = 1'000'000;

using Positions = std::array<glm::vec2, 3>;

/// Three corners, one by one: whatever order a compiler computes arguments in, a seed gives the same ones.
template <class Place>
Positions placed(const Place& place)
{
    Positions positions{};
    for (glm::vec2& corner : positions) {
        corner.x = place();
        corner.y = place();
    }
    return positions;
}

/// On one line through pixels' centres, or with a corner twice: no area.
Positions without_area(Random& random)
{
    const pipeline::Aim aim = pipeline::random_aim(random, width, height);
    const float one = pipeline::on_grid(random, -2, 3, 1);
    const float other = pipeline::on_grid(random, -2, 3, 1);
    return {aim.centre, aim.centre + one * aim.step, aim.centre + other * aim.step};
}

/// Some triangles of each kind, until there are enough.
class Triangles {
public:
    explicit Triangles(Random& random) : random_(random) {}

    std::vector<Triangle> next()
    {
        std::vector<Positions> positions;
        for (int i = 0; i < 100; ++i) {
            positions.push_back(placed([&] { return random_.uniform(-8, 48); }));
            positions.push_back(placed([&] { return pipeline::on_grid(random_, -4, 40, 2); }));  // centres and corners
            positions.push_back(placed([&] { return random_.uniform(3, 5); }));                  // a pixel or none
            positions.push_back(placed([&] { return random_.uniform(-200, 300); }));  // mostly beyond the picture
            positions.push_back(placed([&] { return random_.uniform(-16384, 16384); }));
            positions.push_back(without_area(random_));
            positions.push_back(pipeline::unrounded_triangle(random_, 24));
            positions.push_back(pipeline::huge_triangle(random_, width, height, i % 2 == 0));
            positions.push_back(pipeline::needle(random_, width, height, 1 << (i % 14), i % 2 == 0));
        }
        for (int i = 0; i < 2; ++i) {
            const std::vector<Positions> shared = pipeline::random_partition(random_, 6);
            positions.insert(positions.end(), shared.begin(), shared.end());
        }
        const std::vector<Positions> shared = pipeline::fan(random_, {12.5F, 12}, 9);
        positions.insert(positions.end(), shared.begin(), shared.end());
        std::vector<Triangle> triangles;
        for (const Positions& some : positions) triangles.push_back(pipeline::random_attributes(random_, some));
        for (int i = 0; i < 20; ++i) spoil(triangles[random_.below(static_cast<std::uint32_t>(triangles.size()))]);
        return triangles;
    }

private:
    /// Makes one number a nonsensical one.
    void spoil(Triangle& triangle)
    {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        constexpr float infinity = std::numeric_limits<float>::infinity();
        constexpr std::array<float, 7> values = {nan, infinity, -infinity, 16384.5F, -16385, 0, -1};
        const float value = values.at(random_.below(values.size()));
        pipeline::WindowVertex& vertex = triangle.at(random_.below(3));
        switch (random_.below(4)) {
            case 0: vertex.position.x = value; break;
            case 1: vertex.position.y = value; break;
            case 2: vertex.inverse_w = value; break;
            default: vertex.depth = nan; break;
        }
    }

    Random& random_;
};

/// The whole picture, or a tile of it.
Window random_window(Random& random)
{
    if (random.below(2) == 0) return {{0, width - 1}, {0, height - 1}};
    const auto left = static_cast<std::int64_t>(random.below(width));
    const auto top = static_cast<std::int64_t>(random.below(height));
    return {{left, std::min<std::int64_t>(left + 11, width - 1)}, {top, std::min<std::int64_t>(top + 7, height - 1)}};
}

/// What the reference has in the window.
void expect_fragments(const Triangle& triangle, const Window& window, std::vector<Fragment>& fragments)
{
    fragments.clear();
    pipeline::rasterize_triangle(triangle, width, height, fragments);
    const auto& [columns, rows] = window;
    std::erase_if(fragments, [&, columns = columns, rows = rows](const Fragment& fragment) {
        const glm::ivec2& at = fragment.pixel;
        return at.x < columns.first || at.x > columns.last || at.y < rows.first || at.y > rows.last;
    });
}

/// The engine's rows and its edges' values, and of these what the reference makes of its own.
void make_fragments(const Triangle& triangle, const Window& window, std::vector<Fragment>& fragments)
{
    fragments.clear();
    const Setup setup = set_up(triangle, window);
    const auto& [a, b, c] = triangle;
    for_each_run(setup, [&, &a = a, &b = b, &c = c](int y, int first, int last) {
        for (int x = first; x <= last; ++x) {
            const auto& [bc, ca, ab] = setup.edges;
            const glm::i64vec3 edges(bc.at(x, y), ca.at(x, y), ab.at(x, y));
            const glm::dvec3 affine = glm::dvec3(edges) / static_cast<double>(edges.x + edges.y + edges.z);
            const glm::dvec3 share = affine * glm::dvec3(a.inverse_w, b.inverse_w, c.inverse_w);
            const double depth = dot(affine, glm::dvec3(a.depth, b.depth, c.depth));
            fragments.push_back({{x, y}, static_cast<float>(depth), glm::vec3(share / (share.x + share.y + share.z))});
        }
    });
}

bool same_bits(const Fragment& a, const Fragment& b)
{
    const auto same = [](float s, float t) {
        return std::bit_cast<std::uint32_t>(s) == std::bit_cast<std::uint32_t>(t);
    };
    return a.pixel == b.pixel && same(a.depth, b.depth) && same(a.weights.x, b.weights.x) &&
           same(a.weights.y, b.weights.y) && same(a.weights.z, b.weights.z);
}

/// What draw_triangle() leaves in an empty picture.
class Drawn {
public:
    void draw(const Triangle& triangle, const Window& window)
    {
        std::fill(depths.begin(), depths.end(), nothing);
        count = 0;
        covered = 0;
        draw_triangle(
            triangle, window, width, depths.data(), [&](int n) { covered += static_cast<std::size_t>(n); },
            [&](const Passed& passed) {
                for (std::size_t i = 0; i < lane_count; ++i) {
                    if (passed.mask[i] == 0) continue;
                    ++count;
                    weights.at(passed.at + i) = {passed.weights[0][i], passed.weights[1][i], passed.weights[2][i]};
                }
            });
    }

    static constexpr float nothing = 2;  ///< farther than any depth
    static constexpr std::size_t cells = std::size_t{width} * height;
    std::vector<float> depths = std::vector<float>(cells + lane_count);
    std::vector<glm::vec3> weights = std::vector<glm::vec3>(cells);
    std::size_t count = 0, covered = 0;
};

/// How many times nearer than the point of these weights the nearest corner is: w here over the least w.
float nearness(const Triangle& triangle, const glm::vec3& weights)
{
    const auto& [a, b, c] = triangle;
    const float w = weights.x / a.inverse_w + weights.y / b.inverse_w + weights.z / c.inverse_w;
    return w * std::max({a.inverse_w, b.inverse_w, c.inverse_w});
}

}

TEST(Rows, the_reference_has_the_same_fragments)
{
    constexpr std::uint64_t seed = 20701;
    RecordProperty("seed", std::to_string(seed));
    Random random(seed);
    Triangles some(random);
    std::vector<Fragment> expected;
    std::vector<Fragment> got;
    std::size_t count = 0;
    std::size_t pixels = 0;
    std::size_t empty = 0;
    while (count < triangles_wanted)
        for (const Triangle& triangle : some.next()) {
            const Window window = random_window(random);
            expect_fragments(triangle, window, expected);
            make_fragments(triangle, window, got);
            ASSERT_EQ(got.size(), expected.size()) << "seed " << seed << ", triangle " << count;
            for (std::size_t i = 0; i < got.size(); ++i)
                ASSERT_TRUE(same_bits(got[i], expected[i])) << "seed " << seed << ", triangle " << count << ", pixel "
                                                            << expected[i].pixel.x << ", " << expected[i].pixel.y;
            ++count;
            pixels += got.size();
            empty += got.empty() ? 1 : 0;
        }
    std::printf("%zu triangles, %zu of them empty, %zu fragments; seed %llu\n", count, empty, pixels,
                static_cast<unsigned long long>(seed));
    EXPECT_GT(pixels, 20 * count);
    EXPECT_LT(empty, 6 * count / 10);
}

// The promise of draw_triangle(): coverage exact, depths within a rounding of the reference's, weights within a few of
// 2^-24, times how much nearer than the pixel the nearest corner is.
TEST(Rows, drawing_keeps_its_promise)
{
    constexpr std::uint64_t seed = 20702;
    RecordProperty("seed", std::to_string(seed));
    Random random(seed);
    Triangles some(random);
    std::vector<Fragment> expected;
    Drawn drawn;
    double worst_depth = 0;
    float worst_weight = 0;  // over the nearness of the nearest corner
    std::size_t count = 0;
    while (count < triangles_wanted / 4)
        for (const Triangle& triangle : some.next()) {
            const Window window = random_window(random);
            expect_fragments(triangle, window, expected);
            drawn.draw(triangle, window);
            ASSERT_EQ(drawn.count, expected.size()) << "seed " << seed << ", triangle " << count;
            ASSERT_EQ(drawn.covered, expected.size()) << "seed " << seed << ", triangle " << count;
            for (const auto& [pixel, depth, weights] : expected) {
                const std::size_t at = static_cast<std::size_t>(pixel.y) * width + static_cast<std::size_t>(pixel.x);
                ASSERT_NE(drawn.depths[at], Drawn::nothing) << "seed " << seed << ", triangle " << count;
                worst_depth = std::max(worst_depth, tests::ulps_between(drawn.depths[at], depth));
                const glm::vec3 off = abs(drawn.weights[at] - weights);
                worst_weight = std::max(worst_weight, std::max({off.x, off.y, off.z}) / nearness(triangle, weights));
            }
            ++count;
        }
    std::printf("%zu triangles; depths off by %.3g ulp at most, weights by %.3g * 2^-24; seed %llu\n", count,
                worst_depth, 0x1p24 * double{worst_weight}, static_cast<unsigned long long>(seed));
    EXPECT_LE(worst_depth, 1);
    EXPECT_LE(worst_weight, 8 * 0x1p-24F);
}

}
