#include <kit/refusal.hpp>
#include <kit/varied.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/driver.hpp>

#include "rings.hpp"

namespace umbral {
namespace {

using namespace pipeline;

constexpr int functions = 8;
// Columns and rows of the small buffers that stand side by side in what is recorded; not square.
constexpr int tile_width = 7;
constexpr int tile_height = 5;

DepthFunction function(int i) { return static_cast<DepthFunction>(i); }

float last_code(DepthFormat format) { return format == DepthFormat::unorm16 ? 65535.0F : 16777215.0F; }

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

// A row for each function.
void record_functions(Recorder& out)
{
    const float next = std::nextafter(0.75F, 1.0F);
    for (const auto& [low, high] : {std::pair(0.25F, 0.5F), {0.0F, 1.0F}, {0.75F, next}, {0.0F, 1e-40F}})
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
                             vary.scaled(0.0099F, 2)};
    for (const float depth : in_random_order(vary, depths))
        for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32})
            out.append("depth", ask<stored_depth>(out, format, depth));
}

// A code, and the float that is stored for it: nothing if that is more than two ulp from it.
struct Code {
    double number;
    std::optional<float> stored;
};

// The code nearest to a depth, behind its neighbours: a function that stores all depths alike has not found it.
std::array<Code, 3> codes_around(Recorder& out, DepthFormat format, float depth)
{
    const double last = last_code(format);
    const double nearest = std::nearbyint(depth * last);
    const auto code = [&](double number) {
        const double exact = number / last;
        const float stored = ask<stored_depth>(out, format, static_cast<float>(exact));
        const bool near = std::abs(stored - exact) <= std::ldexp(exact, -22);
        return Code{number, near ? std::optional(stored) : std::nullopt};
    };
    return {code(nearest - 1), code(nearest + 1), code(nearest)};
}

// Depths of all sizes. What comes back is recorded as the code that is stored so, -1 if none around is: an ulp beside
// the nearest float, a code of 24 bits may lie at its neighbour's.
void record_codes(Random& random, Recorder& out)
{
    for (int i = 0; i < 600; ++i) {
        const float depth = std::exp2(-8 * random.uniform() * random.uniform());
        const DepthFormat format = i % 4 == 0 ? DepthFormat::unorm16 : DepthFormat::unorm24;
        const std::array<Code, 3> codes = codes_around(out, format, depth);
        const float stored = ask<stored_depth>(out, format, depth);
        const auto found = std::ranges::find(codes, stored, &Code::stored);
        out.append("code", found == codes.end() ? -1 : found->number);
    }
}

// The states that matter beside the function: all formats, and in any of them the mask off and the test disabled.
std::vector<DepthState> states(Random& random)
{
    const auto format = [&] { return static_cast<DepthFormat>(random.below(3)); };
    return {{true, DepthFunction::less, true, DepthFormat::float32},
            {true, DepthFunction::less, true, DepthFormat::unorm16},
            {true, DepthFunction::less, true, DepthFormat::unorm24},
            {true, DepthFunction::less, false, format()},
            {false, DepthFunction::less, random.below(2) == 0, format()}};
}

// Codes and what lies between them. 24 bits are wider than a float's steps only below 1/4.
struct Levels {
    DepthFormat format;
    std::uint32_t first;

    [[nodiscard]] float at(double offset) const
    {
        const double last = format == DepthFormat::unorm16 ? 65535 : 16777215;
        return static_cast<float>((first + offset) / last);
    }
};

// One time in four at an end, where depths lie beyond [0, 1] too: next to 0, or next to 1, as in a cleared buffer. (The
// last codes of 24 bits are too close for floats.)
Levels random_levels(Random& random, DepthFormat format)
{
    const std::uint32_t first = 1000 + random.below(format == DepthFormat::unorm16 ? 60'000 : 1'000'000);
    const std::uint32_t end = random.below(8);
    if (end == 0) return {format, 0};
    if (end == 1 && format != DepthFormat::unorm24)
        return {format, format == DepthFormat::unorm16 ? 65'535U : 16'777'215U};
    return {format, first};
}

// A depth within two codes of the first one, never halfway between two.
float random_depth(Random& random, const Levels& levels)
{
    constexpr std::array offsets = {-1.3, -1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0, 1.3};
    return levels.at(offsets[random.below(static_cast<std::uint32_t>(offsets.size()))]);
}

// A buffer of codes that the format has, all close together, so that ties occur: as the unit itself keeps them, since
// the last bit of these floats is free. Floats lie between codes, too.
Grid<float> random_depths(Random& random, Recorder& out, const Levels& levels)
{
    Grid<float> depths(tile_width, tile_height);
    const double beside = levels.format == DepthFormat::float32 ? 0.3 : 0;
    for (float& depth : depths.cells)
        depth = ask<stored_depth>(out, levels.format, levels.at(static_cast<double>(random.below(3)) - 1 + beside));
    return depths;
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

/// One tile of the buffer that is recorded as "depths", which the last `questions` calls led to.
void put(Recorder& out, const Grid<float>& result, Grid<float>& into, int column, int row, unsigned questions = 1)
{
    out.tile("depths", column * tile_width, row * tile_height, tile_width, tile_height, questions);
    const Grid<float> from = of_size(result, tile_width, tile_height);
    for (int y = 0; y < tile_height; ++y)
        for (int x = 0; x < tile_width; ++x) into.at(column * tile_width + x, row * tile_height + y) = from.at(x, y);
}

// All functions in all states: which fragments are left, and what the buffers hold afterwards.
void record_tests(Random& random, Recorder& out, int fragments_each)
{
    const std::vector<DepthState> all = states(random);
    Grid<float> after(functions * tile_width, static_cast<int>(all.size()) * tile_height);
    out.text("left.names", "call");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (int column = 0; column < functions; ++column) {
            DepthState state = all[row];
            state.function = function(column);
            const Levels levels = random_levels(random, state.format);
            Grid<float> depths = random_depths(random, out, levels);
            std::vector<Fragment> fragments = random_fragments(random, levels, fragments_each);
            ask<test_depth>(out, state, fragments, depths);
            put(out, depths, after, column, static_cast<int>(row));
            fragments.resize(std::min<std::size_t>(fragments.size(), static_cast<std::size_t>(fragments_each)));
            const auto scenario = static_cast<float>(row * functions + static_cast<std::size_t>(column));
            for (const auto& [pixel, depth, weights] : fragments)
                out.append("left", std::span<const float>(std::array{scenario, static_cast<float>(pixel.x),
                                                                     static_cast<float>(pixel.y), depth, weights.x}));
        }
    out.buffer("depths", after);
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

// Light, which may be more than a screen shows.
glm::vec3 random_color(Random& random) { return 0.1F + 1.9F * glm::abs(random.in_cube()); }

void record_drawing(Random& random, Recorder& out)
{
    const std::vector<DepthState> all = states(random);
    Grid<float> after(2 * tile_width, static_cast<int>(all.size()) * tile_height);
    out.text("colours.names", "picture");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (const ShadeModel model : {ShadeModel::flat, ShadeModel::smooth}) {
            const int column = model == ShadeModel::flat ? 0 : 1;
            const Levels levels = random_levels(random, all[row].format);
            Layer layer{{tile_width, tile_height}, random_depths(random, out, levels)};
            for (int triangle = 0; triangle < 3; ++triangle) {
                const glm::vec3 a = random_color(random);
                const glm::vec3 b = random_color(random);
                const std::array colors = {a, b, random_color(random)};
                ask<draw_fragments>(out, all[row], model, colors, random_fragments(random, levels, 20), layer);
            }
            record_colors(out, "colours", 2 * row + static_cast<std::size_t>(column), layer);
            put(out, layer.depths, after, column, static_cast<int>(row), 3);
        }
    out.buffer("depths", after);
}

void record_merging(Random& random, Recorder& out)
{
    const std::vector<DepthState> all = states(random);
    Grid<float> after(functions * tile_width, static_cast<int>(all.size()) * tile_height);
    out.text("colours.names", "call");
    for (std::size_t row = 0; row < all.size(); ++row)
        for (int column = 0; column < functions; ++column) {
            DepthState state = all[row];
            state.function = function(column);
            const Levels levels = random_levels(random, state.format);
            const auto layer = [&] {
                Layer result{{tile_width, tile_height}, random_depths(random, out, levels)};
                for (glm::vec3& color : result.colors.cells) color = random_color(random);
                return result;
            };
            const Layer source = layer();
            Layer target = layer();
            ask<merge_layers>(out, state, source, target);
            record_colors(out, "colours", row * functions + static_cast<std::size_t>(column), target);
            put(out, target.depths, after, column, static_cast<int>(row));
        }
    out.buffer("depths", after);
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
    {"functions", [](Case&, Recorder& out) { record_functions(out); }},
    {"formats", [](Case& c, Recorder& out) { record_formats(c.vary, out); }},
    {"codes", [](Case& c, Recorder& out) { record_codes(c.random, out); }},
    {"tests", [](Case& c, Recorder& out) { record_tests(c.random, out, 24); }},
    {"crowds", [](Case& c, Recorder& out) { record_tests(c.random, out, 160); }},
    {"drawing", [](Case& c, Recorder& out) { record_drawing(c.random, out); }},
    {"merging", [](Case& c, Recorder& out) { record_merging(c.random, out); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_rings(out, c.vary)); }},
};

}
