#pragma once

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <stdexcept>
#include <umbral/core/random.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/texturing/generation.hpp>
#include <vector>

/// The texture coordinates that both pipelines give a vertex, as numbers.
namespace umbral::texturing {

/// A vertex, and the matrix that it is drawn under.
struct Vertex {
    glm::vec4 position{0, 0, 0, 1};
    glm::vec2 tex_coord{0};
    glm::mat4 modelview{1};
};

/// The projection that takes this vertex to the middle of the picture, in clip coordinates (0, 0, 0, 1), whatever its
/// w.
inline glm::mat4 to_the_middle(const Vertex& vertex)
{
    const glm::vec4 eye = vertex.modelview * vertex.position;
    glm::mat4 projection(0);
    for (int column = 0; column < 4; ++column) projection[column][3] = eye[column] / dot(eye, eye);
    return projection;
}

/// What the fixed pipeline makes of the coordinates of a vertex, by its feedback mode. Has a texture of its own bound,
/// since coordinates are computed only for those who use them. Changes the matrices.
class FixedProbe {
public:
    FixedProbe()
    {
        constexpr std::array<GLubyte, 4> white = {255, 255, 255, 255};
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    FixedProbe(const FixedProbe&) = delete;
    FixedProbe& operator=(const FixedProbe&) = delete;
    ~FixedProbe() { glDeleteTextures(1, &texture_); }

    /// s and t; far below all others if the point is not drawn.
    [[nodiscard]] glm::vec2 read(const Vertex& vertex) const
    {
        glUseProgram(0);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glEnable(GL_TEXTURE_2D);
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(value_ptr(to_the_middle(vertex)));
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(vertex.modelview));
        std::array<GLfloat, 32> values{};
        glFeedbackBuffer(static_cast<GLsizei>(values.size()), GL_4D_COLOR_TEXTURE, values.data());
        glRenderMode(GL_FEEDBACK);
        glBegin(GL_POINTS);
        glTexCoord2f(vertex.tex_coord.s, vertex.tex_coord.t);
        glVertex4fv(value_ptr(vertex.position));
        glEnd();
        const GLint count = glRenderMode(GL_RENDER);
        glDisable(GL_TEXTURE_2D);
        // One point: its token, four numbers of its place, four of its colour, four of its texture coordinates.
        return count == 13 ? glm::vec2(values[9], values[10]) : glm::vec2(-1e6F);
    }

private:
    GLuint texture_ = 0;
};

/// A framebuffer of one pixel of floats. A context must be current while it lives; a framebuffer that was bound before
/// is not bound again.
class FloatPixel {
public:
    FloatPixel()
    {
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(1, &color_);
        glBindRenderbuffer(GL_RENDERBUFFER, color_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, 1, 1);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("OpenGL refuses a framebuffer of floats");
        glViewport(0, 0, 1, 1);
    }
    FloatPixel(const FloatPixel&) = delete;
    FloatPixel& operator=(const FloatPixel&) = delete;
    ~FloatPixel()
    {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(1, &color_);
    }

    static glm::vec4 read()
    {
        glm::vec4 value(0);
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, value_ptr(value));
        return value;
    }

private:
    GLuint framebuffer_ = 0;
    GLuint color_ = 0;
};

inline gl::Interface generator_interface()
{
    return {{{"position", GL_FLOAT_VEC4, 1}, {"tex_coord", GL_FLOAT_VEC2, 1}, {"color", GL_FLOAT_VEC3, 1}},
            {{"modelview", GL_FLOAT_MAT4, 1},
             {"projection", GL_FLOAT_MAT4, 1},
             {"generation", GL_INT, 1},
             {"s_plane", GL_FLOAT_VEC4, 1},
             {"t_plane", GL_FLOAT_VEC4, 1}}};
}

inline void set_uniforms(const gl::Program& program, const Generator& generator)
{
    program.set("generation", static_cast<int>(generator.generation));
    program.set("s_plane", generator.s_plane);
    program.set("t_plane", generator.t_plane);
}

/// What a vertex shader makes of the coordinates of a vertex.
class ShaderProbe {
public:
    explicit ShaderProbe(const std::string& vertex_shader)
        : program_({"your vertex shader", vertex_shader}, {"probe.frag", R"(#version 330
in vec2 st;
in vec3 shade;
out vec4 color;
void main() { color = vec4(st, shade.xy); }
)"})
    {
        program_.require_interface(generator_interface());
        glGenVertexArrays(1, &array_);
    }
    ShaderProbe(const ShaderProbe&) = delete;
    ShaderProbe& operator=(const ShaderProbe&) = delete;
    ~ShaderProbe() { glDeleteVertexArrays(1, &array_); }

    /// s, t, and two numbers of `color`; -10^6 if the vertex is not drawn where its gl_Position must be.
    [[nodiscard]] glm::vec4 read(const Vertex& vertex, const Generator& generator, glm::vec2 color) const
    {
        glBindVertexArray(array_);
        set_uniforms(program_, generator);
        program_.set("modelview", vertex.modelview);
        program_.set("projection", to_the_middle(vertex));
        feed("tex_coord", glm::vec4(vertex.tex_coord, 0, 1));
        feed("color", glm::vec4(color, 0, 1));
        feed("position", vertex.position);
        glClearColor(-1e6F, -1e6F, -1e6F, -1e6F);
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawArrays(GL_POINTS, 0, 1);
        return FloatPixel::read();
    }

private:
    void feed(const char* name, const glm::vec4& value) const
    {
        const int location = program_.attribute_location(name);
        if (location >= 0) glVertexAttrib4fv(static_cast<GLuint>(location), value_ptr(value));
    }

    gl::Program program_;
    FloatPixel pixel_;
    GLuint array_ = 0;
};

inline glm::vec4 random_plane(Random& random) { return {2.0F * random.in_cube(), random.uniform(-2, 2)}; }

/// Turned, stretched and moved.
inline glm::mat4 random_modelview(Random& random)
{
    glm::mat4 matrix = glm::translate(glm::mat4(1), 3.0F * random.in_cube());
    matrix = glm::rotate(matrix, random.uniform(0, 6.28F), random.unit_vector());
    return glm::scale(matrix, glm::vec3(1) + 0.5F * random.in_cube());
}

/// Half of them have a w that is not 1, but any other: also negative ones, and 0.
inline Vertex random_vertex(Random& random)
{
    Vertex vertex;
    const std::array<float, 4> others = {random.uniform(0.5F, 2), random.uniform(0.5F, 2), random.uniform(-2, 0), 0};
    const float w = random.below(2) == 0 ? 1 : others[random.below(4)];
    vertex.position = {2.0F * random.in_cube(), w};
    vertex.tex_coord = glm::vec2(random.in_cube());
    vertex.modelview = random_modelview(random);
    return vertex;
}

/// What others may leave of the generators: any mode, plane and switch.
inline void choose_generators(Random& random)
{
    for (const GLenum coordinate : {GL_S, GL_T}) {
        constexpr std::array modes = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP};
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, modes[random.below(3)]);
        for (const GLenum plane : {GL_OBJECT_PLANE, GL_EYE_PLANE})
            glTexGenfv(coordinate, plane, value_ptr(random_plane(random)));
        const GLenum which = coordinate == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T;
        random.below(2) == 0 ? glEnable(which) : glDisable(which);
    }
}

inline Generator random_generator(Random& random, Generation generation)
{
    Generator generator{generation, random_plane(random), {}};
    generator.t_plane = random_plane(random);
    // As plane_along() gives of an axis of no length.
    if (random.below(6) == 0) (random.below(2) == 0 ? generator.s_plane : generator.t_plane) = glm::vec4(0);
    return generator;
}

}
