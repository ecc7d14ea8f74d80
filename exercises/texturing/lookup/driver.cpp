#include <algorithm>
#include <kit/refusal.hpp>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <utility>

#include "extreme_places.hpp"
#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

using Textures = std::vector<Grid<glm::vec4>>;

// All textures lie at one place in memory when they are asked for, whatever their sizes, so that who keeps something of
// a texture, and knows it by its address, keeps what belongs to another.
void record(Recorder& out, const Textures& textures, const std::vector<Query>& queries)
{
    Grid<glm::vec4> asked = *std::ranges::max_element(textures, {}, [](const auto& each) { return each.cells.size(); });
    std::size_t held = textures.size();
    for (const Query& query : queries) {
        if (query.texture != held) asked = textures[held = query.texture];
        out.append("colours", ask<lookup>(out, asked, query.sampler, query.uv));
    }
}

// Red, green / blue, white as one sees it: row 0 is the top one. Beside it, four greys in a row.
// Varied, each channel of each texel is darker or brighter by eighths.
Textures small_textures(Variation& vary)
{
    Grid<glm::vec4> four(2, 2);
    four.cells = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    Grid<glm::vec4> row(4, 1);
    row.cells = {glm::vec4(0), glm::vec4(0.25F), glm::vec4(0.5F), glm::vec4(1)};
    for (Grid<glm::vec4>* const texture : {&four, &row})
        for (glm::vec4& texel : texture->cells) texel += glm::vec4(vary.near(glm::ivec4(0), 6)) / 8.0F;
    return {four, row};
}

// Numbers that a student can work out by hand: each corner's texel, the centres, the middle, points between centres.
void by_hand(Variation& vary, Recorder& out)
{
    std::vector<Query> queries;
    for (const Filter filter : both_filters) {
        const Sampler clamped{filter, Wrap::clamp_to_edge, Wrap::clamp_to_edge};
        for (const glm::vec2 uv : {glm::vec2(0.25F, 0.25F),
                                   {0.75F, 0.25F},
                                   {0.25F, 0.75F},
                                   {0.75F, 0.75F},
                                   {0.375F, 0.25F},
                                   {0.25F, 0.625F},
                                   {0.625F, 0.4375F}})
            queries.push_back({0, clamped, uv});
        for (const float u : {0.125F, 0.375F, 0.625F, 0.875F, 0.4375F, 0.3125F, 0.8125F})
            queries.push_back({1, clamped, {u, 0.5F}});
    }
    record(out, small_textures(vary), queries);
}

// From -1 to 2: light has no upper bound, and normals and heights have both signs. Textures may hold all of these.
Grid<glm::vec4> any_numbers(Grid<glm::vec4> texture)
{
    for (glm::vec4& texel : texture.cells) texel = 3.0F * texel - 1.0F;
    return texture;
}

// Away from borders by 2 % of a texel, so that no rounding decides; far enough inside for no neighbour to be wrapped.
// Two textures have the same size, so that a copy of one, kept by its size, shows when the other is asked for.
void random_inside(Random& random, Recorder& out, Filter filter)
{
    const Textures textures = {random_texture(random, 8, 8), random_texture(random, 16, 4),
                               any_numbers(random_texture(random, 5, 7)), random_texture(random, 8, 8)};
    std::vector<Query> queries;
    for (int i = 0; i < 600; ++i) {
        const std::size_t texture = random.below(4);
        const auto [width, height] = std::pair(textures[texture].width, textures[texture].height);
        const Sampler sampler{filter, random_wrap(random), random_wrap(random)};
        const auto coordinate = [&](int count) {
            const int kept = filter == Filter::nearest ? count : count - 1;
            const double shift = filter == Filter::nearest ? 0 : 0.5;
            const std::uint32_t texel = random.below(static_cast<std::uint32_t>(kept));
            return static_cast<float>((texel + shift + 0.02 + 0.96 * random.uniform_double()) / count);
        };
        const float u = coordinate(width);
        queries.push_back({texture, sampler, {u, coordinate(height)}});
    }
    record(out, textures, queries);
}

// Up to three times round in both directions. The last texture has the first one's size: see random_inside. After
// every ten questions they are painted over, so that a copy shows which was made of a texture earlier.
void outside(Random& random, Recorder& out, Wrap wrap)
{
    Textures textures = {random_texture(random, 8, 8), any_numbers(random_texture(random, 6, 10)),
                         random_texture(random, 8, 8)};
    std::vector<Query> queries;
    for (int i = 0; i < 300; ++i) {
        if (i % 10 == 9) {
            record(out, textures, std::exchange(queries, {}));
            for (Grid<glm::vec4>& texture : textures)
                for (glm::vec4& texel : texture.cells) texel = glm::vec4(texel.y, texel.z, texel.w, texel.x);
        }
        const std::size_t texture = random.below(3);
        const Sampler sampler{both_filters[random.below(2)], wrap, wrap};
        const auto coordinate = [&](int count) { return inside_texel(random, count, 3); };
        const float u = coordinate(textures[texture].width);
        queries.push_back({texture, sampler, {u, coordinate(textures[texture].height)}});
    }
    record(out, textures, queries);
}

// Exactly on borders between texels, and on those of the texture, once round to both sides: sizes are powers of two, so
// that these are floats.
void on_borders(Random& random, Recorder& out)
{
    const Textures textures = {random_texture(random, 8, 4)};
    std::vector<Query> queries;
    for (int i = -8; i <= 8; ++i)
        for (int j = -4; j <= 4; ++j)
            for (const Wrap wrap : both_wraps)
                queries.push_back({0,
                                   {both_filters[random.below(2)], wrap, wrap},
                                   {static_cast<float>(i) / 8, static_cast<float>(j) / 4}});
    record(out, textures, queries);
}

// Half a texel to both sides of the seams, with each pair of wraps: a blend of the last texel and the first, or of the
// last one with itself.
void across_seams(Random& random, Recorder& out)
{
    const Textures textures = {random_texture(random, 8, 8), random_texture(random, 3, 5)};
    std::vector<Query> queries;
    for (int i = 0; i < 400; ++i) {
        const std::size_t texture = random.below(2);
        const Sampler sampler{Filter::bilinear, random_wrap(random), random_wrap(random)};
        const auto count = glm::vec2(textures[texture].width, textures[texture].height);
        glm::vec2 uv(random.uniform(), random.uniform());
        const auto across = static_cast<int>(random.below(3));  // u, v, or a corner
        for (int axis = 0; axis < 2; ++axis) {
            const float seam = static_cast<float>(random.below(2)) + random.uniform(-0.48F, 0.48F) / count[axis];
            if (across == axis || across == 2) uv[axis] = seam;
        }
        queries.push_back({texture, sampler, uv});
    }
    record(out, textures, queries);
}

// One texel, one row, one column: everything is its own neighbour. And two texels, of which each is the other's, on
// both sides where they repeat.
void thin(Random& random, Recorder& out)
{
    const Textures textures = {random_texture(random, 1, 1), random_texture(random, 7, 1),
                               random_texture(random, 1, 3), random_texture(random, 2, 1),
                               random_texture(random, 1, 2), random_texture(random, 2, 2)};
    std::vector<Query> queries;
    for (int i = 0; i < 300; ++i) {
        const Sampler sampler{both_filters[random.below(2)], random_wrap(random), random_wrap(random)};
        const std::size_t texture = random.below(6);
        const auto coordinate = [&](int count) { return inside_texel(random, count, 2); };
        const float u = coordinate(textures[texture].width);
        queries.push_back({texture, sampler, {u, coordinate(textures[texture].height)}});
    }
    record(out, textures, queries);
}

// NaN is 0, in either coordinate or in both; infinity too with repeat, and the edge otherwise.
void not_numbers(Random& random, Recorder& out)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Textures textures = {random_texture(random, 4, 4)};
    std::vector<Query> queries;
    for (const float strange : {nan, infinity, -infinity})
        for (const Filter filter : both_filters)
            for (const Wrap wrap_u : both_wraps)
                for (const Wrap wrap_v : both_wraps)
                    for (const glm::vec2 uv : {glm::vec2(strange, 0.65F), {0.65F, strange}, {strange, strange}})
                        queries.push_back({0, {filter, wrap_u, wrap_v}, uv});
    record(out, textures, queries);
}

// Textures without a texel, and with some.
void without_texels(Random& random, Recorder& out)
{
    for (const glm::ivec2 size : {glm::ivec2(0, 0), {0, 5}, {5, 0}, {0, 1}, {1, 0}, {0, 0}}) {
        const Sampler sampler{both_filters[random.below(2)], random_wrap(random), random_wrap(random)};
        const bool empty_first = random.below(2) == 0;
        const float u = random.uniform();
        const glm::vec2 uv(u, random.uniform());
        for (const bool empty : {empty_first, !empty_first})
            record_refusal(out, "refused", [&] {
                return ask<lookup>(out, Grid<glm::vec4>(empty ? size.x : 5, empty ? size.y : 2), sampler, uv);
            });
    }
}

// More rows and columns than a byte can count.
Textures wide_textures(Random& random) { return {random_texture(random, 256, 256), random_texture(random, 300, 270)}; }

// Sizes that are no powers of two, where u * n rounds onto the border; of so many texels, too, that the floats beside
// borders are few. And the longest row, whose size is a power of two.
void beside_borders(Random& random, Recorder& out)
{
    const auto many = [&] { return 9001 + 2 * static_cast<int>(random.below(3500)); };
    const int columns = many();
    const int rows = many();
    const Textures textures = {random_texture(random, 100, 100), random_texture(random, columns, 1),
                               random_texture(random, 1, rows), random_texture(random, 16384, 1)};
    std::vector<Query> queries = border_places(random, {100, columns, rows});
    const std::vector<Query> more = long_row_places(random, 3);
    queries.insert(queries.end(), more.begin(), more.end());
    record(out, textures, queries);
}

// A texture that repeats, and the same one with its texels moved on cyclically by 3 columns and 2 rows: 8 x 8 texels, 8
// pixels a texel, one and a half times round. Coordinates are exact.
void record_cycled(Random& random, Recorder& out)
{
    const Grid<glm::vec4> still = random_texture(random, 8, 8);
    Grid<glm::vec4> moved(8, 8);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column) moved.at((column + 3) % 8, (row + 2) % 8) = still.at(column, row);
    const auto painted = [&](const Grid<glm::vec4>& texture) {
        Grid<glm::vec3> picture(96, 96);
        for (int y = 0; y < 96; ++y)
            for (int x = 0; x < 96; ++x) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5F) / 64, 1.25F - (static_cast<float>(y) + 0.5F) / 64);
                picture.at(x, y) =
                    glm::vec3(ask<lookup>(out, texture, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, uv));
            }
        return picture;
    };
    out.image("still", painted(still));
    out.image("cycled", painted(moved));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"nearest", [](Case& c, Recorder& out) { random_inside(c.random, out, Filter::nearest); }},
    {"bilinear", [](Case& c, Recorder& out) { random_inside(c.random, out, Filter::bilinear); }},
    {"repeat", [](Case& c, Recorder& out) { outside(c.random, out, Wrap::repeat); }},
    {"clamp", [](Case& c, Recorder& out) { outside(c.random, out, Wrap::clamp_to_edge); }},
    {"on borders", [](Case& c, Recorder& out) { on_borders(c.random, out); }},
    {"seams", [](Case& c, Recorder& out) { across_seams(c.random, out); }},
    {"thin", [](Case& c, Recorder& out) { thin(c.random, out); }},
    {"not numbers", [](Case& c, Recorder& out) { not_numbers(c.random, out); }},
    {"no texel", [](Case& c, Recorder& out) { without_texels(c.random, out); }},
    {"far out",
     [](Case& c, Recorder& out) {
         const Textures textures = wide_textures(c.random);
         record(out, textures, far_repeats(c.random));
     }},
    {"far clamped",
     [](Case& c, Recorder& out) {
         const Textures textures = wide_textures(c.random);
         record(out, textures, far_clamps(c.random));
     }},
    {"beside borders", [](Case& c, Recorder& out) { beside_borders(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_cycled(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(out, 480, 320, c.vary)); }},
};

}
