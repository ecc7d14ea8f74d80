#include <glm/gtc/type_ptr.hpp>
#include <umbral/core/student_error.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/gl/shader_log.hpp>

namespace umbral::gl {
namespace {

/// Deletes the shader when done: a program keeps what it was linked from.
class Shader {
public:
    Shader(GLenum stage, const ShaderSource& source) : shader_(glCreateShader(stage))
    {
        const char* text = source.text.c_str();
        const auto size = static_cast<GLint>(source.text.size());
        glShaderSource(shader_, 1, &text, &size);
        glCompileShader(shader_);
        GLint compiled = GL_FALSE;
        glGetShaderiv(shader_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string message = source.file + " does not compile:\n" + with_file_name(log(), source.file);
        glDeleteShader(shader_);
        throw StudentError(StudentError::Kind::compile_error, message);
    }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { glDeleteShader(shader_); }

    [[nodiscard]] GLuint name() const { return shader_; }

private:
    [[nodiscard]] std::string log() const
    {
        GLint size = 0;
        glGetShaderiv(shader_, GL_INFO_LOG_LENGTH, &size);
        std::string text(static_cast<std::size_t>(size), '\0');
        glGetShaderInfoLog(shader_, size, nullptr, text.data());
        return text.c_str();
    }

    GLuint shader_;
};

std::string link_log(GLuint program)
{
    GLint size = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    glGetProgramInfoLog(program, size, nullptr, text.data());
    return text.c_str();
}

using Query = void (*)(GLuint, GLuint, GLsizei, GLsizei*, GLint*, GLenum*, GLchar*);

std::vector<Variable> active_variables(GLuint program, GLenum how_many, Query query)
{
    GLint count = 0;
    glGetProgramiv(program, how_many, &count);
    std::vector<Variable> variables;
    for (GLint i = 0; i < count; ++i) {
        char name[256] = {};
        GLint size = 0;
        GLenum type = 0;
        query(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
        Variable variable{name, type, size};
        if (variable.name == "gl_VertexID" || variable.name == "gl_InstanceID") continue;
        if (variable.name.ends_with("[0]")) variable.name.resize(variable.name.size() - 3);
        variables.push_back(variable);
    }
    return variables;
}

}

Program::Program(const ShaderSource& vertex, const ShaderSource& fragment)
{
    const Shader vertex_shader(GL_VERTEX_SHADER, vertex);
    const Shader fragment_shader(GL_FRAGMENT_SHADER, fragment);
    program_ = glCreateProgram();
    glAttachShader(program_, vertex_shader.name());
    glAttachShader(program_, fragment_shader.name());
    glLinkProgram(program_);
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    const std::string message = vertex.file + " and " + fragment.file + " compile, but do not link:\n" +
                                with_file_name(link_log(program_), "link");
    glDeleteProgram(program_);
    throw StudentError(StudentError::Kind::compile_error, message);
}

Program::~Program()
{
    if (has_context()) glDeleteProgram(program_);
}

void Program::use() const { glUseProgram(program_); }

Interface Program::interface() const
{
    return {active_variables(program_, GL_ACTIVE_ATTRIBUTES, glGetActiveAttrib),
            active_variables(program_, GL_ACTIVE_UNIFORMS, glGetActiveUniform)};
}

void Program::require_interface(const Interface& expected) const
{
    std::string message;
    for (const std::string& sentence : mismatches(expected, interface()))
        message += (message.empty() ? "" : "\n") + sentence;
    if (!message.empty()) throw StudentError(StudentError::Kind::interface_mismatch, message);
}

int Program::place(const std::string& name) const
{
    use();
    return glGetUniformLocation(program_, name.c_str());
}

int Program::attribute_location(const std::string& name) const { return glGetAttribLocation(program_, name.c_str()); }

void Program::set(const std::string& name, int value) const { glUniform1i(place(name), value); }
void Program::set(const std::string& name, float value) const { glUniform1f(place(name), value); }
void Program::set(const std::string& name, const glm::vec2& value) const
{
    glUniform2fv(place(name), 1, glm::value_ptr(value));
}
void Program::set(const std::string& name, const glm::vec3& value) const
{
    glUniform3fv(place(name), 1, glm::value_ptr(value));
}
void Program::set(const std::string& name, const glm::vec4& value) const
{
    glUniform4fv(place(name), 1, glm::value_ptr(value));
}
void Program::set(const std::string& name, const glm::mat3& value) const
{
    glUniformMatrix3fv(place(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const std::string& name, const glm::mat4& value) const
{
    glUniformMatrix4fv(place(name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const std::string& name, std::span<const float> values) const
{
    glUniform1fv(place(name), static_cast<GLsizei>(values.size()), values.data());
}
void Program::set(const std::string& name, std::span<const glm::vec3> values) const
{
    if (!values.empty()) glUniform3fv(place(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}
void Program::set(const std::string& name, std::span<const glm::vec4> values) const
{
    if (!values.empty()) glUniform4fv(place(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

}
