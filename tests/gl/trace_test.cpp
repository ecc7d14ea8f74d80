#include <array>
#include <cmath>
#include <limits>
#include <umbral/gl/draw_watch.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/record_trace.hpp>
#include <umbral/gl/trace.hpp>

#include "fixture.hpp"

namespace umbral::gl {
namespace {

using Traces = GlTest;

TEST_F(Traces, a_watch_sees_the_state_that_each_draw_meets)
{
    const GLuint list = glGenLists(1);
    std::vector<float> sizes;
    const auto look = [&] {
        GLfloat size = 0;
        glGetFloatv(GL_POINT_SIZE, &size);
        sizes.push_back(size);
    };
    {
        const DrawWatch watch(look);
        EXPECT_THROW(DrawWatch{look}, std::logic_error);
        glPointSize(2);
        glBegin(GL_POINTS);
        glVertex2f(0, 0);
        glArrayElement(0);
        glEnd();
        glNewList(list, GL_COMPILE);
        glBegin(GL_POINTS);
        glEnd();
        glEndList();
        glPointSize(3);
        glCallList(list);
        begin_trace();
        glPointSize(4);
        glDrawArrays(GL_POINTS, 0, 0);
        EXPECT_EQ(end_trace().calls.size(), 2U) << "what a watch asks is not traced";
    }
    glDrawArrays(GL_POINTS, 0, 0);
    EXPECT_EQ(sizes, (std::vector<float>{2, 3, 4}));
    glDeleteLists(list, 1);
}

TEST_F(Traces, see_calls_between_the_marks_only)
{
    glPointSize(2);
    begin_trace();
    glPointSize(3);
    glBegin(GL_LINES);
    glVertex3f(1, -2, 0.5F);
    glVertex3f(4, 5, 6);
    glEnd();
    const Trace trace = end_trace();
    glPointSize(4);

    std::vector<std::string> names;
    for (const TracedCall& call : trace.calls) names.emplace_back(call.name);
    EXPECT_EQ(names, (std::vector<std::string>{"glPointSize", "glBegin", "glVertex3f", "glVertex3f", "glEnd"}));
    EXPECT_EQ(trace.calls[1].arguments, std::vector<double>{GL_LINES});
    EXPECT_EQ(trace.calls[2].arguments, (std::vector<double>{1, -2, 0.5}));
    EXPECT_EQ(trace.count("glVertex3f"), 2U);
    EXPECT_EQ(trace.count("glVertex2f"), 0U);
    EXPECT_FALSE(trace.truncated);
    EXPECT_EQ(trace.uploaded_bytes, 0U);

    begin_trace();
    EXPECT_TRUE(end_trace().calls.empty());
}

TEST_F(Traces, are_bounded_but_count_on)
{
    begin_trace();
    for (std::size_t i = 0; i < Trace::maximum_calls + 10; ++i) glLoadIdentity();
    const Trace trace = end_trace();
    EXPECT_EQ(trace.calls.size(), Trace::maximum_calls);
    EXPECT_TRUE(trace.truncated);
    EXPECT_EQ(trace.count("glLoadIdentity"), Trace::maximum_calls + 10);
}

TEST_F(Traces, count_uploaded_bytes)
{
    const std::array<float, 30> numbers = {};
    const std::array<unsigned char, 5 * 4 * 3> texels = {};
    GLuint buffer = 0;
    GLuint texture = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    begin_trace();
    glBufferData(GL_ARRAY_BUFFER, sizeof numbers, numbers.data(), GL_STATIC_DRAW);
    glBufferData(GL_ARRAY_BUFFER, sizeof numbers, nullptr, GL_STATIC_DRAW);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 5, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    const Trace trace = end_trace();
    ASSERT_EQ(trace.calls.size(), 4U);
    EXPECT_EQ(trace.calls[0].bytes, 120U);
    EXPECT_EQ(trace.calls[1].bytes, 0U);
    EXPECT_EQ(trace.calls[3].bytes, 60U);
    EXPECT_EQ(trace.uploaded_bytes, 180U);
}

TEST_F(Traces, are_recorded_as_text)
{
    const std::array<float, 30> numbers = {};
    GLuint buffer = 0;
    begin_trace();
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof numbers, numbers.data(), GL_STATIC_DRAW);
    glClearColor(0.1F, -0.5F, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glSampleMaski(0, 0xFFFFFFFFU);
    glFlush();
    Trace trace = end_trace();
    Recorder out;
    record_trace(out, "calls", trace);
    const Tensor& tensor = out.tensors().at("calls");
    const std::string text(reinterpret_cast<const char*>(tensor.bytes.data()), tensor.bytes.size());
    EXPECT_EQ(text, "glGenBuffers 1 1\nglBindBuffer 34962 " + std::to_string(buffer) +
                        "\nglBufferData 34962 120 1 35044 | 120\nglClearColor 0.100000001 -0.5 0 1\nglClear "
                        "16384\nglSampleMaski 0 4294967295\nglFlush\n");
    trace.calls.resize(1);
    trace.truncated = true;
    record_trace(out, "cut", trace);
    const Tensor& cut = out.tensors().at("cut");
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(cut.bytes.data()), cut.bytes.size()),
              "glGenBuffers 1 1\n...\n");
    EXPECT_THROW(record_trace(out, "cut", trace), std::logic_error);
}

TEST_F(Traces, refuse_unpaired_marks)
{
    EXPECT_THROW((void)end_trace(), std::logic_error);
    begin_trace();
    EXPECT_THROW(begin_trace(), std::logic_error);
    (void)end_trace();
    EXPECT_THROW((void)end_trace(), std::logic_error);
}

// Sizes computed by hand from the formats' definitions.
TEST(UploadSize, follows_extent_format_and_type)
{
    EXPECT_EQ(upload_size("glTexImage3D", {GL_TEXTURE_3D, 0, GL_RGBA8, 2, 3, 4, 0, GL_RGBA, GL_FLOAT, 1}),
              2U * 3 * 4 * 16);
    EXPECT_EQ(upload_size("glTexImage1D", {GL_TEXTURE_1D, 0, GL_RED, 9, 0, GL_RED, GL_UNSIGNED_SHORT, 1}), 18U);
    EXPECT_EQ(upload_size("glTexSubImage2D", {GL_TEXTURE_2D, 0, 1, 1, 3, 5, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 1}), 30U);
    EXPECT_EQ(upload_size("glTexImage2D", {GL_TEXTURE_2D, 0, GL_RGB, 3, 5, 0, GL_RGB, GL_UNSIGNED_BYTE, 0}), 0U);
    EXPECT_EQ(upload_size("glTexImage2D", {GL_TEXTURE_2D, 0, GL_RGB, 3, 5, 0, 77, 78, 1}), 0U);
    EXPECT_EQ(upload_size("glNamedBufferSubData", {1, 16, 64, 1}), 64U);
    EXPECT_EQ(upload_size("glVertex3f", {1, 2, 3}), 0U);
}

TEST(UploadSize, stands_nonsense)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(upload_size("glBufferData", {}), 0U);
    EXPECT_EQ(upload_size("glBufferData", {1, -5, 1, 1}), 0U);
    EXPECT_EQ(upload_size("glBufferData", {1, nan, 1, 1}), 0U);
    EXPECT_EQ(upload_size("glTexImage2D", {1, 2, 3}), 0U);
    EXPECT_EQ(upload_size("glTexImage2D", {GL_TEXTURE_2D, 0, GL_RGB, -3, 5, 0, GL_RGB, GL_UNSIGNED_BYTE, 1}), 0U);
}

}
}
