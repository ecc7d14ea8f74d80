#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <utility>

#include "../support.hpp"
#include "slanted_paper.hpp"

namespace umbral {
namespace {

using namespace transforms;

glm::mat3 cartesian(Random& random)
{
    const AxisAngle turn = random_turn(random);
    return glm::mat3(glm::rotate(glm::mat4(1), turn.angle, turn.axis));
}

/// Vectors of lengths 0.5 to 2, each leaning by less than half of it; left-handed half of the time.
glm::mat3 oblique(Random& random)
{
    glm::mat3 basis = cartesian(random);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 lean = 0.25F * random.in_cube();
        basis[i] = random.uniform(0.5F, 2) * (basis[i] + lean);
    }
    if (random.below(2) == 1) std::swap(basis[0], basis[1]);
    return basis;
}

glm::vec3 some_vector(Random& random) { return random.uniform(0.5F, 4) * random.unit_vector(); }

// Judged here is what is made of the Gram matrix, whoever made it: so it is computed by the driver.
glm::mat3 gram_of(const glm::mat3& basis) { return glm::mat3(glm::transpose(glm::dmat3(basis)) * glm::dmat3(basis)); }

void record(Recorder& out, const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    out.append("gram", ask<gram_matrix>(out, basis));
    out.append("dot", ask<dot_from_gram>(out, gram_of(basis), a, b));
    out.append("area", ask<area_from_gram>(out, gram_of(basis), a, b));
    out.append("cross", ask<cross_in_basis>(out, basis, a, b));
}

// Bases and vectors whose products a hand can work out.
void record_known(Variation& vary, Recorder& out)
{
    const glm::mat3 bases[] = {glm::mat3(1),
                               {{2, 0, 0}, {0, 3, 0}, {0, 0, 1}},
                               {{1, 0, 0}, {1, 1, 0}, {0, 0, 1}},
                               {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                               {{1, 0, 0}, {1, 2, 0}, {0, 1, -1}}};
    glm::vec3 vectors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 2}, {-1, 0, 3}};
    for (glm::vec3& vector : vectors) vector = by_quarters(vary, vector);
    const glm::vec3 slanted = vectors[3];
    for (glm::mat3 basis : bases) {
        if (basis != glm::mat3(1))
            for (int i = 0; i < 3; ++i) basis[i] *= vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.25F, 1.5F});
        for (std::size_t i = 0; i < std::size(vectors); ++i)
            record(out, basis, vectors[i], vectors[(i + 1) % std::size(vectors)]);
        // Parallel ones, and null vectors.
        record(out, basis, slanted, -2.0F * slanted);
        record(out, basis, {0, 0, 0}, slanted);
        record(out, basis, slanted, {0, 0, 0});
    }
    const glm::ivec3 whole[][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                   {{1, 2, 3}, {0, 1, 4}, {5, 6, 0}},
                                   {{2, -1, 0}, {3, 3, -2}, {1, 0, 7}}};
    for (const auto& [a, b, c] : whole)
        out.append("volume", static_cast<double>(ask<triple_product>(out, vary.near(a, 2), vary.near(b, 2), c)));
}

// Cartesian frames, each with its image in a mirror, in random order: problems 1.8 and 1.9. Dot products are the same
// in both; the coordinates of cross products are opposite.
void record_both_hands(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const glm::mat3 right = cartesian(random);
        glm::mat3 left = right;
        left[i % 3] = -left[i % 3];
        const glm::vec3 a = some_vector(random);
        const glm::vec3 b = some_vector(random);
        const bool left_first = random.below(2) == 1;
        for (const bool is_left : {left_first, !left_first}) {
            const glm::mat3& basis = is_left ? left : right;
            out.append("dot", ask<dot_from_gram>(out, gram_of(basis), a, b));
            out.append("cross", ask<cross_in_basis>(out, basis, a, b));
        }
    }
}

/// A question in which single numbers can change: those of matrices stay.
struct Couple {
    glm::vec3 e0;
    glm::vec3 e1;
    glm::vec3 e2;
    glm::vec3 a;
    glm::vec3 b;
};

/// As random ones are: no longer, the basis no flatter, and the vectors not nearly parallel.
bool is_clear(const Couple& couple)
{
    const auto& [e0, e1, e2, a, b] = couple;
    const auto is_usual = [](const glm::vec3& v, float most) { return length(v) > 0.4F && length(v) < most; };
    if (!is_usual(e0, 2.5F) || !is_usual(e1, 2.5F) || !is_usual(e2, 2.5F)) return false;
    if (!is_usual(a, 4) || !is_usual(b, 4)) return false;
    const glm::mat3 basis(e0, e1, e2);
    const glm::vec3 one = basis * a;
    const glm::vec3 other = basis * b;
    return std::abs(dot(cross(e0, e1), e2)) > 0.3F * length(e0) * length(e1) * length(e2) &&
           length(cross(one, other)) > 0.2F * length(one) * length(other);
}

// Chains of questions in which one number changes, so that it is 0, equal to another, or its vector the only one that
// differs from the call before.
void record_changed(Random& random, Recorder& out)
{
    const glm::mat3 basis = oblique(random);
    const glm::vec3 a = some_vector(random);
    const glm::vec3 aside = length(a) * normalize(cross(a, random.unit_vector()));
    const Couple couple{basis[0], basis[1], basis[2], a, aside + random.uniform(-0.5F, 0.5F) * a};
    for (const auto& [e0, e1, e2, one, other] : numbers_changed(random, couple, 8, is_clear))
        record(out, glm::mat3(e0, e1, e2), one, other);
    out.append("dot", ask<dot_from_gram>(out, gram_of(basis), a, a));
}

void record_random(Random& random, Recorder& out)
{
    glm::mat3 basis;
    for (int i = 0; i < 150; ++i) {
        // Now and then only the last vector is another one than before.
        if (i % 3 == 2)
            basis[2] = -basis[2];
        else
            basis = oblique(random);
        const glm::vec3 a = some_vector(random);
        record(out, basis, a, some_vector(random));
        if (i % 5 == 1) record_changed(random, out);
    }
}

/// From -2^19 to 2^19, with all digits: differences of two stay within the interface's range.
glm::ivec3 large_whole(Random& random)
{
    const auto component = [&] { return static_cast<int>(random.below((1U << 20U) + 1)) - (1 << 19); };
    const int x = component();
    const int y = component();
    return {x, y, component()};
}

// Pairs of a vector in the plane of a and b, that is a, b or a - b, and one beside it: a step beside, or anywhere; in
// random order. The last six digits are recorded by themselves: a sum of 60 bits is no double.
void record_exact(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        glm::ivec3 a = large_whole(random);
        glm::ivec3 b = large_whole(random);
        // Two times in five one of them is without one of its components.
        if (i % 5 < 2) (i % 5 == 0 ? a : b)[i / 5 % 3] = 0;
        const glm::ivec3 in_plane = i % 3 == 0 ? a : i % 3 == 1 ? b : a - b;
        glm::ivec3 beside = large_whole(random);
        if (i % 2 == 0) {
            beside = in_plane;
            beside[i / 2 % 3] += beside[i / 2 % 3] > 0 ? -1 : 1;
        }
        const bool beside_first = random.below(2) == 1;
        for (const bool is_beside : {beside_first, !beside_first}) {
            const glm::ivec3& c = is_beside ? beside : in_plane;
            // The pair differs in its last vector alone, its first, or its middle one.
            const std::int64_t volume = i % 4 < 2    ? ask<triple_product>(out, a, b, c)
                                        : i % 3 == 1 ? ask<triple_product>(out, a, c, b)
                                                     : ask<triple_product>(out, c, a, b);
            out.append("volume", static_cast<double>(volume));
            out.append("digits", static_cast<std::int32_t>(volume % 1'000'000));
        }
    }
}

// Angles of 0.1 down to 1e-6 radians, in oblique bases.
void record_nearly_parallel(Random& random, Recorder& out)
{
    for (const float apart : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        for (int i = 0; i < 15; ++i) {
            const glm::mat3 basis = oblique(random);
            const glm::vec3 a = some_vector(random);
            const glm::vec3 b = random.uniform(0.5F, 2) * a + apart * random.unit_vector();
            out.append("area", ask<area_from_gram>(out, gram_of(basis), a, b));
            out.append("cross", ask<cross_in_basis>(out, basis, a, b));
        }
    }
}

// Bases that are Cartesian but for a thousandth or less, and vectors at nearly right angles: entries and products are
// small beside their terms, and each counts by itself.
void record_nearly_perpendicular(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        glm::mat3 basis = cartesian(random);
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 lean = std::pow(10.0F, random.uniform(-4, -3)) * random.in_cube();
            basis[k] = random.uniform(0.5F, 2) * (basis[k] + lean);
        }
        const glm::mat3 gram = ask<gram_matrix>(out, basis);
        const int row = static_cast<int>(random.below(3));
        out.append("gram aside", gram[(row + 1) % 3][row]);
        out.append("gram aside", gram[(row + 2) % 3][row]);
        // At right angles in an oblique basis, up to a thousandth.
        const glm::mat3 slanted = gram_of(oblique(random));
        const glm::vec3 a = some_vector(random);
        const glm::vec3 across = glm::normalize(glm::cross(slanted * a, random.unit_vector()));
        const glm::vec3 b = random.uniform(0.5F, 4) * (across + random.uniform(2e-4F, 2e-3F) * glm::normalize(a));
        out.append("dot", ask<dot_from_gram>(out, slanted, a, b));
    }
}

// Bases that are squashed to a twentieth or a thirtieth along one direction, and areas in planes that hold it: their
// Gram matrices have eigenvalues several hundred times others.
void record_squashed(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const glm::mat3 turned = cartesian(random);
        const glm::vec3 along = random.unit_vector();
        const float rest = random.uniform(0.033F, 0.05F);
        const glm::mat3 squash = glm::mat3(1) - (1 - rest) * glm::outerProduct(along, along);
        const glm::mat3 basis = squash * turned;
        const glm::vec3 a = random.uniform(0.5F, 2) * (glm::transpose(turned) * along);
        const glm::vec3 b = some_vector(random);
        out.append("area", ask<area_from_gram>(out, gram_of(basis), a, b));
        out.append("cross", ask<cross_in_basis>(out, basis, a, b));
    }
}

// Bases of micrometres and of thousands of kilometres: areas that are floats, of squares that are not.
void record_all_units(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float unit = std::pow(10.0F, random.uniform(-7, 7));
        const glm::mat3 basis = unit * oblique(random);
        const float length = std::pow(10.0F, random.uniform(-6, 6));
        const glm::vec3 a = length * some_vector(random);
        record(out, basis, a, length * some_vector(random));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"both hands", [](Case& c, Recorder& out) { record_both_hands(c.random, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"exact", [](Case& c, Recorder& out) { record_exact(c.random, out); }},
    {"nearly parallel", [](Case& c, Recorder& out) { record_nearly_parallel(c.random, out); }},
    {"nearly perpendicular", [](Case& c, Recorder& out) { record_nearly_perpendicular(c.random, out); }},
    {"squashed", [](Case& c, Recorder& out) { record_squashed(c.random, out); }},
    {"all units", [](Case& c, Recorder& out) { record_all_units(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("paper", draw_slanted_paper(c.vary, out)); }},
};

}
