#include <gtest/gtest.h>

#include <bench/scenes/scenes.hpp>
#include <cmath>

namespace umbral::bench::scenes {
namespace {

int largest_difference(const Image& a, const Image& b)
{
    int most = 0;
    for (std::size_t i = 0; i < a.cells.size(); ++i)
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(int{a.cells[i][k]} - int{b.cells[i][k]}));
    return most;
}

/// The share of pixels that differ by more than 12 levels in a channel.
double share_that_differs(const Image& a, const Image& b)
{
    double count = 0;
    for (std::size_t i = 0; i < a.cells.size(); ++i) {
        const glm::ivec3 d = glm::abs(glm::ivec3(a.cells[i]) - glm::ivec3(b.cells[i]));
        count += std::max({d.r, d.g, d.b}) > 12 ? 1 : 0;
    }
    return count / static_cast<double>(a.cells.size());
}

/// The mean over the whole picture.
glm::dvec3 mean_color(const Image& image)
{
    glm::dvec3 sum(0);
    for (const glm::u8vec4& pixel : image.cells) sum += glm::dvec3(pixel);
    return sum / static_cast<double>(image.cells.size());
}

/// The mean light, in 255ths: noise of 16 samples in 20000 pixels is far below half of one there. (The mean of sRGB
/// codes depends on noise.)
glm::dvec3 mean_light(const Image& image)
{
    glm::dvec3 sum(0);
    for (const glm::u8vec4& pixel : image.cells)
        for (glm::length_t c = 0; c < 3; ++c)
            sum[c] += pixel[c] <= 10 ? pixel[c] / 12.92 : 255 * std::pow((pixel[c] / 255.0 + 0.055) / 1.055, 2.4);
    return sum / static_cast<double>(image.cells.size());
}

Painters made()
{
    gl::forbid_driver_threads();
    return Painters(gl::default_backend());
}

TEST(BenchScenes, names_differ)
{
    std::set<std::string> names;
    for (const Scene& scene : all_scenes(64)) EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
}

TEST(BenchScenes, every_operator_is_used)
{
    std::set<Flaw> flaws;
    std::set<Way> ways;
    for (const Scene& scene : all_scenes(64)) {
        flaws.insert(scene.flaws.begin(), scene.flaws.end());
        ways.insert(scene.ways.begin(), scene.ways.end());
    }
    for (const Flaw flaw : all_flaws()) EXPECT_TRUE(flaws.contains(flaw)) << operator_of(flaw).name;
    for (const Way way : all_ways()) EXPECT_TRUE(ways.contains(way)) << operator_of(way).name;
}

// At the size at which judges see them. Two levels are what nobody sees.
TEST(BenchScenes, every_flaw_shows)
{
    Painters painters = made();
    for (const Scene& scene : all_scenes(256)) {
        const Image expected = scene.draw(painters, Flaw::none, Way::as_it_is);
        for (const Flaw flaw : scene.flaws)
            EXPECT_GT(largest_difference(expected, scene.draw(painters, flaw, Way::as_it_is)), 2)
                << scene.name << ": " << operator_of(flaw).name;
    }
}

// Right is right: another way may round differently, and decide a few pixels at edges differently, but has no other
// brightness.
TEST(BenchScenes, other_ways_draw_the_same)
{
    Painters painters = made();
    for (const Scene& scene : all_scenes(128)) {
        if (scene.noise) continue;
        const Image expected = scene.draw(painters, Flaw::none, Way::as_it_is);
        for (const Way way : scene.ways) {
            if (!painters.has(way)) continue;
            const Image image = scene.draw(painters, Flaw::none, way);
            EXPECT_LT(share_that_differs(expected, image), 0.01) << scene.name << ": " << operator_of(way).name;
            // Less than one level in each channel: blending rounds once a layer.
            const glm::dvec3 moved = glm::abs(mean_color(image) - mean_color(expected));
            EXPECT_LT(std::max({moved.r, moved.g, moved.b}), 1) << scene.name << ": " << operator_of(way).name;
        }
    }
}

// Other random numbers and other right estimators have the same mean; wrong estimators have not.
TEST(BenchScenes, noise_has_one_mean)
{
    Painters painters = made();
    for (const Scene& scene : all_scenes(192)) {
        if (!scene.noise) continue;
        const glm::dvec3 expected = mean_light(scene.draw(painters, Flaw::none, Way::as_it_is));
        for (const Way way : scene.ways) {
            if (!painters.has(way)) continue;
            EXPECT_LT(glm::length(mean_light(scene.draw(painters, Flaw::none, way)) - expected), 0.5)
                << scene.name << ": " << operator_of(way).name;
        }
        EXPECT_GT(glm::length(mean_light(scene.draw(painters, Flaw::light_3_percent, Way::as_it_is)) - expected), 1.5)
            << scene.name;
    }
}

}
}
