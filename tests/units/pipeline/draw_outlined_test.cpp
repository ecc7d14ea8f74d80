#include <gtest/gtest.h>

#include <optional>
#include <pipeline/support_gl.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/trace.hpp>
#include <umbral/pipeline/outlined.hpp>

// Linked with the reference; what is expected are colours of single pixels, names that live, and calls.

using namespace umbral;
using namespace umbral::pipeline;

namespace {

const std::vector<glm::vec2> square = {{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
const std::vector<std::uint32_t> halves = {0, 1, 2, 3, 0, 2};
constexpr glm::vec3 red(1, 0, 0);
constexpr glm::vec3 blue(0, 0, 1);

class DrawOutlined : public testing::Test {
protected:
    static constexpr int size = 64;

    DrawOutlined()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        canvas_.emplace(size);
        glDepthFunc(GL_LEQUAL);
        glLineWidth(8);
    }

    /// At a place of clip coordinates.
    [[nodiscard]] glm::vec3 color_at(glm::vec2 place) const
    {
        const auto pixel = [](float x) { return static_cast<int>((0.5F + 0.5F * x) * size); };
        return glm::vec3(canvas_->picture().at(pixel(place.x), pixel(-place.y))) / 255.0F;
    }

    void expect_red_square_with_blue_edges() const
    {
        EXPECT_EQ(color_at({-0.2F, 0.25F}), red);
        EXPECT_EQ(color_at({0.25F, -0.2F}), red);
        for (const glm::vec2 middle : {glm::vec2(0.5F, 0), {0, 0.5F}, {-0.5F, 0}, {0, -0.5F}})
            EXPECT_EQ(color_at(middle), blue) << middle.x << ", " << middle.y;
        EXPECT_NE(color_at({0.8F, 0.8F}), red);
    }

    static void expect_nothing_left(bool objects)
    {
        EXPECT_EQ(state_of(GL_VERTEX_ARRAY_BINDING), 0);
        EXPECT_EQ(state_of(GL_ARRAY_BUFFER_BINDING), 0);
        EXPECT_EQ(state_of(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        if (objects) return;
        EXPECT_EQ(living(glIsVertexArray), 0);
        EXPECT_EQ(living(glIsBuffer), 0);
    }

private:
    std::optional<gl::OffscreenContext> context_;

protected:
    std::optional<Canvas> canvas_;
};

}

TEST_F(DrawOutlined, a_polygon_sent_vertex_by_vertex_has_both_colours)
{
    send_polygon(square, red, blue);
    expect_red_square_with_blue_edges();
    expect_nothing_left(false);
}

TEST_F(DrawOutlined, a_polygon_keeps_its_corners_when_the_table_has_gone)
{
    std::vector<glm::vec2> corners = square;
    const auto drawing = make_outlined_polygon(corners);
    corners.assign(4, glm::vec2(0));
    drawing->draw(red, blue);
    expect_red_square_with_blue_edges();
    EXPECT_EQ(color_at({0.03F, 0.03F}), red) << "no diagonal";
}

TEST_F(DrawOutlined, all_edges_of_triangles_show_and_the_mode_is_put_back)
{
    const auto drawing = make_outlined_triangles(square, halves);
    drawing->draw(red, blue);
    expect_red_square_with_blue_edges();
    EXPECT_EQ(color_at({0.03F, 0.03F}), blue) << "the diagonal";
    GLint mode[2] = {0, 0};
    glGetIntegerv(GL_POLYGON_MODE, mode);
    EXPECT_EQ(mode[0], GL_FILL);
}

TEST_F(DrawOutlined, drawings_share_nothing_and_leave_nothing)
{
    auto small = make_outlined_polygon({{-0.1F, -0.1F}, {0.1F, -0.1F}, {0, 0.1F}});
    expect_nothing_left(true);
    auto large = make_outlined_triangles(square, halves);
    expect_nothing_left(true);
    small.reset();
    large->draw(red, blue);
    expect_red_square_with_blue_edges();
    large.reset();
    expect_nothing_left(false);
}

TEST_F(DrawOutlined, a_frame_is_two_draw_calls_and_no_upload)
{
    const auto polygon = make_outlined_polygon(square);
    const auto triangles = make_outlined_triangles(square, halves);
    polygon->draw(red, blue);
    triangles->draw(red, blue);
    gl::begin_trace();
    polygon->draw(blue, red);
    triangles->draw(blue, red);
    const gl::Trace trace = gl::end_trace();
    EXPECT_EQ(trace.uploaded_bytes, 0U);
    EXPECT_EQ(trace.count("glDrawArrays"), 2U);
    EXPECT_EQ(trace.count("glDrawElements"), 2U);
    EXPECT_EQ(trace.count("glBindVertexArray"), 4U);
    EXPECT_EQ(trace.count("glPolygonMode"), 2U);
}

TEST_F(DrawOutlined, empty_tables_draw_nothing)
{
    const Image before = canvas_->picture();
    send_polygon({}, red, blue);
    make_outlined_polygon({})->draw(red, blue);
    make_outlined_triangles({}, {})->draw(red, blue);
    EXPECT_EQ(canvas_->picture().cells, before.cells);
    expect_nothing_left(false);
}
