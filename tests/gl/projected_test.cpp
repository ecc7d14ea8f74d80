#include <cmath>
#include <fstream>
#include <iterator>
#include <kit/color.hpp>

#include "fixture.hpp"
#include "texturing/projected/points.hpp"

// The unit texturing/projected: its reference against the statement's formula in double, with a lookup of its own.
namespace umbral::texturing {
namespace {

std::string text_of(const char* name)
{
    std::ifstream file(std::string(UMBRAL_PROJECTED_REFERENCE) + "/" + name);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Case reference()
{
    return {"test",
            Random(1),
            {{"projected.vert", text_of("projected.vert")}, {"projected.frag", text_of("projected.frag")}}};
}

/// The blend of four texels of a slide that is repeated, each rounded to a byte and decoded.
glm::dvec3 expected_slide(const Grid<glm::vec4>& slide, glm::dvec2 st)
{
    const glm::dvec2 place = st * glm::dvec2(slide.width, slide.height) - 0.5;
    const glm::dvec2 corner = floor(place);
    const auto texel = [&](int right, int up) {
        const auto wrapped = [](int i, int count) { return ((i % count) + count) % count; };
        const int column = wrapped(static_cast<int>(corner.x) + right, slide.width);
        const int row = slide.height - 1 - wrapped(static_cast<int>(corner.y) + up, slide.height);
        return srgb_decoded(glm::dvec3(pixel_of(glm::dvec3(slide.at(column, row)))) / 255.0);
    };
    const glm::dvec2 t = place - corner;
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y);
}

glm::dvec3 expected_color(const Point& point, const Grid<glm::vec4>& slide)
{
    const Projector& projector = point.projector;
    const glm::dvec3 p(point.place);
    const glm::dvec4 q = glm::dmat4(projector.projection) * glm::dmat4(projector.view) * glm::dvec4(p, 1);
    glm::dvec3 light(projector.ambient);
    if (q.w > 0 && std::abs(q.x) <= q.w && std::abs(q.y) <= q.w) {
        const glm::dvec3 l = normalize(glm::dvec3(projector.position) - p);
        const double cosine = std::max(0.0, dot(normalize(glm::dvec3(point.normal)), l));
        light += cosine * glm::dvec3(projector.lamp) * expected_slide(slide, 0.5 * glm::dvec2(q) / q.w + 0.5);
    }
    return srgb_encoded(glm::dvec3(point.color) * light);
}

void expect_formula(const std::vector<Point>& points, const Grid<glm::vec4>& slide)
{
    const Slide bound(slide);
    const std::vector<glm::vec3> colors = colors_of(points, *compile(reference()));
    ASSERT_EQ(colors.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(colors[i][c], expected_color(points[i], slide)[c], 0.006) << "point " << i << ", channel " << c;
}

using Projected = gl::GlTest;

TEST_F(Projected, reference_is_the_formula_at_the_edges)
{
    Random random(6101);
    const Grid<glm::vec4> slide = random_texture(random, 4, 3);
    expect_formula(edges(random), slide);
}

TEST_F(Projected, reference_is_the_formula_at_random_points)
{
    for (const std::uint64_t seed : {6102U, 6103U, 6104U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Grid<glm::vec4> slide = random_texture(random, 4, 3);
        expect_formula(random_points(random, 300), slide);
    }
}

// The worked numbers of the statement: (s, t) = (0.75, 0.625) before the projector, and no light behind it.
TEST_F(Projected, worked_numbers_of_the_statement)
{
    Grid<glm::vec4> slide(4, 4, glm::vec4(0, 0, 0, 1));
    slide.at(2, 1) = slide.at(3, 1) = glm::vec4(1);  // both sides of s = 0.75, and t = 0.625 in the middle
    Point point;
    point.projector = projector_at({0, 0, 0}, {0, 0, -1}, 90);
    point.projector.ambient = glm::vec3(0);
    point.place = {1, 0.5F, -2};
    point.normal = normalize(-point.place);
    Point behind = point;
    behind.place = -point.place;
    behind.normal = normalize(-behind.place);
    const Slide bound(slide);
    const std::vector<glm::vec3> colors = colors_of({point, behind}, *compile(reference()));
    EXPECT_EQ(colors[0], glm::vec3(1));
    EXPECT_EQ(colors[1], glm::vec3(0));
}

}
}
