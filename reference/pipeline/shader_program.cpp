// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Core Profile). 2017,
// chapter 7.

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/program.hpp>

namespace umbral::pipeline {
namespace {

using Step = ShaderError::Step;

/// A shader or a program; deleted at the end of its life, also when an exception ends it.
class Object {
public:
    Object(GLuint name, void (*destroy)(GLuint)) : name_(name), destroy_(destroy) {}
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    ~Object() { destroy_(name_); }

    [[nodiscard]] GLuint name() const { return name_; }

private:
    GLuint name_;
    void (*destroy_)(GLuint);
};

/// Throws if a step failed. Shaders and programs are asked in the same way, by functions of their own.
void require_success(Step step, const Object& object, GLenum status, decltype(glGetShaderiv)* ask,
                     decltype(glGetShaderInfoLog)* read_log)
{
    GLint success = GL_FALSE;
    ask(object.name(), status, &success);
    if (success == GL_TRUE) return;
    GLint size = 0;  // with the zero at its end
    ask(object.name(), GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
    read_log(object.name(), size, nullptr, log.data());
    log.pop_back();
    throw ShaderError(step, log);
}

void compile(Step step, const Object& shader, const std::string& text)
{
    const char* start = text.data();
    const auto size = static_cast<GLint>(text.size());
    glShaderSource(shader.name(), 1, &start, &size);
    glCompileShader(shader.name());
    require_success(step, shader, GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog);
}

class LinkedProgram : public ShaderProgram {
public:
    explicit LinkedProgram(const ShaderTexts& texts) : program_(glCreateProgram(), glDeleteProgram)
    {
        const Object vertex(glCreateShader(GL_VERTEX_SHADER), glDeleteShader);
        compile(Step::compile_vertex, vertex, texts.vertex);
        const Object fragment(glCreateShader(GL_FRAGMENT_SHADER), glDeleteShader);
        compile(Step::compile_fragment, fragment, texts.fragment);

        for (const Object* shader : {&vertex, &fragment}) glAttachShader(program_.name(), shader->name());
        glLinkProgram(program_.name());
        // What is attached would live as long as the program.
        for (const Object* shader : {&vertex, &fragment}) glDetachShader(program_.name(), shader->name());
        require_success(Step::link, program_, GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog);
    }

    void use() override { glUseProgram(program_.name()); }

    bool set(const std::string& name, int value) override { return set_by(glProgramUniform1i, name, value); }
    bool set(const std::string& name, float value) override { return set_by(glProgramUniform1f, name, value); }
    bool set(const std::string& name, const glm::vec3& value) override
    {
        return set_by(glProgramUniform3fv, name, 1, value_ptr(value));
    }
    bool set(const std::string& name, const glm::vec4& value) override
    {
        return set_by(glProgramUniform4fv, name, 1, value_ptr(value));
    }
    bool set(const std::string& name, const glm::mat3& value) override
    {
        return set_by(glProgramUniformMatrix3fv, name, 1, GLboolean{GL_FALSE}, value_ptr(value));
    }
    bool set(const std::string& name, const glm::mat4& value) override
    {
        return set_by(glProgramUniformMatrix4fv, name, 1, GLboolean{GL_FALSE}, value_ptr(value));
    }

private:
    template <class Function, class... Values>
    bool set_by(Function* set_uniform, const std::string& name, Values... values)
    {
        const GLint location = glGetUniformLocation(program_.name(), name.c_str());
        if (location < 0) return false;
        set_uniform(program_.name(), location, values...);
        return true;
    }

    Object program_;
};

const char* const minimal_vertex = R"glsl(#version 330
in vec3 position;
in vec3 color;
uniform mat4 modelview;
uniform mat4 projection;
out vec3 vertex_color;
void main()
{
    gl_Position = projection * modelview * vec4(position, 1.0);
    vertex_color = color;
}
)glsl";

const char* const minimal_fragment = R"glsl(#version 330
in vec3 vertex_color;
out vec4 fragment_color;
void main() { fragment_color = vec4(vertex_color, 1.0); }
)glsl";

const char* const lit_vertex = R"glsl(#version 330
in vec3 position;
in vec3 normal;
in vec3 color;
in vec2 tex_coord;
uniform mat4 modelview;
uniform mat4 projection;
uniform mat3 normal_matrix;
out vec3 eye_position;
out vec3 eye_normal;
out vec3 vertex_color;
out vec2 vertex_tex_coord;
void main()
{
    vec4 place = modelview * vec4(position, 1.0);
    eye_position = place.xyz;
    eye_normal = normal_matrix * normal;
    vertex_color = color;
    vertex_tex_coord = tex_coord;
    gl_Position = projection * place;
}
)glsl";

const char* const lit_fragment = R"glsl(#version 330
in vec3 eye_position;
in vec3 eye_normal;
in vec3 vertex_color;
in vec2 vertex_tex_coord;
uniform vec3 light;
uniform sampler2D image;
uniform int lighting;
uniform int flat_shading;
uniform int textured;
out vec4 fragment_color;

vec3 surface_normal()
{
    // Both derivatives lie in the triangle; x to the right and y upwards leave the viewer on the side of their product.
    vec3 n = flat_shading == 1 ? cross(dFdx(eye_position), dFdy(eye_position)) : eye_normal;
    return normalize(n);
}

void main()
{
    vec3 color = textured == 1 ? texture(image, vertex_tex_coord).rgb : vertex_color;
    if (lighting == 1) color *= 0.25 + 0.75 * max(0.0, dot(surface_normal(), light));
    fragment_color = vec4(color, 1.0);
}
)glsl";

}

std::unique_ptr<ShaderProgram> make_shader_program(const ShaderTexts& texts)
{
    return std::make_unique<LinkedProgram>(texts);
}

ShaderTexts minimal_shaders() { return {minimal_vertex, minimal_fragment}; }

ShaderTexts lit_shaders() { return {lit_vertex, lit_fragment}; }

}
