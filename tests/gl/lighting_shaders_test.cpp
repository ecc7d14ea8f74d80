#include <cmath>
#include <fstream>
#include <iterator>
#include <umbral/core/student_error.hpp>

#include "fixture.hpp"
#include "lighting/shaders/probes.hpp"

// The unit lighting/shaders: its reference against the model in double, its shapes, and what its driver refuses.
namespace umbral::lighting {
namespace {

std::string text_of(const std::string& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Case case_with(const std::string& folder)
{
    return {"test",
            Random(1),
            {{"phong.vert", text_of(folder + "/phong.vert")}, {"phong.frag", text_of(folder + "/phong.frag")}}};
}
Case reference() { return case_with(UMBRAL_SHADERS_REFERENCE); }

/// The statement's model, in double: smooth shading, seen from the front.
glm::dvec3 expected_color(const Probe& probe)
{
    const Material& material = probe.material;
    const glm::dvec3 n = normalize(glm::dvec3(probe.normal));
    const glm::dvec3 v = normalize(-glm::dvec3(probe.position));
    glm::dvec3 color = glm::dvec3(material.emission) + glm::dvec3(probe.global_ambient) * glm::dvec3(material.ambient);
    for (const Light& light : probe.lights) {
        const glm::dvec3 place(light.position);
        const glm::dvec3 l = normalize(light.position.w == 0 ? place : place - glm::dvec3(probe.position));
        glm::dvec3 reflected = material.ambient;
        if (dot(n, l) > 0) {
            reflected += glm::dvec3(material.diffuse) * dot(n, l);
            const glm::dvec3 sum = l + v;
            const double cosine = length(sum) > 0 ? std::max(0.0, dot(n, normalize(sum))) : 0;
            const double power =
                length(sum) > 0 ? std::pow(cosine, double{material.shininess}) : 0;  // std::pow(0, 0) is 1
            reflected += glm::dvec3(material.specular) * power;
        }
        color += glm::dvec3(light.color) * reflected;
    }
    return clamp(color, 0.0, 1.0);
}

void expect_model(const std::vector<Probe>& probes, const gl::Program& program)
{
    const std::vector<glm::vec3> colors = colors_of(probes, program);
    ASSERT_EQ(colors.size(), probes.size());
    for (std::size_t i = 0; i < probes.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(colors[i][c], expected_color(probes[i])[c], 0.51 / 255) << "probe " << i << ", channel " << c;
}

using LightingShaders = gl::GlTest;

TEST_F(LightingShaders, reference_is_the_model_at_the_edges) { expect_model(edges(), *compile(reference())); }

TEST_F(LightingShaders, reference_is_the_model_at_random_points)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        expect_model(random_points(random), *compile(reference()));
    }
}

// The worked number of the statement: 0.02 + 0.1 + 0.5 · 0.8 + 0.4 · 0.9² = 0.844.
TEST_F(LightingShaders, worked_number_of_the_statement)
{
    const Material material{glm::vec3(0), glm::vec3(0.1F), glm::vec3(0.5F), glm::vec3(0.4F), 4};
    const Probe probe{{0, 0, -5}, {0, 0, 1}, material, {{{0, 0.6F, 0.8F, 0}, glm::vec3(1)}}, glm::vec3(0.2F)};
    EXPECT_EQ(colors_of({probe}, *compile(reference())).front(), glm::vec3(215.0F / 255));
}

// Inside a bowl, flat and smooth shading look at the same side of the surface: with fine facets they are nearly one
// picture.
TEST_F(LightingShaders, flat_and_smooth_agree_on_fine_meshes_seen_from_inside)
{
    Scene scene = bowls(false);
    scene.things = {{sphere(256, 128, 0.1F), placed({0, 0, 0}, glm::vec3(0.9F), 0.7F, {1, 0, 0}),
                     plastic(glm::vec3(0.6F), 0.3F, 8)}};
    const auto program = compile(reference());
    const Image smooth = draw(scene, *program);
    scene.flat = true;
    const Image flat = draw(scene, *program);
    int far = 0;
    for (std::size_t i = 0; i < smooth.cells.size(); ++i)
        far += std::abs(smooth.cells[i].r - flat.cells[i].r) > 6 ? 1 : 0;
    EXPECT_LT(far, 200);  // of 65,536: the border of light and shadow, and the silhouette
    EXPECT_GT(smooth.at(128, 128).r, 60);
}

TEST_F(LightingShaders, stub_compiles_and_fits_the_interface)
{
    EXPECT_NO_THROW((void)compile(case_with(UMBRAL_SHADERS_UNIT)));
}

TEST_F(LightingShaders, driver_refuses_other_types_by_name)
{
    Case what = reference();
    std::string& text = what.sources["phong.frag"];
    text.replace(text.find("uniform float shininess"), 23, "uniform int shininess");
    text.replace(text.find("pow(max(0.0, cosine), shininess)"), 32, "pow(max(0.0, cosine), float(shininess))");
    text.replace(text.find("shininess == 0.0"), 16, "shininess == 0");
    try {
        (void)compile(what);
        FAIL() << "an int was taken for a float";
    } catch (const StudentError& error) {
        EXPECT_EQ(error.kind(), StudentError::Kind::interface_mismatch);
        EXPECT_STREQ(error.what(), "your uniform is declared 'int shininess', expected 'float shininess'");
    }
}

void expect_outward(const Shape& shape, const char* name)
{
    ASSERT_EQ(shape.positions.size(), shape.normals.size()) << name;
    for (const glm::vec3& normal : shape.normals) ASSERT_NEAR(length(normal), 1, 1e-5) << name;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const glm::vec3 a = shape.positions.at(shape.indices[i]);
        const glm::vec3 b = shape.positions.at(shape.indices[i + 1]);
        const glm::vec3 c = shape.positions.at(shape.indices[i + 2]);
        const glm::vec3 facet = cross(b - a, c - a);
        if (length(facet) < 1e-6F) continue;  // at a pole
        for (const std::size_t corner : {i, i + 1, i + 2})
            ASSERT_GT(dot(normalize(facet), shape.normals[shape.indices[corner]]), 0.2F)
                << name << ", triangle " << i / 3;
    }
}

// gl_FrontFacing is right only if every triangle turns anticlockwise round its normals.
TEST(LightingShapes, triangles_turn_round_their_normals)
{
    expect_outward(sphere(24, 12), "sphere");
    expect_outward(sphere(16, 6, 0.1F), "bowl");
    expect_outward(icosphere(0), "icosahedron");
    expect_outward(icosphere(2), "icosphere");
    expect_outward(torus(48, 24, 0.33F), "torus");
    expect_outward(trefoil(240, 32, 0.19F), "trefoil");
    expect_outward(waves(64, 0.035F), "waves");
    // Outwards, not only one way: away from the centre of the sphere.
    for (const Shape& ball : {sphere(24, 12), icosphere(1)})
        for (std::size_t i = 0; i < ball.positions.size(); ++i)
            ASSERT_GT(dot(ball.positions[i], ball.normals[i]), 0.99F);
    const Shape ring = torus(48, 24, 0.33F);
    for (std::size_t i = 0; i < ring.positions.size(); ++i) {
        const glm::vec3 centre = normalize(glm::vec3(ring.positions[i].x, ring.positions[i].y, 0));
        ASSERT_GT(dot(ring.positions[i] - centre, ring.normals[i]), 0.3F);
    }
}

}
}
