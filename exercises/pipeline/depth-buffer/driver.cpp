#include <kit/channels.hpp>
#include <kit/refusal.hpp>
#include <kit/varied.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/driver.hpp>

#include "codes.hpp"
#include "rings.hpp"

namespace umbral {
namespace {

using namespace pipeline;

constexpr int functions = 8;
DepthFunction function(int i) { return static_cast<DepthFunction>(i); }

// Three answers in one row: less than, equal to, greater than the stored depth.
glm::vec3 passes(Recorder& out, DepthFunction function, float low, float high)
{
    ask_in_words(out, [&] {
        const auto call = [&](float incoming, float stored) {
            return "depth_passes(" + literal::of_value(function, true, {}) + ", " + literal::of(incoming) + ", " +
                   literal::of(stored) + ")";
        };
        return call(low, high) + "\n" + call(high, high) + "\n" + call(high, low);
    });
    return {depth_passes(function, low, high), depth_passes(function, high, high), depth_passes(function, high, low)};
}

// A row for each function. Any numbers are compared, and the two zeros are one.
void record_functions(Variation& vary, Recorder& out)
{
    const float close = vary.near(0.75F, 0.2F);
    for (const auto& [low, high] : {std::pair(vary.near(0.25F, 0.2F), 0.5F),
                                    {0.0F, 1.0F},
                                    {close, std::nextafter(close, 1.0F)},
                                    {0.0F, vary.scaled(1e-40F, 10)},
                                    {-vary.near(0.75F, 0.2F), -vary.near(0.25F, 0.2F)},
                                    {-0.0F, 0.0F},
                                    {-vary.scaled(1e-40F, 10), -0.0F},
                                    {-vary.scaled(1e30F, 100), vary.scaled(1e30F, 100)}})
        for (int i = 0; i < functions; ++i) out.append("passes", passes(out, function(i), low, high));
}

void record_formats(Variation& vary, Recorder& out)
{
    const std::vector depths{0.0F,
                             1.0F,
                             0.5F,
                             0.25F,
                             vary.near(0.1F, 0.05F),
                             vary.near(1.0F / 3, 0.1F),
                             vary.near(0.71F, 0.2F),
                             vary.near(0.999F, 0.0008F),
                             vary.scaled(1e-3F, 2),
                             vary.scaled(4e-6F, 1.5F),
                             vary.scaled(3e-8F, 3),
                             vary.scaled(1e-25F, 100),
                             vary.near(-0.25F, 0.2F),
                             vary.near(1.75F, 0.5F),
                             vary.scaled(0.0099F, 2),
                             vary.scaled(-300.0F, 2),
                             vary.scaled(300.0F, 2),
                             vary.scaled(5e4F, 1.4F),
                             vary.scaled(1e20F, 1e5F),
                             std::numeric_limits<float>::max()};
    for (const float depth : in_random_order(vary, depths))
        for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32})
            out.append("depth", ask<stored_depth>(out, format, depth));
}

// The states that matter beside the function: all formats, and in any of them the mask off, and the test disabled with
// the mask on, which writes nothing either.
std::vector<DepthState> states(Random& random)
{
    const auto format = [&] { return static_cast<DepthFormat>(random.below(3)); };
    return {{true, DepthFunction::less, true, DepthFormat::float32},
            {true, DepthFunction::less, true, DepthFormat::unorm16},
            {true, DepthFunction::less, true, DepthFormat::unorm24},
            {true, DepthFunction::less, false, format()},
            {false, DepthFunction::less, true, format()}};
}

std::vector<Fragment> random_fragments(Random& random, const Levels& levels, int count)
{
    std::vector<Fragment> fragments;
    for (int i = 0; i < count; ++i) {
        const int x = static_cast<int>(random.below(tile_width));
        const int y = static_cast<int>(random.below(tile_height));
        const float depth = random_depth(random, levels);
        const float u = random.uniform();
        const float v = (1 - u) * random.uniform();
        fragments.push_back({{x, y}, depth, {u, v, 1 - u - v}});
    }
    return fragments;
}

// The depths of a call's buffer, a row for each pixel.
void record_depths(Recorder& out, std::size_t call, const Grid<float>& result)
{
    const Grid<float> depths = of_size(result, tile_width, tile_height);
    for (int y = 0; y < tile_height; ++y)
        for (int x = 0; x < tile_width; ++x) {
            const std::array row = {static_cast<float>(call), static_cast<float>(x), static_cast<float>(y),
                                    depths.at(x, y)};
            out.append("depths", std::span<const float>(row));
        }
}

// All functions in all states: which fragments are left, and what the buffers hold afterwards.
void record_tests(Random& random, Recorder& out, int fragments_each)
{
    const std::vector<DepthState> all = states(random);
    out.text("left.names", "call");
    out.text("depths.names", "call");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (int column = 0; column < functions; ++column) {
            DepthState state = all[row];
            state.function = function(column);
            const Levels levels = random_levels(random, state.format);
            Grid<float> depths = random_depths(random, out, levels);
            std::vector<Fragment> fragments = random_fragments(random, levels, fragments_each);
            ask<test_depth>(out, state, fragments, depths);
            const std::size_t call = row * functions + static_cast<std::size_t>(column);
            record_depths(out, call, depths);
            fragments.resize(std::min<std::size_t>(fragments.size(), static_cast<std::size_t>(fragments_each)));
            for (const auto& [pixel, depth, weights] : fragments)
                out.append("left",
                           std::span<const float>(std::array{static_cast<float>(call), static_cast<float>(pixel.x),
                                                             static_cast<float>(pixel.y), depth, weights.x}));
        }
}

void record_colors(Recorder& out, const char* name, std::size_t scenario, const Layer& layer)
{
    const Grid<glm::vec3> colors = of_size(layer.colors, tile_width, tile_height);
    for (int y = 0; y < tile_height; ++y)
        for (int x = 0; x < tile_width; ++x) {
            const glm::vec3 color = colors.at(x, y);
            if (color == glm::vec3(0)) continue;
            const std::array row = {
                static_cast<float>(scenario), static_cast<float>(x), static_cast<float>(y), color.r, color.g, color.b};
            out.append(name, std::span<const float>(row));
        }
}

// Light, which may be more than a screen shows, or have none of a colour.
glm::vec3 random_color(Random& random)
{
    const glm::vec3 color = 0.1F + 1.9F * glm::abs(random.in_cube());
    return random.below(6) == 0 ? without_a_channel(random, color) : color;
}

void record_drawing(Random& random, Recorder& out)
{
    const std::vector<DepthState> all = states(random);
    out.text("colours.names", "call");
    out.text("depths.names", "call");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (const ShadeModel model : {ShadeModel::flat, ShadeModel::smooth}) {
            const std::size_t picture = 2 * row + (model == ShadeModel::flat ? 0 : 1);
            const Levels levels = random_levels(random, all[row].format);
            Layer layer{{tile_width, tile_height}, random_depths(random, out, levels)};
            for (std::size_t triangle = 0; triangle < 3; ++triangle) {
                const glm::vec3 a = random_color(random);
                const glm::vec3 b = random_color(random);
                // The last triangle may be black, at one corner or all: it hides what was there like any other.
                const bool is_black = triangle == 2 && row % 2 == 0;
                const glm::vec3 c = is_black ? glm::vec3(0) : random_color(random);
                const std::array colors = {is_black && row > 0 ? c : a, is_black && row > 0 ? c : b, c};
                ask<draw_fragments>(out, all[row], model, colors, random_fragments(random, levels, 20), layer);
                record_colors(out, "colours", 3 * picture + triangle, layer);
                record_depths(out, 3 * picture + triangle, layer.depths);
            }
        }
}

void record_merging(Random& random, Recorder& out)
{
    const std::vector<DepthState> all = states(random);
    out.text("colours.names", "call");
    out.text("depths.names", "call");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (int column = 0; column < functions; ++column) {
            DepthState state = all[row];
            state.function = function(column);
            const Levels levels = random_levels(random, state.format);
            const auto layer = [&] {
                Layer result{{tile_width, tile_height}, random_depths(random, out, levels)};
                // Black is a colour like others.
                for (glm::vec3& color : result.colors.cells)
                    color = random.below(8) == 0 ? glm::vec3(0) : random_color(random);
                return result;
            };
            const Layer source = layer();
            Layer target = layer();
            ask<merge_layers>(out, state, source, target);
            const std::size_t call = row * functions + static_cast<std::size_t>(column);
            record_colors(out, "colours", call, target);
            record_depths(out, call, target.depths);
        }
}

// What these pixels of a layer keep, each once.
void record_pixels(Recorder& out, std::size_t call, const glm::ivec2& size, const Layer& layer,
                   const std::vector<glm::ivec2>& pixels)
{
    const Grid<float> depths = of_size(layer.depths, size.x, size.y);
    const Grid<glm::vec3> colors = of_size(layer.colors, size.x, size.y);
    for (auto pixel = pixels.begin(); pixel != pixels.end(); ++pixel) {
        if (std::find(pixels.begin(), pixel, *pixel) != pixel) continue;
        const glm::vec3 color = colors.at(pixel->x, pixel->y);
        const std::array row = {static_cast<float>(call),
                                static_cast<float>(pixel->x),
                                static_cast<float>(pixel->y),
                                depths.at(pixel->x, pixel->y),
                                color.r,
                                color.g,
                                color.b};
        out.append("pixels", std::span<const float>(row));
    }
}

// Pictures wider and higher than a byte can count, and with more pixels than two bytes can: merged, and drawn into.
void record_large(Random& random, Recorder& out)
{
    out.text("pixels.names", "call");
    const DepthState state{true, DepthFunction::less, true, DepthFormat::unorm16};
    const auto below = [&](int count) { return static_cast<int>(random.below(static_cast<std::uint32_t>(count))); };
    std::size_t call = 0;
    const int some = 257 + below(100);
    const int many = 65'600 + below(100);
    const bool high = below(2) == 0;
    for (const glm::ivec2 size : {glm::ivec2(3, some), {some, 3}, high ? glm::ivec2(1, many) : glm::ivec2(many, 1)}) {
        const Levels levels{state.format, 1000 + random.below(60'000)};
        const Grid<float> few = random_depths(random, out, levels);
        const auto layer = [&] {
            Layer result{{size.x, size.y, random_color(random)}, {size.x, size.y}};
            for (float& depth : result.depths.cells) depth = few.cells[random.below(tile_width * tile_height)];
            return result;
        };
        const Layer source = layer();
        Layer target = layer();
        std::vector<Fragment> fragments = random_fragments(random, levels, 300);
        std::vector<glm::ivec2> pixels;
        for (Fragment& fragment : fragments) {
            const glm::ivec2 anywhere(below(size.x), below(size.y));
            const glm::ivec2 at_the_end = size - 1 - anywhere % 64;
            pixels.push_back(fragment.pixel = below(2) == 0 ? anywhere : at_the_end);
        }
        ask<merge_layers>(out, state, source, target);
        record_pixels(out, call++, size, target, pixels);
        const std::array colors = {glm::vec3(0), glm::vec3(0), random_color(random)};
        ask<draw_fragments>(out, state, ShadeModel::flat, colors, fragments, target);
        record_pixels(out, call++, size, target, pixels);
    }
}

// Two layers of equal and of different sizes, some with equally many pixels.
void record_sizes(Random& random, Recorder& out)
{
    const auto record = [&](glm::ivec2 source, glm::ivec2 target) {
        const Layer from{{source.x, source.y, glm::vec3(1)}, {source.x, source.y, 0.25F}};
        Layer to{{target.x, target.y}, {target.x, target.y, 0.5F}};
        record_refusal(out, "refused", [&] { ask<merge_layers>(out, {}, from, to); });
    };
    for (const glm::ivec2 other : {glm::ivec2(4, 6), {6, 5}, {5, 4}, {7, 4}, {12, 2}, {0, 0}, {3, 4}, {6, 3}}) {
        const bool equal_first = random.below(2) == 0;
        record({6, 4}, equal_first ? glm::ivec2(6, 4) : other);
        record({6, 4}, equal_first ? other : glm::ivec2(6, 4));
    }
}

}

const Driver driver = {
    {"functions", [](Case& c, Recorder& out) { record_functions(c.vary, out); }},
    {"formats", [](Case& c, Recorder& out) { record_formats(c.vary, out); }},
    {"codes", [](Case& c, Recorder& out) { record_codes(c.random, out); }},
    {"tests", [](Case& c, Recorder& out) { record_tests(c.random, out, 24); }},
    {"crowds", [](Case& c, Recorder& out) { record_tests(c.random, out, 160); }},
    {"drawing", [](Case& c, Recorder& out) { record_drawing(c.random, out); }},
    {"merging", [](Case& c, Recorder& out) { record_merging(c.random, out); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"large", [](Case& c, Recorder& out) { record_large(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_rings(out, c.vary)); }},
};

}
