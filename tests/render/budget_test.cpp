#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <umbral/core/random.hpp>

#include "render/budget/draw.hpp"
#include "scenes.hpp"

// What is chosen for a budget, on curves that are known, and on a scene.
namespace umbral::render::budget::test {
namespace {

constexpr unsigned seed = 20261123;

/// Noise that falls as a power of the rays, and cuts that save time for bias, all by chance.
Model random_model(Random& random, double slope)
{
    Model model;
    const double first = 0.02 + 0.3 * random.uniform_double();
    for (int rays = 1; rays <= 32; rays *= 2) model.noise.push_back({rays, first * std::pow(rays, slope)});
    model.ray_seconds = 0.01 + random.uniform_double();
    for (std::vector<Cut>* cuts : {&model.depths, &model.bounces}) {
        *cuts = {{5, 0, 1}};
        for (int value = 4; value >= 1; --value)
            cuts->push_back({value, cuts->back().bias + 0.01 * random.uniform_double(),
                             cuts->back().cost * (0.5 + 0.5 * random.uniform_double())});
    }
    return model;
}

TEST(Budget, the_slope_of_a_power_is_found_and_carried_on)
{
    Random random(seed);
    for (const double slope : {-0.5, -0.75, -1.0, -1.4}) {
        const Model model = random_model(random, slope);
        EXPECT_NEAR(noise_slope(model), slope, 1e-9);
        // 4096 is far beyond what was measured.
        EXPECT_NEAR(noise_of(model, 4096) / (model.noise[0].error * std::pow(4096, slope)), 1, 1e-9);
    }
}

TEST(Budget, twelve_rays_are_the_weighted_mean_of_eight_and_four)
{
    const Model model{{{1, 0.4}, {4, 0.1}, {8, 0.04}}, {{0, 0, 1}}, {{0, 0, 1}}, 1};
    EXPECT_NEAR(noise_of(model, 12), std::sqrt(0.32 * 0.32 + 0.4 * 0.4) / 12, 1e-12);
}

TEST(Budget, an_uneven_number_of_rays_that_was_measured_is_not_put_together)
{
    Model model{{{1, 0.4}, {2, 0.2}, {4, 0.05}}, {{0, 0, 1}}, {{0, 0, 1}}, 1};
    EXPECT_NEAR(noise_of(model, 3), std::sqrt(0.4 * 0.4 + 0.4 * 0.4) / 3, 1e-12);
    EXPECT_EQ(cheapest(model, 0.1).setting.rays, 4);
    model.uneven = {{3, 0.09}};
    EXPECT_EQ(noise_of(model, 3), 0.09);
    EXPECT_EQ(cheapest(model, 0.1).setting.rays, 3);
    EXPECT_NEAR(noise_of(model, 6), std::sqrt(0.2 * 0.2 + 0.4 * 0.4) / 6, 1e-12) << "other numbers are as before";
}

TEST(Budget, chooses_what_trying_every_setting_chooses)
{
    Random random(seed);
    for (int trial = 0; trial < 50; ++trial) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", trial " << trial);
        const double slope = -0.5 - random.uniform_double();
        const Model model = random_model(random, slope);
        const double error = 0.003 + 0.05 * random.uniform_double();
        const double seconds = 0.05 + 20 * random.uniform_double();
        // By the power itself, not by the model; powers of two only, of which the choice has more to choose from.
        double least_seconds = HUGE_VAL;
        double least_error = HUGE_VAL;
        for (const Cut& depth : model.depths)
            for (const Cut& bounces : model.bounces)
                for (int rays = 1; rays <= most_rays; rays *= 2) {
                    const double cost = rays * model.ray_seconds * depth.cost * bounces.cost;
                    const double got =
                        std::hypot(model.noise[0].error * std::pow(rays, slope), depth.bias + bounces.bias);
                    if (got <= error * (1 - 1e-9)) least_seconds = std::min(least_seconds, cost);
                    if (cost <= seconds * (1 - 1e-9)) least_error = std::min(least_error, got);
                }
        const Choice cheap = cheapest(model, error);
        EXPECT_EQ(cheap.reached, std::isfinite(least_seconds));
        if (cheap.reached) {
            EXPECT_LE(cheap.predicted.error, error);
            EXPECT_LE(cheap.predicted.seconds, least_seconds * (1 + 1e-9));
        }
        const Choice accurate = most_accurate(model, seconds);
        EXPECT_EQ(accurate.reached, std::isfinite(least_error));
        if (accurate.reached) {
            EXPECT_LE(accurate.predicted.seconds, seconds);
            EXPECT_LE(accurate.predicted.error, least_error * (1 + 1e-9));
        }
    }
}

TEST(Budget, what_is_out_of_reach_is_said_and_approached)
{
    Random random(seed);
    Model model = random_model(random, -0.5);
    EXPECT_FALSE(cheapest(model, 1e-9).reached);
    const Choice quickest = most_accurate(model, 1e-9);
    EXPECT_FALSE(quickest.reached);
    EXPECT_EQ(quickest.setting, (Setting{1, 1, 1}));
}

TEST(Budget, wishes_have_units)
{
    EXPECT_DOUBLE_EQ(parse_wish("1%", "").value, 0.01);
    EXPECT_DOUBLE_EQ(parse_wish("", "2s").value, 2);
    EXPECT_DOUBLE_EQ(parse_wish("", "250ms").value, 0.25);
    EXPECT_FALSE(parse_wish("", "2s").is_error);
    for (const char* wrong : {"0", "0%", "-1%", "abc", "1", "%", "nan%", "100%", "1 %", "1%%"})
        EXPECT_THROW((void)parse_wish(wrong, ""), std::runtime_error) << wrong;
    for (const char* wrong : {"0s", "-1s", "2", "s", "infs", "2h", "90000s"})
        EXPECT_THROW((void)parse_wish("", wrong), std::runtime_error) << wrong;
    EXPECT_THROW((void)parse_wish("1%", "2s"), std::runtime_error);
    EXPECT_THROW((void)parse_wish("", ""), std::runtime_error);
}

TEST(Budget, a_picture_has_the_error_that_was_asked_for)
{
    const scene::Scene scene = render::test::first_light();
    // Times are not looked at: a clock that stands still.
    const Result result =
        draw_within({true, 0.02}, scene, make_draw_list(scene, 64, 48, true), 64, 48, 2, [] { return 0.0; });
    EXPECT_TRUE(result.choice.reached);
    DrawList list = make_draw_list(scene, 64, 48, true);
    const rays::World world = rays::make_world(list);
    const Stage stage{scene, list, world, 64, 48, 2, [] { return 0.0; }};
    const Look chosen = look_at(stage, result.choice.setting, 1, 3);
    const Look converged = look_at(stage, {512, list.depth, list.bounces}, 1, 9);
    const double error = std::sqrt(2.0) * error_between(chosen.shown, converged.shown);
    EXPECT_LE(error, 1.2 * 0.02);
    EXPECT_NEAR(error / result.choice.predicted.error, 1, 0.2);
    EXPECT_NEAR(error / result.measured_error, 1, 0.2);
}

TEST(Budget, half_way_the_rays_are_chosen_anew_by_what_half_of_them_took)
{
    const scene::Scene scene = render::test::first_light();
    // Every picture takes one tick, whatever its rays: half way it turns out that many more are had in that time.
    double ticks = 0;
    const Result result =
        draw_within({false, 100}, scene, make_draw_list(scene, 32, 24, true), 32, 24, 2, [&] { return ticks++; });
    EXPECT_GT(result.choice.setting.rays, 2 * result.planned_rays);
    EXPECT_LE(result.predicted_seconds, 100);
    DrawList list = make_draw_list(scene, 32, 24, true);
    const rays::World world = rays::make_world(list);
    const Stage stage{scene, list, world, 32, 24, 2, [] { return 0.0; }};
    const Look whole = look_at(stage, result.choice.setting, 1, 3);
    ASSERT_EQ(whole.frame.color.cells.size(), result.frame.color.cells.size());
    for (std::size_t i = 0; i < whole.frame.color.cells.size(); ++i)
        EXPECT_LT(glm::length(whole.frame.color.cells[i] - result.frame.color.cells[i]), 1e-4F) << i;
    EXPECT_EQ(whole.rays, result.followed);
}

TEST(Budget, scramblings_differ_and_every_part_of_a_picture_is_the_picture_s)
{
    const scene::Scene scene = render::test::first_light();
    const DrawList list = make_draw_list(scene, 32, 24, true);
    const auto draw = [&](int every, std::uint32_t scrambling) {
        return rays::draw_by_rays(list, 32, 24, {.rays = 4, .spread = true, .every = every, .scrambling = scrambling});
    };
    const Frame whole = draw(1, 1);
    EXPECT_NE(whole.color.cells, draw(1, 2).color.cells);
    for (const int every : {2, 5, 6}) {
        const Frame part = draw(every, 1);
        int drawn = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x) {
                const bool is_here = rays::is_drawn(every, x, y);
                drawn += is_here ? 1 : 0;
                EXPECT_EQ(part.color.at(x, y), is_here ? whole.color.at(x, y) : glm::vec4(0));
            }
        EXPECT_NEAR(drawn, 32.0 * 24 / every, 24);
    }
}

}
}
