#include <transforms/android/parade.hpp>
#include <transforms/hook/wheel.hpp>
#include <transforms/trunk-and-tree/grove.hpp>

#include "gl/fixture.hpp"

// The same drawing functions through OpenGL's fixed function and through a program: the same picture.

using namespace umbral;
using namespace umbral::transforms;

namespace {

using PipelinesTest = gl::GlTest;

struct Difference {
    int drawn = 0;      ///< pixels that are not background
    int different = 0;  ///< pixels that differ by more than 2 of 255 in a channel
    int worst = 0;
};

Difference compare(const Image& one, const Image& other)
{
    Difference difference;
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
        int largest = 0;
        for (int k = 0; k < 3; ++k)
            largest = std::max(largest, std::abs(int{one.cells[i][k]} - int{other.cells[i][k]}));
        difference.drawn += one.cells[i] == one.cells[0] ? 0 : 1;
        difference.different += largest > 2 ? 1 : 0;
        difference.worst = std::max(difference.worst, largest);
    }
    return difference;
}

/// `paint` in both pipelines, on 512 x 512 pixels.
template <class Paint>
Difference compare_pipelines(const glm::mat4& projection, const glm::vec3& background, bool depth_test, Paint paint)
{
    const auto draw = [&](auto make_pipeline) {
        const gl::Framebuffer frame(512, 512);
        frame.clear(glm::vec4(background, 1));
        depth_test ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
        const auto pipeline = make_pipeline();
        pipeline->set_view(glm::mat4(1));
        Recorder out;
        paint(out, *pipeline);
        gl::check_errors("a picture");
        return frame.read_pixels();
    };
    const Image programmable =
        draw([&] { return std::make_unique<ProgrammablePipeline>(make_matrix_stack(), projection, background, 1.0F); });
    const Image fixed = draw([&] { return std::make_unique<FixedPipeline>(projection, background, 1.0F); });
    return compare(programmable, fixed);
}

void expect_same(const Difference& difference)
{
    EXPECT_GT(difference.drawn, 5000);
    EXPECT_EQ(difference.different, 0) << "of " << difference.drawn << " drawn pixels; the worst by "
                                       << difference.worst;
}

}

TEST_F(PipelinesTest, draw_the_same_hooks)
{
    const glm::mat4 window = glm::ortho(-wheel_reach, wheel_reach, -wheel_reach, wheel_reach);
    expect_same(compare_pipelines(window, ink::night, false, paint_wheel));
}

TEST_F(PipelinesTest, draw_the_same_trees)
{
    expect_same(compare_pipelines(grove_window(), grove_background, false, [](Recorder& out, Pipeline& pipeline) {
        Variation as_written;
        paint_grove(as_written, out, pipeline);
    }));
}

TEST_F(PipelinesTest, draw_the_same_figures)
{
    expect_same(compare_pipelines(glm::ortho(-1.0F, 6.0F, -2.5F, 4.5F), glm::vec3(0.1F, 0.2F, 0.3F), false,
                                  [](Recorder&, Pipeline& pipeline) {
                                      pipeline.compose(glm::rotate(glm::mat4(1), 0.2F, {0, 0, 1}));
                                      pipeline.set_color({0.9F, 0.6F, 0.1F});
                                      draw_complex_figure(pipeline, draw_simple_figure);
                                  }));
}

// Lit, in perspective, through matrices that stretch: what the normals are multiplied with shows.
TEST_F(PipelinesTest, draw_the_same_androids)
{
    const std::unique_ptr<Android> android = make_android();
    expect_same(compare_pipelines(parade_projection(), parade_background, true, [&](Recorder& out, Pipeline& pipeline) {
        Variation as_written;
        paint_parade(as_written, out, pipeline, *android);
    }));
}

TEST_F(PipelinesTest, refuse_to_pop_an_empty_stack)
{
    FixedPipeline fixed(glm::mat4(1), glm::vec3(0), 1);
    ProgrammablePipeline programmable(make_matrix_stack(), glm::mat4(1), glm::vec3(0), 1);
    for (Pipeline* pipeline : {static_cast<Pipeline*>(&fixed), static_cast<Pipeline*>(&programmable)}) {
        pipeline->push();
        pipeline->push();
        pipeline->pop();
        pipeline->set_view(glm::mat4(1));
        EXPECT_THROW(pipeline->pop(), EmptyStack);
    }
}
