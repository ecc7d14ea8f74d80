#include <gtest/gtest.h>

#include <kit/shapes.hpp>

namespace umbral::shapes {
namespace {

/// Triangles look where their normals point, normals are unit, and no index leads outside.
void expect_outward(const Shape& shape, const char* name)
{
    ASSERT_EQ(shape.positions.size(), shape.normals.size()) << name;
    ASSERT_EQ(shape.indices.size() % 3, 0U) << name;
    for (const glm::vec3& normal : shape.normals) EXPECT_NEAR(length(normal), 1, 1e-4) << name;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const auto [a, b, c] = std::tuple{shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]};
        ASSERT_LT(std::max({a, b, c}), shape.positions.size()) << name;
        const glm::vec3 face = cross(shape.positions[b] - shape.positions[a], shape.positions[c] - shape.positions[a]);
        if (length(face) < 1e-6F) continue;  // at a pole, where a cell is a triangle
        EXPECT_GT(dot(face, shape.normals[a] + shape.normals[b] + shape.normals[c]), 0)
            << name << ", triangle " << i / 3;
    }
}

TEST(Shapes, look_outwards)
{
    expect_outward(sphere(24, 12), "sphere");
    expect_outward(sphere(24, 12, 0.3F), "bowl");
    expect_outward(icosphere(0), "icosahedron");
    expect_outward(icosphere(2), "icosphere");
    expect_outward(torus(32, 12, 0.3F), "torus");
    expect_outward(trefoil(72, 12, 0.2F), "knot");
    expect_outward(box(), "box");
    expect_outward(arrow(), "arrow");
}

TEST(Shapes, enclose_their_volume)
{
    const auto volume = [](const Shape& shape) {
        double sum = 0;
        for (std::size_t i = 0; i < shape.indices.size(); i += 3)
            sum += double{dot(shape.positions[shape.indices[i]],
                              cross(shape.positions[shape.indices[i + 1]], shape.positions[shape.indices[i + 2]]))} /
                   6;
        return sum;
    };
    EXPECT_NEAR(volume(box()), 1, 1e-6);
    EXPECT_NEAR(volume(sphere(96, 48)), 4.18879, 0.02);
    EXPECT_NEAR(volume(icosphere(4)), 4.18879, 0.02);
    EXPECT_NEAR(volume(torus(96, 48, 0.3F)), 1.77653, 0.02);  // 2 π² · 0.3²
}

TEST(Shapes, a_grid_is_joined_behind_what_was_there)
{
    Shape shape;
    shape.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    shape.positions.resize(4 + 6);
    join_grid(shape, 2, 1);
    ASSERT_EQ(shape.indices.size(), 6U + 12U);
    EXPECT_EQ(std::vector(shape.indices.begin() + 6, shape.indices.begin() + 12),
              (std::vector<std::uint32_t>{4, 5, 8, 4, 8, 7}));
}

}
}
