#include <gtest/gtest.h>

#include <map>
#include <pipeline/draw-deferred/meshes.hpp>
#include <pipeline/support_gl.hpp>
#include <umbral/gl/trace.hpp>

#include "fixture.hpp"

namespace umbral::pipeline {
namespace {

using DrawDeferred = gl::GlTest;

/// The same triangles one vertex at a time, by what no line of the reference uses.
void draw_vertex_by_vertex(const ColoredMesh& mesh)
{
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t index : mesh.indices) {
        glVertexAttrib3fv(1, &mesh.colors[index].x);
        glVertex3fv(&mesh.positions[index].x);
    }
    glEnd();
}

void expect_same_pixels(const ColoredMesh& mesh, int size)
{
    const Canvas canvas(size);
    make_indexed_drawing(mesh)->draw();
    const Image deferred = canvas.picture();
    canvas.clear();
    draw_vertex_by_vertex(mesh);
    EXPECT_EQ(deferred.cells, canvas.picture().cells);
    canvas.clear();
    const Image empty = canvas.picture();
    EXPECT_EQ(mesh.indices.empty(), deferred.cells == empty.cells) << "something is to be seen";
    gl::check_errors("drawing");
}

TEST_F(DrawDeferred, shows_what_immediate_mode_shows)
{
    expect_same_pixels(rosette(12, 16), 192);
    expect_same_pixels(polygon(5, {0.1F, 0, 0}, 0.8F, 0.4F), 64);
    expect_same_pixels({}, 16);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        expect_same_pixels(random_mesh(random, 30, 25), 64);
    }
}

TEST_F(DrawDeferred, numbers_more_vertices_than16_bits_can)
{
    const ColoredMesh mesh = sheet(257, 257, 8);
    ASSERT_GT(mesh.positions.size(), 65536U);
    expect_same_pixels(mesh, 64);
    // Cut to 16 bits, the picture is another one: that is what the unit's case looks for.
    ColoredMesh wrapped = mesh;
    for (std::uint32_t& index : wrapped.indices) index &= 0xFFFFU;
    const Canvas canvas(64);
    make_indexed_drawing(mesh)->draw();
    const Image right = canvas.picture();
    canvas.clear();
    make_indexed_drawing(wrapped)->draw();
    const Image wrong = canvas.picture();
    std::size_t different = 0;
    for (std::size_t i = 0; i < right.cells.size(); ++i) different += right.cells[i] != wrong.cells[i] ? 1 : 0;
    EXPECT_GT(different, right.cells.size() / 4);
}

TEST_F(DrawDeferred, uploads_once_and_draws_with_three_calls)
{
    const Canvas canvas(16);
    const ColoredMesh mesh = rosette(12, 16);
    EXPECT_EQ(mesh.positions.size(), 1153U) << "the statement's numbers";
    EXPECT_EQ(mesh.indices.size(), 6696U);
    gl::begin_trace();
    const auto drawing = make_indexed_drawing(mesh);
    drawing->draw();
    const gl::Trace first = gl::end_trace();
    EXPECT_EQ(first.uploaded_bytes, 54456U);
    EXPECT_EQ(first.count("glBufferData"), 3U);
    EXPECT_EQ(first.count("glDrawElements"), 1U);
    gl::begin_trace();
    drawing->draw();
    const gl::Trace later = gl::end_trace();
    EXPECT_EQ(later.calls.size(), 3U);
    EXPECT_EQ(later.uploaded_bytes, 0U);
    EXPECT_EQ(later.count("glDrawElements"), 1U);
    EXPECT_EQ(later.count("glBindVertexArray"), 2U);
}

TEST_F(DrawDeferred, leaves_the_state_and_no_objects)
{
    const Canvas canvas(16);
    const auto clean = [] {
        return state_of(GL_VERTEX_ARRAY_BINDING) == 0 && state_of(GL_ARRAY_BUFFER_BINDING) == 0 &&
               state_of(GL_ELEMENT_ARRAY_BUFFER_BINDING) == 0;
    };
    const float program = state_of(GL_CURRENT_PROGRAM);
    ASSERT_TRUE(clean());
    for (int round = 0; round < 3; ++round) {
        const auto drawing = make_indexed_drawing(polygon(7, {0, 0, 0}, 0.5F, 0));
        EXPECT_TRUE(clean());
        drawing->draw();
        EXPECT_TRUE(clean());
        EXPECT_EQ(state_of(GL_CURRENT_PROGRAM), program);
        EXPECT_EQ(living(glIsVertexArray), 1);
        EXPECT_EQ(living(glIsBuffer), 3);
    }
    EXPECT_TRUE(clean());
    EXPECT_EQ(living(glIsVertexArray), 0);
    EXPECT_EQ(living(glIsBuffer), 0);
}

// Rings of triangles, each at least as large as nothing, none twice: the goal picture shows a mesh, not a heap.
TEST(Rosette, is_a_mesh_without_holes)
{
    for (const auto& [petals, rings] : {std::pair{8, 12}, std::pair{12, 16}, std::pair{3, 1}}) {
        const ColoredMesh mesh = rosette(petals, rings);
        ASSERT_EQ(mesh.positions.size(), mesh.colors.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return mesh.indices.at(i + k % 3); };
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_LT(corner(k), mesh.positions.size());
                ++sides[{corner(k), corner(k + 1)}];
            }
            const glm::vec3 a = mesh.positions[corner(1)] - mesh.positions[corner(0)];
            const glm::vec3 b = mesh.positions[corner(2)] - mesh.positions[corner(0)];
            EXPECT_GT(a.x * b.y - a.y * b.x, 0) << "counter-clockwise";
        }
        std::size_t rim = 0;
        for (const auto& [side, count] : sides) {
            EXPECT_EQ(count, 1);
            rim += sides.contains({side.second, side.first}) ? 0 : 1;
        }
        EXPECT_EQ(rim, static_cast<std::size_t>(6 * petals)) << "only the outermost ring is a rim";
    }
}

}
}
