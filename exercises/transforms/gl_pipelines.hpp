#pragma once

#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/transforms/matrix_stack.hpp>

#include "solids.hpp"

/// The two pipelines of the course, in real OpenGL: they draw the same picture. A context must be current.
namespace umbral::transforms {

/// One light that comes from a direction, in camera coordinates, and some from everywhere: the same numbers in both
/// pipelines.
inline constexpr float ambient_light = 0.35F;
inline constexpr float direct_light = 0.75F;
inline glm::vec3 light_direction() { return normalize(glm::vec3(-0.45F, 0.7F, 0.55F)); }

/// What both have in common: colour, line width, background, and that a line has round ends.
class OpenGlPipeline : public Pipeline {
public:
    void set_color(const glm::vec3& color) override
    {
        color_ = color;
        glColor3fv(glm::value_ptr(color));
    }
    [[nodiscard]] glm::vec3 color() const override { return color_; }
    void set_line_width(float width) override
    {
        line_width_ = width;
        glLineWidth(scale_ * width);
        glPointSize(scale_ * width);
    }
    [[nodiscard]] float line_width() const override { return line_width_; }
    [[nodiscard]] glm::vec3 background() const override { return background_; }

    void draw_polyline(std::span<const glm::vec2> places) override
    {
        draw_flat(GL_LINE_STRIP, places);
        draw_flat(GL_POINTS, places);
    }
    void fill_triangles(std::span<const glm::vec2> corners) override { draw_flat(GL_TRIANGLES, corners); }
    void draw(Primitive primitive) override { draw_solid(primitive); }

protected:
    /// `scale`: how many pixels of the framebuffer are one of the picture.
    OpenGlPipeline(const glm::vec3& background, float scale) : background_(background), scale_(scale)
    {
        set_color(glm::vec3(1));
        set_line_width(1);
        glEnable(GL_POINT_SMOOTH);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }

private:
    virtual void draw_flat(GLenum primitive, std::span<const glm::vec2> places) = 0;
    virtual void draw_solid(Primitive primitive) = 0;

    glm::vec3 color_{1};
    glm::vec3 background_;
    float line_width_ = 1;
    float scale_;
};

/// OpenGL as it was until 2008: it keeps matrices, stack, colour and lights itself. Its stack holds 32 matrices.
class FixedPipeline final : public OpenGlPipeline {
public:
    FixedPipeline(const glm::mat4& projection, const glm::vec3& background, float scale)
        : OpenGlPipeline(background, scale)
    {
        glUseProgram(0);
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(glm::value_ptr(projection));
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        const glm::vec4 towards(light_direction(), 0);
        const glm::vec4 direct(glm::vec3(direct_light), 1);
        const glm::vec4 ambient(glm::vec3(ambient_light), 1);
        const glm::vec4 none(0, 0, 0, 1);
        glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(towards));
        glLightfv(GL_LIGHT0, GL_DIFFUSE, glm::value_ptr(direct));
        glLightfv(GL_LIGHT0, GL_AMBIENT, glm::value_ptr(none));
        glLightfv(GL_LIGHT0, GL_SPECULAR, glm::value_ptr(none));
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        glEnable(GL_COLOR_MATERIAL);
    }

    void set_view(const glm::mat4& view) override
    {
        for (; depth_ > 0; --depth_) glPopMatrix();
        glLoadMatrixf(glm::value_ptr(view));
    }
    void compose(const glm::mat4& transformation) override { glMultMatrixf(glm::value_ptr(transformation)); }
    void push() override
    {
        glPushMatrix();
        ++depth_;
    }
    void pop() override
    {
        if (depth_ == 0) throw EmptyStack();
        glPopMatrix();
        --depth_;
    }

private:
    void draw_flat(GLenum primitive, std::span<const glm::vec2> places) override
    {
        glDisable(GL_LIGHTING);
        glBegin(primitive);
        for (const glm::vec2& place : places) glVertex2fv(glm::value_ptr(place));
        glEnd();
    }
    void draw_solid(Primitive primitive) override
    {
        const shapes::Shape& solid = primitive == Primitive::cylinder ? cylinder_ : half_sphere_;
        glEnable(GL_LIGHTING);
        glBegin(GL_TRIANGLES);
        for (const std::uint32_t i : solid.indices) {
            glNormal3fv(glm::value_ptr(solid.normals[i]));
            glVertex3fv(glm::value_ptr(solid.positions[i]));
        }
        glEnd();
    }

    shapes::Shape half_sphere_ = solid_of(Primitive::half_sphere);
    shapes::Shape cylinder_ = solid_of(Primitive::cylinder);
    int depth_ = 0;
};

inline constexpr const char* pipeline_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 modelview;
uniform mat3 normal_matrix;
uniform mat4 projection;
uniform vec3 color;
uniform bool is_lit;
uniform float ambient;
uniform float direct;
uniform vec3 light;
out vec3 shade;
void main()
{
    gl_Position = projection * (modelview * vec4(position, 1.0));
    float received = 1.0;
    if (is_lit) received = ambient + direct * max(dot(normalize(normal_matrix * normal), light), 0.0);
    shade = min(received * color, 1.0);
}
)";
inline constexpr const char* pipeline_fragment_shader = R"(#version 330 core
in vec3 shade;
out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }
)";

/// OpenGL as it is now: the application keeps the matrices, and sends them to its program when it draws.
class ProgrammablePipeline final : public OpenGlPipeline {
public:
    /// `stack` is what keeps them; it must not be null.
    ProgrammablePipeline(std::unique_ptr<MatrixStack> stack, const glm::mat4& projection, const glm::vec3& background,
                         float scale)
        : OpenGlPipeline(background, scale),
          stack_(std::move(stack)),
          program_({"pipeline.vert", pipeline_vertex_shader}, {"pipeline.frag", pipeline_fragment_shader})
    {
        program_.set("projection", projection);
        program_.set("ambient", ambient_light);
        program_.set("direct", direct_light);
        program_.set("light", light_direction());
        glGenVertexArrays(1, &vertex_array_);
        glGenBuffers(1, &places_);
        glBindVertexArray(vertex_array_);
        glBindBuffer(GL_ARRAY_BUFFER, places_);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(0);
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    ProgrammablePipeline(const ProgrammablePipeline&) = delete;
    ProgrammablePipeline& operator=(const ProgrammablePipeline&) = delete;
    ~ProgrammablePipeline() override
    {
        glDeleteVertexArrays(1, &vertex_array_);
        glDeleteBuffers(1, &places_);
    }

    void set_view(const glm::mat4& view) override { stack_->set_view(view); }
    void compose(const glm::mat4& transformation) override { stack_->compose(transformation); }
    void push() override { stack_->push(); }
    void pop() override { stack_->pop(); }

private:
    void send_state(bool is_lit) const
    {
        program_.set("modelview", stack_->modelview());
        program_.set("color", color());
        program_.set("is_lit", is_lit ? 1 : 0);
    }
    void draw_flat(GLenum primitive, std::span<const glm::vec2> places) override
    {
        send_state(false);
        glBindVertexArray(vertex_array_);
        glBindBuffer(GL_ARRAY_BUFFER, places_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size_bytes()), places.data(), GL_STREAM_DRAW);
        glDrawArrays(primitive, 0, static_cast<GLsizei>(places.size()));
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindVertexArray(0);
    }
    void draw_solid(Primitive primitive) override
    {
        send_state(true);
        program_.set("normal_matrix", stack_->normal_matrix());
        (primitive == Primitive::cylinder ? cylinder_ : half_sphere_).draw(program_);
    }
    static gl::Mesh upload(const shapes::Shape& solid)
    {
        return gl::Mesh(solid.positions, solid.normals, solid.indices);
    }

    std::unique_ptr<MatrixStack> stack_;
    gl::Program program_;
    gl::Mesh half_sphere_ = upload(solid_of(Primitive::half_sphere));
    gl::Mesh cylinder_ = upload(solid_of(Primitive::cylinder));
    GLuint vertex_array_ = 0;
    GLuint places_ = 0;
};

}
