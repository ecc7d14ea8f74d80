#include <array>
#include <cstring>
#include <span>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/gl/trace.hpp>
#include <vector>

#include "fixture.hpp"
#include "pixels.hpp"

// Each way to move data to OpenGL, with the bytes that a trace must count. By hand: a float has 4, a short 2.
namespace umbral::gl {
namespace {

constexpr std::array<float, 12> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
constexpr std::array<GLushort, 6> indices = {0, 1, 2, 2, 1, 3};

template <class Work>
Trace traced(Work work)
{
    begin_trace();
    work();
    return end_trace();
}

template <class Work>
std::uint64_t bytes_of(Work work)
{
    return traced(work).uploaded_bytes;
}

class Uploads : public GlTest {
protected:
    const Framebuffer target{8, 8};
    GLuint buffer = 0;
    GLuint array = 0;

    Uploads()
    {
        target.bind();
        glGenVertexArrays(1, &array);
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
    }

    /// A buffer that may stay mapped, of 64 bytes, with its memory.
    static std::pair<GLuint, float*> lasting_buffer()
    {
        GLuint name = 0;
        constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        glCreateBuffers(1, &name);
        glNamedBufferStorage(name, 64, nullptr, access);
        return {name, static_cast<float*>(glMapNamedBufferRange(name, 0, 64, access))};
    }

    static void draw() { glDrawArrays(GL_TRIANGLES, 0, 3); }
};

}

TEST_F(Uploads, what_is_mapped_for_writing_counts_whole)
{
    EXPECT_EQ(bytes_of([&] { (void)glMapNamedBuffer(buffer, GL_WRITE_ONLY), glUnmapNamedBuffer(buffer); }), 48U);
    EXPECT_EQ(bytes_of([&] { (void)glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE), glUnmapBuffer(GL_ARRAY_BUFFER); }),
              48U);
    EXPECT_EQ(bytes_of([&] {
                  (void)glMapBufferRange(GL_ARRAY_BUFFER, 12, 24, GL_MAP_WRITE_BIT);
                  glUnmapBuffer(GL_ARRAY_BUFFER);
              }),
              24U);
    EXPECT_EQ(bytes_of([&] {
                  (void)glMapNamedBufferRange(buffer, 12, 24, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
                  glUnmapNamedBuffer(buffer);
              }),
              24U)
        << "flushing nothing hides nothing: llvmpipe shows what was written all the same";
    EXPECT_EQ(bytes_of([&] { (void)glMapNamedBuffer(buffer, GL_READ_ONLY), glUnmapNamedBuffer(buffer); }), 0U);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Uploads, what_was_mapped_before_the_trace_counts_when_unmapped)
{
    (void)glMapNamedBuffer(buffer, GL_WRITE_ONLY);
    EXPECT_EQ(bytes_of([&] { glUnmapNamedBuffer(buffer); }), 48U);
    EXPECT_EQ(bytes_of([&] { draw(); }), 0U);
}

TEST_F(Uploads, what_stays_mapped_counts_at_each_draw)
{
    const auto [name, memory] = lasting_buffer();
    ASSERT_NE(memory, nullptr);
    EXPECT_EQ(bytes_of([&] {
                  for (int i = 0; i < 3; ++i) std::memset(memory, i, 64), draw();
              }),
              3U * 64);
    glUnmapNamedBuffer(name);
    EXPECT_EQ(bytes_of([&] { draw(); }), 0U);
    (void)lasting_buffer();
    const GLuint last = lasting_buffer().first;
    EXPECT_EQ(bytes_of([&] { draw(); }), 128U);
    glDeleteBuffers(1, &last);
    EXPECT_EQ(bytes_of([&] { draw(); }), 64U) << "a buffer that is gone is not counted";
}

TEST_F(Uploads, pinned_memory_counts_at_each_draw)
{
    if (std::strstr(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), "GL_AMD_pinned_memory") == nullptr)
        GTEST_SKIP() << "this driver pins no memory";
    alignas(4096) static std::array<float, 1024> own = {};
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD, name);
    glBufferData(GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD, sizeof own, own.data(), GL_STREAM_DRAW);
    if (glGetError() != GL_NO_ERROR) GTEST_SKIP() << "this driver pins no memory";
    EXPECT_EQ(bytes_of([&] { draw(), draw(); }), 2 * sizeof own);
}

TEST_F(Uploads, vertices_from_the_applications_memory_count_when_drawn)
{
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corners.data());
    EXPECT_EQ(bytes_of([&] { glDrawArrays(GL_TRIANGLES, 0, 3); }), 3U * 12);
    EXPECT_EQ(bytes_of([&] { glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices.data()); }), 6U * (12 + 2));
    const std::array<GLint, 2> firsts = {0, 1};
    const std::array<GLsizei, 2> counts = {3, 3};
    EXPECT_EQ(bytes_of([&] { glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), 2); }), 6U * 12);
    glClientActiveTexture(GL_TEXTURE3);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_SHORT, 0, indices.data());
    glClientActiveTexture(GL_TEXTURE1);
    EXPECT_EQ(bytes_of([&] { glDrawArrays(GL_TRIANGLES, 0, 3); }), 3U * (12 + 4));
    GLint chosen = 0;
    glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &chosen);
    EXPECT_EQ(chosen, GL_TEXTURE1);
    glDisableClientState(GL_VERTEX_ARRAY);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, corners.data());
    EXPECT_EQ(bytes_of([&] { glDrawArrays(GL_TRIANGLES, 0, 3); }), 3U * (4 + 4));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Uploads, vertices_from_buffers_do_not)
{
    glBindVertexArray(array);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    EXPECT_EQ(bytes_of([&] { draw(); }), 0U);
    EXPECT_EQ(bytes_of([&] { glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, indices.data()); }), 3U * 2);
}

TEST_F(Uploads, pictures_come_from_memory_or_from_a_buffer)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const auto replace = [](const void* pixels) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    };
    EXPECT_EQ(bytes_of([&] { replace(corners.data()); }), 16U);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    EXPECT_EQ(bytes_of([&] { replace(nullptr); }), 16U) << "the buffer's beginning, which is no null pointer";
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    EXPECT_EQ(bytes_of([&] { glClearTexImage(texture, 0, GL_RGBA, GL_FLOAT, corners.data()); }), 16U);
    EXPECT_EQ(bytes_of([&] { glBitmap(9, 3, 0, 0, 0, 0, reinterpret_cast<const GLubyte*>(corners.data())); }), 6U);
    EXPECT_EQ(bytes_of([&] { glDrawPixels(2, 2, GL_RED, GL_FLOAT, corners.data()); }), 16U);
}

TEST_F(Uploads, buffers_are_filled_in_many_ways)
{
    EXPECT_EQ(bytes_of([&] { glNamedBufferSubData(buffer, 0, 20, corners.data()); }), 20U);
    EXPECT_EQ(bytes_of([&] { glClearNamedBufferData(buffer, GL_R32F, GL_RED, GL_FLOAT, corners.data()); }), 4U);
    EXPECT_EQ(
        bytes_of([&] { glClearBufferSubData(GL_ARRAY_BUFFER, GL_RG32F, 0, 16, GL_RG, GL_FLOAT, corners.data()); }), 8U);
    GLuint other = 0;
    glGenBuffers(1, &other);
    glBindBuffer(GL_COPY_READ_BUFFER, other);
    EXPECT_EQ(bytes_of([&] { glBufferStorage(GL_COPY_READ_BUFFER, 32, corners.data(), 0); }), 32U);
    EXPECT_EQ(bytes_of([&] { glCopyNamedBufferSubData(other, buffer, 0, 0, 32); }), 0U) << "it never leaves OpenGL";
}

TEST_F(Uploads, uniforms_are_parameters_and_arrays_of_them_data)
{
    const Program program(vertex_source("#version 330\nuniform vec4 table[8]; uniform mat4 one;\n"
                                        "void main() { gl_Position = one * table[gl_VertexID]; }\n"),
                          fragment_source("#version 330\nout vec4 c; void main() { c = vec4(1); }\n"));
    program.use();
    const std::vector<float> values(64);
    EXPECT_EQ(bytes_of([&] { glUniformMatrix4fv(0, 1, GL_FALSE, values.data()); }), 0U);
    EXPECT_EQ(bytes_of([&] { glUniform4fv(0, 8, values.data()); }), 8U * 16);
    EXPECT_EQ(upload_size("glProgramUniform3dv", {1, 2, 5, 1}), 5U * 24);
    EXPECT_EQ(upload_size("glUniformMatrix2x3fv", {0, 2, 0, 1}), 2U * 24);
    EXPECT_EQ(upload_size("glUniform1uiv", {0, 3, 1}), 12U);
}

TEST_F(Uploads, display_lists_show_what_they_do)
{
    const GLuint list = glGenLists(2);
    glNewList(list, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) glVertex3f(0, 1, 2);
    glEnd();
    glEndList();
    const Trace drawn = traced([&] { glCallList(list); });
    EXPECT_EQ(drawn.count("glVertex3f"), 3U);
    EXPECT_EQ(drawn.calls.size(), 1U + 5);
    const Trace made = traced([&] {
        glNewList(list + 1, GL_COMPILE);
        glCallList(list);
        glEndList();
    });
    EXPECT_EQ(made.count("glVertex3f"), 0U) << "nothing is done yet";
    glListBase(list);
    const std::array<GLubyte, 2> twice = {1, 0};
    EXPECT_EQ(traced([&] { glCallLists(2, GL_UNSIGNED_BYTE, twice.data()); }).count("glVertex3f"), 6U);
    glDeleteLists(list, 1);
    EXPECT_EQ(traced([&] { glCallList(list + 1); }).count("glVertex3f"), 0U);
}

TEST_F(Uploads, lists_of_lists_stay_within_the_trace)
{
    const GLuint first = glGenLists(40);
    for (GLuint i = 0; i < 40; ++i) {
        glNewList(first + i, GL_COMPILE);
        for (int twice = 0; twice < 2; ++twice) i == 0 ? glPointSize(1) : glCallList(first + i - 1);
        glEndList();
    }
    begin_trace();
    glNewList(first, GL_COMPILE);
    glEndList();
    glCallList(first + 20);
    const Trace trace = end_trace();
    EXPECT_TRUE(trace.truncated);
    EXPECT_EQ(trace.calls.size(), Trace::maximum_calls);
}

}
