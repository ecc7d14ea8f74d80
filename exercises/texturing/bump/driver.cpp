#include <umbral/record/driver.hpp>

#include "frames.hpp"
#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

struct FlatTriangle {
    std::array<glm::vec3, 3> positions;
    std::array<glm::vec2, 3> coordinates;
};

void record_tangents(Recorder& out, const FlatTriangle& triangle)
{
    const Tangents tangents = ask<triangle_tangents>(out, triangle.positions, triangle.coordinates);
    out.append("tangents", tangents.u);
    out.append("tangents", tangents.v);
}

void record_normal(Recorder& out, const glm::vec3& n, const Tangents& tangents, glm::vec2 slope)
{
    out.append("normals", ask<bumped_normal>(out, n, tangents, slope));
}

// Reds are heights; the other channels say something else.
Grid<glm::vec4> heights_of(int width, int height, const std::vector<float>& heights)
{
    Grid<glm::vec4> texture(width, height, glm::vec4(0, 7, -3, 1));
    for (std::size_t i = 0; i < texture.cells.size(); ++i) texture.cells[i].r = heights[i];
    return texture;
}

// Numbers that a hand can work out. Varied, heights are other whole numbers, and triangles and tangents are turned
// exactly.
void by_hand(Variation& vary, Recorder& out)
{
    const auto heights = [&](int width, int height, std::vector<float> written) {
        for (float& one : written) one += static_cast<float>(vary.near(0, 5));
        return heights_of(width, height, written);
    };
    const auto record_turned = [&](FlatTriangle triangle) {
        const ExactMap map = vary.exact_map(0);
        for (glm::vec3& position : triangle.positions) position = map.place(position);
        record_tangents(out, triangle);
    };
    out.columns("slopes", "d_u, d_v");
    const Grid<glm::vec4> field = heights(4, 2, {0, 1, 3, 0, 2, 0, 1, 4});
    for (const glm::vec2 uv :
         {glm::vec2(0.375F, 0.25F), {0.375F, 0.75F}, {0.125F, 0.25F}, {0.875F, 0.75F}, {0.5F, 0.25F}, {0.625F, 0.5F}})
        for (const float k : {1.0F, -0.5F, 0.0F}) out.append("slopes", ask<slopes>(out, field, uv, k));

    const Grid<glm::vec4> narrow = heights(2, 4, {0, 1, 2, 4, 1, 0, 3, 2});
    for (const glm::vec2 uv : {glm::vec2(0.25F, 0.375F), {0.75F, 0.625F}, {0.5F, 0.125F}})
        out.append("slopes", ask<slopes>(out, narrow, uv, 1));

    std::vector<float> written;
    for (int i = 0; i < 128; ++i) written.push_back(static_cast<float>(i * i % 7));
    const Grid<glm::vec4> wide = heights(128, 1, written);
    const Grid<glm::vec4> tall = heights(1, 128, written);
    for (const float at : {0.00390625F, 0.26953125F, 0.69140625F}) {
        out.append("slopes", ask<slopes>(out, wide, glm::vec2(at, 0.5F), 0.0625F));
        out.append("slopes", ask<slopes>(out, tall, glm::vec2(0.5F, at), 0.0625F));
    }

    record_turned({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0}, {1, 0}, {0, 1}}}});
    record_turned({{{{1, 2, 3}, {3, 2, 3}, {1, 2, 0}}}, {{{0, 0}, {0.5F, 0}, {0, 0.25F}}}});
    record_turned({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0}, {0, 0}, {1, 1}}}});
    record_turned({{{{0, 0, 0}, {2, 0, 1}, {0, 3, 0}}}, {{{0, 0}, {1, 1}, {0, 2}}}});
    // A cell of a fine mesh, 1/512 of the texture wide, and one that is mirrored and finer still.
    constexpr float fine = 1.0F / 512;
    record_turned(
        {{{{1, 0, 2}, {1 + fine, 0, 2}, {1, fine, 2}}}, {{{0.5F, 0.25F}, {0.5F + fine, 0.25F}, {0.5F, 0.25F + fine}}}});
    constexpr float finer = 1.0F / 16384;
    record_turned({{{{0, 0, 0}, {0, 0, 2 * finer}, {0, finer, 0}}}, {{{0, 0}, {-finer, 0}, {0, finer}}}});

    const Tangents flat{{1, 0, 0}, {0, 1, 0}};
    const Tangents skew{{2, 0, 0}, {1, 1, 0}};
    const Tangents mirrored{{-1, 0, 0}, {0, 1, 0}};
    const Tangents leaning{{2, 0, 1}, {0, 1, 0}};
    for (const Tangents& tangents : {flat, skew, mirrored, leaning})
        for (const glm::vec2 slope : {glm::vec2(0, 0), {1, 0}, {0, 1}, {-2, 2}, {0.5F, -1}}) {
            const ExactMap map = vary.exact_map(0);
            record_normal(out, map.place({0, 0, 1}), {map.place(tangents.u), map.place(tangents.v)}, slope);
        }
}

// One in ten is flattened to nothing. Of textures with more than 16 columns or rows k is smaller by the square of that:
// places are rounded by more of their texels, and counts of texels multiply what comes of it.
void random_slopes(Random& random, Recorder& out)
{
    const auto many = [&] { return 65 + static_cast<int>(random.below(500)); };
    const int columns = many();
    const Grid<glm::vec4> fields[] = {random_texture(random, 8, 8),     random_texture(random, 16, 4),
                                      random_texture(random, 5, 9),     random_texture(random, 1, 3),
                                      random_texture(random, 2, 1),     random_texture(random, columns, 2),
                                      random_texture(random, 2, many())};
    out.columns("slopes", "d_u, d_v");
    for (int i = 0; i < 300; ++i) {
        const Grid<glm::vec4>& field = fields[random.below(7)];
        const float u = random.uniform(-1, 2);
        const glm::vec2 uv(u, random.uniform(-1, 2));
        const float texels = std::max(1.0F, static_cast<float>(std::max(field.width, field.height)) / 16);
        const float k = i % 10 == 0 ? 0.0F : random.uniform(-0.2F, 0.2F) / (texels * texels);
        out.append("slopes", ask<slopes>(out, field, uv, k));
    }
}

// At least half a unit of area in the texture, and corners anywhere.
FlatTriangle large_triangle(Random& random)
{
    FlatTriangle triangle;
    for (glm::vec3& position : triangle.positions) position = 2.0F * random.in_cube();
    const float angle = random.uniform(0, 6.28F);
    const float opening = random.uniform(0.6F, 2.5F) * (random.below(2) == 0 ? 1.0F : -1.0F);
    const float u = random.uniform(-2, 2);
    triangle.coordinates[0] = {u, random.uniform(-2, 2)};
    for (std::size_t i = 1; i < 3; ++i) {
        const float turned = angle + (i == 2 ? opening : 0);
        triangle.coordinates[i] =
            triangle.coordinates[0] + random.uniform(1, 2) * glm::vec2(std::cos(turned), std::sin(turned));
    }
    return triangle;
}

// The same triangle of a finer mesh, whose tangents are as long: moved towards its first corner, with steps in the
// texture down to 10^-4, or towards the origin by a power of two, exactly.
FlatTriangle made_smaller(const FlatTriangle& triangle, Random& random)
{
    const bool towards_the_origin = random.below(3) == 0;
    const float size =
        towards_the_origin ? std::exp2(-static_cast<float>(random.below(48))) : std::pow(10.0F, random.uniform(-4, -1));
    FlatTriangle smaller = triangle;
    const glm::vec3 position = towards_the_origin ? glm::vec3(0) : triangle.positions[0];
    const glm::vec2 at = towards_the_origin ? glm::vec2(0) : triangle.coordinates[0];
    for (std::size_t i = 0; i < 3; ++i) {
        smaller.positions[i] = position + size * (triangle.positions[i] - position);
        smaller.coordinates[i] = at + size * (triangle.coordinates[i] - at);
    }
    return smaller;
}

// Half of them large, half those of finer meshes.
FlatTriangle random_triangle(Random& random)
{
    const FlatTriangle triangle = large_triangle(random);
    return random.below(2) == 0 ? triangle : made_smaller(triangle, random);
}

// A triangle as thin in the texture as in space, of powers of two: its tangents are as exact as any.
FlatTriangle sliver(Random& random)
{
    const float thin = std::exp2(-20 - static_cast<float>(random.below(20)));
    const float length = std::exp2(static_cast<float>(random.below(4)) - 2);
    const float turned = random.below(2) == 0 ? 1.0F : -1.0F;
    FlatTriangle triangle{{{{0, 0, 0}, {2, 0, turned}, {2, thin, turned}}}, {{{0, 0}, {length, 0}, {length, thin}}}};
    for (glm::vec2& place : triangle.coordinates)
        if (turned > 0) place = {place.y, place.x};
    return triangle;
}

// Corners on a line, or in one place: in the texture. In space they lie anywhere. Two of eight are small and one is
// thin, but sound; of two the corners lie on a line in space alone, or two or all of them in one place, so that there
// are tangents, which may be parallel or 0.
void degenerate(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        FlatTriangle triangle = large_triangle(random);
        const auto steps = static_cast<float>(random.below(4));
        const auto corner = static_cast<std::size_t>(random.below(3));
        switch (i % 8) {
            case 0: triangle = made_smaller(triangle, random); break;
            case 1: {
                const float size = std::exp2(-16 - static_cast<float>(random.below(32)));
                for (glm::vec3& position : triangle.positions) position *= size;
                for (glm::vec2& place : triangle.coordinates) place *= size;
                break;
            }
            case 2: triangle.positions[2] = 2.0F * triangle.positions[1] - triangle.positions[0]; break;
            case 3:
                triangle.positions[corner] = triangle.positions[(corner + 1) % 3];
                if (i % 40 == 3) triangle.positions = {glm::vec3(1), glm::vec3(1), glm::vec3(1)};
                break;
            case 4: triangle = sliver(random); break;
            case 5: triangle.coordinates.fill(triangle.coordinates[corner]); break;
            default:
                triangle.coordinates = {
                    glm::vec2(1, -1), {1.5F, -0.75F}, glm::vec2(1, -1) + steps * glm::vec2(0.5F, 0.25F)};
        }
        record_tangents(out, triangle);
    }
}

void random_normals(Random& random, Recorder& out, float stretch, bool mirrored)
{
    for (int i = 0; i < 200; ++i) {
        Frame frame = random_frame(random, stretch);
        if (mirrored && random.below(4) != 0) (random.below(2) == 0 ? frame.tangents.u : frame.tangents.v) *= -1.0F;
        const float along_u = random.uniform(-1.5F, 1.5F) * length(frame.tangents.u);
        const glm::vec2 slope(along_u, random.uniform(-1.5F, 1.5F) * length(frame.tangents.v));
        // One in four lies where the relief is level.
        record_normal(out, frame.n, frame.tangents, i % 4 == 1 ? glm::vec2(0) : slope);
    }
}

// No tangents, parallel ones, only one, or some whose plane holds n: the normal stays. Every sixth frame is sound, and
// so are planes that hold n but for little.
void without_tangents(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const Frame frame = random_frame(random, 2);
        const glm::vec2 slope(random.uniform(0.5F, 2), -0.75F);
        const glm::vec3 t(1, 2, -4);
        const Tangents several[] = {{{0, 0, 0}, {0, 0, 0}}, {t, 2.0F * t}, {t, {0, 0, 0}}, {{0, 0, 0}, t}, {t, -t}};
        record_normal(out, frame.n, i % 6 == 5 ? frame.tangents : several[i % 6], slope);
    }
    for (int i = 0; i < 12; ++i) {
        glm::vec3 n(0);
        glm::vec3 side(0);
        n[i % 3] = random.below(2) == 0 ? 1.0F : -1.0F;
        side[(i + 1) % 3] = random.uniform(0.5F, 2);
        const glm::vec3 along = random.uniform(0.5F, 2) * n;
        const Tangents upright = i % 2 == 0 ? Tangents{side, along} : Tangents{along, side};
        record_normal(out, n, upright, {random.uniform(0.5F, 2), -0.75F});
        // Hardly less upright: n has a side.
        glm::vec3 leaning = along;
        leaning[(i + 2) % 3] = (random.below(2) == 0 ? 1.0F : -1.0F) * std::exp2(-18 - static_cast<float>(i));
        const glm::vec2 slope(random.uniform(0.5F, 2), 0.75F);
        record_normal(out, n, i % 2 == 0 ? Tangents{side, leaning} : Tangents{leaning, side}, slope);
    }
}

// Triangles of molecules and of planets: products of tangents overflow or vanish in float. And relief that is up to
// 10^6 times as steep as its tangents are long.
void extreme(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        Frame frame = random_frame(random, 2);
        const float size = std::pow(10.0F, i % 2 == 0 ? random.uniform(21, 30) : random.uniform(-30, -22));
        const glm::vec2 slope(random.uniform(-1, 1), random.uniform(-1, 1));
        frame.tangents.u *= size;
        frame.tangents.v *= size;
        record_normal(out, frame.n, frame.tangents, size * slope);
    }
    for (int i = 0; i < 60; ++i) {
        Frame frame = random_frame(random, 2);
        const float size = std::pow(10.0F, random.uniform(-5.5F, -3));
        const float slope = random.below(2) == 0 ? 1.0F : -1.0F;
        frame.tangents.u *= size;
        frame.tangents.v *= size;
        record_normal(out, frame.n, frame.tangents, {slope, random.uniform(-1, 1)});
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"fields", [](Case& c, Recorder& out) { random_slopes(c.random, out); }},
    {"triangles",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 200; ++i) record_tangents(out, random_triangle(c.random));
     }},
    {"degenerate", [](Case& c, Recorder& out) { degenerate(c.random, out); }},
    {"skew", [](Case& c, Recorder& out) { random_normals(c.random, out, 10, false); }},
    {"mirrored", [](Case& c, Recorder& out) { random_normals(c.random, out, 3, true); }},
    {"no tangents", [](Case& c, Recorder& out) { without_tangents(c.random, out); }},
    {"extreme", [](Case& c, Recorder& out) { extreme(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(out, 400, 300, c.vary)); }},
};

}
