#include <kit/amount.hpp>
#include <kit/varied.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "meshes.hpp"
#include "picture.hpp"
#include "strip_log.hpp"
#include "strip_triangles.hpp"

namespace umbral {
namespace {

using namespace meshes;

void record_grids(Variation& vary, Recorder& out)
{
    // Nothing remains nothing.
    const auto other = [&](std::uint32_t count) {
        return count == 0 ? 0 : vary.one_of(count, std::array{count + 1, count + 2, count + 3});
    };
    StripLog log(out, "strips");
    for (const auto& [written_columns, written_rows] :
         {std::pair{1U, 1U}, {1U, 4U}, {5U, 1U}, {2U, 3U}, {8U, 4U}, {3U, 7U}, {0U, 3U}, {4U, 0U}, {70'000U, 2U}}) {
        const std::uint32_t columns = other(written_columns);
        const std::uint32_t rows = other(written_rows);
        log.begin("grid of " + std::to_string(columns) + " x " + std::to_string(rows) + ": strip, vertex");
        const std::vector<Strip> strips = ask<grid_strips>(out, columns, rows);
        for (std::uint32_t i = 0; i < std::min<std::size_t>(strips.size(), 20); ++i)
            for (std::size_t k = 0; k < std::min<std::size_t>(strips[i].size(), 40); ++k) log.add({i, strips[i][k]});
    }
    log.finish();
}

// Grids without columns, of up to 2^32 - 1 rows, and without rows; each with one that has some, in random order. Who
// asks for memory for rows of nothing gets none, and has no answer.
void record_empty_grids(Random& random, Recorder& out)
{
    const auto record = [&](const glm::uvec2& size) {
        try {
            out.append("counts", static_cast<float>(ask<grid_strips>(out, size.x, size.y).size()));
        } catch (const std::exception& failure) {
            out.refused("counts", failure.what());
            out.append("counts", std::nanf(""));
        }
    };
    for (int i = 0; i < 12; ++i) {
        const std::uint32_t many = i % 6 == 0 ? 0xFFFFFFFFU : 0x40000000U + random.below(0xBFFFFFFFU);
        const std::uint32_t some = 1 + random.below(300);
        const glm::uvec2 empty = i % 3 == 2 ? glm::uvec2(some, 0) : glm::uvec2(0, many);
        const glm::uvec2 whole(1 + random.below(9), 1 + random.below(9));
        const bool first = random.below(2) == 0;
        for (const bool is_empty : {first, !first}) record(is_empty ? empty : whole);
    }
}

void record_decoded(Recorder& out, StripLog& log, const std::string& name, const Strip& strip)
{
    log.begin(name + ": triangle");
    std::vector<glm::uvec3> triangles = ask<triangles_of_strip>(out, strip);
    triangles.resize(std::min(triangles.size(), 2 * strip.size() + 10));
    std::ranges::transform(triangles, triangles.begin(), turned);
    log.add(triangles);
}

/// Varied, the small indices of all strips are so much larger, and the strips come in another order.
void record_known_strips(Variation& vary, Recorder& out)
{
    constexpr std::uint32_t r = restart_index;
    const std::uint32_t shift = vary.one_of(0U, std::array{13U, 29U, 50U});
    std::vector<std::pair<const char*, Strip>> strips = {
        {"one triangle", {4, 7, 5}},
        {"zigzag", {0, 1, 2, 3, 4, 5, 6, 7}},
        {"nothing", {}},
        {"two indices", {3, 8}},
        {"repeated index", {0, 1, 2, 2, 3, 4, 5}},
        {"joined strips", {0, 1, 2, 3, 3, 6, 6, 7, 8, 9}},
        {"joined strips of odd length", {0, 1, 2, 3, 4, 4, 6, 6, 6, 7, 8, 9}},
        {"corner and back", {0, 1, 2, 1, 3, 1, 4}},
        {"restart after an even number", {0, 1, 2, 3, r, 4, 5, 6, 7}},
        {"restart after an odd number", {0, 1, 2, 3, 4, r, 5, 6, 7, 8}},
        {"restarts of no use", {r, r, 0, 1, r, 2, r, 3, 4, 5, 6, r}},
        {"large numbers that are no restarts", {65535, 1, 65536, 2, 0x80000000U, 3, r - 1, 4, 5}}};
    StripLog log(out, "triangles");
    for (auto& [name, strip] : in_random_order(vary, strips)) {
        for (std::uint32_t& index : strip)
            if (index < 1000) index += shift;
        record_decoded(out, log, name, strip);
    }
    log.finish();
}

Strip random_strip(Random& random, std::uint32_t length, std::uint32_t first = 0)
{
    Strip strip;
    for (std::uint32_t i = 0; i < length; ++i) strip.push_back(first + random.below(40));
    for (std::uint32_t i = 1; i < length; ++i)
        if (const std::uint32_t repeats = random.below(8); repeats < 2 && repeats < i)
            strip[i] = strip[i - 1 - repeats];
    return strip;
}

void record_random_strips(Random& random, Recorder& out)
{
    StripLog log(out, "triangles");
    for (int i = 0; i < 20; ++i) {
        Strip strip = random_strip(random, 30, i % 2 * 70'000);
        for (std::uint32_t& index : strip)
            if (random.below(10) == 0) index = restart_index;
        record_decoded(out, log, "random strip", strip);
    }
    log.finish();
}

void record_joined(Random& random, Recorder& out)
{
    StripLog log(out, "indices");
    StripLog drawings(out, "triangles");
    const auto record = [&](const std::string& name, const std::vector<Strip>& strips) {
        log.begin(name + ": index");
        const Strip joined = ask<join_strips>(out, strips);
        for (std::size_t i = 0; i < std::min<std::size_t>(joined.size(), 400); ++i) log.add({joined[i]});
        drawings.begin(name + ": triangle");
        drawings.add(drawn({joined}, 40));
    };
    record("two strips of even length", {{0, 1, 2, 3}, {4, 5, 6, 7}});
    record("two strips of odd length", {{0, 1, 2}, {4, 5, 6, 7, 8}});
    record("strips of one to five indices", {{9}, {0, 1, 2, 3}, {4, 5}, {6, 7, 8}, {}, {1, 3, 5, 7, 9}});
    record("a strip that begins where the last one ended", {{0, 1, 2}, {2, 3, 4}, {4, 5, 6, 7}});
    record("one strip of two indices", {{4, 5}});
    record("none", {});
    // Every second one at large numbers; some strips begin where the last one ended.
    for (int i = 0; i < 20; ++i) {
        std::vector<Strip> strips;
        for (std::uint32_t count = 1 + random.below(6); count > 0; --count) {
            Strip strip = random_strip(random, 2 + random.below(8), i % 2 * 70'000);
            if (!strip.empty() && !strips.empty() && !strips.back().empty() && random.below(3) == 0)
                strip.front() = strips.back().back();
            strips.push_back(strip);
        }
        record("random strips", strips);
    }
    log.finish();
    drawings.finish();
}

void record_strips_of(Recorder& out, const std::vector<Sample>& meshes)
{
    StripLog log(out, "triangles");
    for (const auto& [name, mesh] : meshes) {
        log.begin(std::string(name) + ": triangle");
        log.add(drawn(ask<make_strips>(out, mesh), mesh.triangles.size()));
    }
    log.finish();
}

// Of n triangles, how many the first n indices draw, as the mean of twelve orders: of strips nearly all, of separate
// triangles a third. The meshes' sizes lie so far apart that no one number is near two of them.
void record_long_strips(Random& random, Recorder& out)
{
    for (const auto& [name, mesh] : std::vector<Sample>{{"torus(5, 4)", torus(5, 4)},
                                                        {"trefoil(16, 5, 0.4)", trefoil(16, 5, 0.4)},
                                                        {"torus(20, 20)", torus(20, 20)},
                                                        {"torus(50, 40)", torus(50, 40)}}) {
        std::size_t count = 0;
        const std::size_t faces = mesh.triangles.size();
        const int orders = faces < 1000 ? 12 : 1;
        ask_in_words(out, [&, name = name] {
            return "// how many triangles the first " + std::to_string(faces) + " indices of the strips draw, of " +
                   std::to_string(faces) + "; the mean of " + std::to_string(orders) +
                   " random orders\nmake_strips(shuffled(" + name + ", random))";
        });
        for (int order = 0; order < orders; ++order) {
            const IndexedMesh asked = shuffled(mesh, random);
            count += drawn_at_first(make_strips(IndexedMesh(asked)), asked);
        }
        out.append("triangles", static_cast<float>(count) / static_cast<float>(orders));
    }
}

// How many indices all strips of a mesh have, as the mean of twelve random orders: in a single one, strips without a
// choice may come off badly by chance. One mesh is much larger than the others, so that no one number is near them all.
// The unit gets a copy: what it does to that changes nothing that is counted.
void record_index_counts(Random& random, Recorder& out)
{
    for (const auto& [name, mesh] : std::vector<Sample>{{"torus(10, 7)", torus(10, 7)},
                                                        {"ball(9, 9)", ball(9, 9)},
                                                        {"trefoil(16, 5, 0.4)", trefoil(16, 5, 0.4)},
                                                        {"plate_with_holes(4)", plate_with_holes(4)},
                                                        {"hills(9, 8, random)", hills(9, 8, random)},
                                                        {"tube(8, 5)", tube(8, 5)},
                                                        {"torus(50, 40)", torus(50, 40)}}) {
        std::size_t count = 0;
        bool draw_it = true;
        const int orders = mesh.triangles.size() < 1000 ? 12 : 1;
        ask_in_words(out, [&, name = name, faces = mesh.triangles.size()] {
            return "// all indices of the strips, of " + std::to_string(faces) + " triangles; the mean of " +
                   std::to_string(orders) + " random orders\nmake_strips(shuffled(" + name + ", random))";
        });
        for (int order = 0; order < orders; ++order) {
            const IndexedMesh asked = shuffled(mesh, random);
            const std::vector<Strip> strips = make_strips(IndexedMesh(asked));
            for (const Strip& strip : strips) count += strip.size();
            draw_it = draw_it && draw_all_of(strips, asked);
        }
        // Few indices are worth something where they draw the mesh.
        out.append("indices", draw_it ? static_cast<float>(count) / static_cast<float>(orders) : -1.0F);
    }
}

// Strips of any lengths, empty ones too; and those of problem 2.3, by the driver's own hand.
void record_coordinates(Random& random, Recorder& out)
{
    out.columns("bytes", "coordinates, indexed");
    const auto record = [&](const std::vector<glm::vec3>& positions, const std::vector<Strip>& strips) {
        const StripBytes bytes = ask<strip_bytes>(out, positions.size(), strips);
        out.append("bytes", glm::dvec2(bytes.coordinates, bytes.indexed));
        const std::vector<std::vector<glm::vec3>> got = ask<strips_of_coordinates>(out, positions, strips);
        for (std::size_t i = 0; i < strips.size(); ++i) {
            const std::vector<glm::vec3> strip = i < got.size() ? got[i] : std::vector<glm::vec3>{};
            out.append("lengths", static_cast<float>(strip.size()));
            for (std::size_t k = 0; k < strips[i].size(); ++k)
                out.append("places", k < strip.size() ? strip[k] : glm::vec3(std::nanf("")));
        }
        out.append("lengths", static_cast<float>(got.size()));
    };
    for (const auto& [columns, rows] : {std::pair{8U, 4U}, {1U, 1U}, {3U, 6U}}) {
        std::vector<Strip> strips(rows);
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t i = 0; i < 2 * columns + 2; ++i)
                strips[row].push_back((row + 1 - i % 2) * (columns + 1) + i / 2);
        record(hills(columns, rows, random).positions, strips);
    }
    for (int mesh = 0; mesh < 8; ++mesh) {
        // Every other one has as many positions and strips as the last such one, of other lengths.
        const bool alike = mesh % 2 == 1;
        std::vector<glm::vec3> positions;
        for (std::uint32_t left = alike ? 50 : 40 + random.below(40); left > 0; --left)
            positions.push_back(random.in_cube());
        std::vector<Strip> strips;
        for (std::uint32_t left = alike ? 4 : random.below(6); left > 0; --left)
            strips.push_back(random_strip(random, random.below(12)));
        record(positions, strips);
    }
    // Hardly anything: no vertices, no strips, strips of nothing, of one index, and of the same one. Then the same
    // strips over other positions.
    const glm::vec3 place = random.in_cube();
    record({}, {});
    record({}, {{}, {}});
    record({place}, {{0}, {}});
    for (const glm::vec3& other : {place, 2.0F * place}) record({other}, {{0, 0, 0}, {}});
    record({place, place, {0, 0, 0}}, {{2, 0, 1}, {1, 2}});
    // More vertices than numbers of 32 bits can count.
    for (const std::uint64_t vertices :
         {std::uint64_t{400'000'000}, std::uint64_t{3'000'000'000}, std::uint64_t{1} << 33}) {
        const StripBytes bytes = ask<strip_bytes>(out, vertices, std::vector<Strip>{{0, 1, 2, 3}});
        out.append("bytes", glm::dvec2(bytes.coordinates, bytes.indexed));
    }
}

Amount amount_of(const std::vector<Strip>& strips) { return Amount().in_any_order(triangles_in(strips)); }

void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "triangles");
    for (const std::uint32_t side : {9U, 13U, 18U, 26U, 36U}) {
        const IndexedMesh mesh = shuffled(torus(side, side), random);
        record_cost(out, "blocks", mesh.triangles.size(), [&] { return amount_of(ask<make_strips>(out, mesh)); });
    }
}

}

const Driver driver = {
    {"grid", [](Case& c, Recorder& out) { record_grids(c.vary, out); }},
    {"empty grids", [](Case& c, Recorder& out) { record_empty_grids(c.random, out); }},
    {"decoding", [](Case& c, Recorder& out) { record_known_strips(c.vary, out); }},
    {"decoding at random", [](Case& c, Recorder& out) { record_random_strips(c.random, out); }},
    {"joining", [](Case& c, Recorder& out) { record_joined(c.random, out); }},
    {"known meshes", [](Case& c, Recorder& out) { record_strips_of(out, varied_tame_meshes(c.vary)); }},
    {"larger meshes", [](Case& c, Recorder& out) { record_strips_of(out, larger_meshes(c.random)); }},
    {"long strips", [](Case& c, Recorder& out) { record_long_strips(c.random, out); }},
    {"few strips", [](Case& c, Recorder& out) { record_index_counts(c.random, out); }},
    {"coordinates", [](Case& c, Recorder& out) { record_coordinates(c.random, out); }},
    {"odd meshes", [](Case& c, Recorder& out) { record_strips_of(out, odd_meshes(c.random)); }},
    {"loose triangles", [](Case& c, Recorder& out) { record_strips_of(out, loose_meshes(c.random)); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_strips(out, c.vary)); }},
};

}
