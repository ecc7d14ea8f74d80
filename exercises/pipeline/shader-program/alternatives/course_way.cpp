// alternative: the course's way: glUseProgram before each glUniform, and back; shaders stay attached until the program
// goes
#include <map>
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/program.hpp>

namespace umbral::pipeline {
namespace {

GLuint compiled(GLenum type, const std::string& text, ShaderError::Step step)
{
    const GLuint shader = glCreateShader(type);
    const GLchar* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        GLint length;
        glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
        std::vector<GLchar> log(static_cast<std::size_t>(length) + 1);
        glGetShaderInfoLog(shader, length + 1, nullptr, log.data());
        glDeleteShader(shader);
        throw ShaderError(step, log.data());
    }
    return shader;
}

class CourseProgram final : public ShaderProgram {
public:
    explicit CourseProgram(GLuint name) : name_(name) {}
    ~CourseProgram() override { glDeleteProgram(name_); }
    void use() override { glUseProgram(name_); }
    bool set(const std::string& name, int v) override
    {
        return with(name, [&](GLint l) { glUniform1i(l, v); });
    }
    bool set(const std::string& name, float v) override
    {
        return with(name, [&](GLint l) { glUniform1f(l, v); });
    }
    bool set(const std::string& name, const glm::vec3& v) override
    {
        return with(name, [&](GLint l) { glUniform3f(l, v.x, v.y, v.z); });
    }
    bool set(const std::string& name, const glm::vec4& v) override
    {
        return with(name, [&](GLint l) { glUniform4f(l, v.x, v.y, v.z, v.w); });
    }
    bool set(const std::string& name, const glm::mat3& v) override
    {
        return with(name, [&](GLint l) { glUniformMatrix3fv(l, 1, GL_TRUE, &transpose(v)[0].x); });
    }
    bool set(const std::string& name, const glm::mat4& v) override
    {
        return with(name, [&](GLint l) { glUniformMatrix4fv(l, 1, GL_FALSE, &v[0].x); });
    }

private:
    template <class F>
    bool with(const std::string& name, F set_uniform)
    {
        if (!locations_.count(name)) locations_[name] = glGetUniformLocation(name_, name.c_str());
        if (locations_[name] == -1) return false;
        GLint before;
        glGetIntegerv(GL_CURRENT_PROGRAM, &before);
        glUseProgram(name_);
        set_uniform(locations_[name]);
        glUseProgram(static_cast<GLuint>(before));
        return true;
    }

    GLuint name_;
    std::map<std::string, GLint> locations_;
};

}

std::unique_ptr<ShaderProgram> make_shader_program(const ShaderTexts& texts)
{
    const GLuint vertex = compiled(GL_VERTEX_SHADER, texts.vertex, ShaderError::Step::compile_vertex);
    GLuint fragment = 0;
    try {
        fragment = compiled(GL_FRAGMENT_SHADER, texts.fragment, ShaderError::Step::compile_fragment);
    } catch (const ShaderError&) {
        glDeleteShader(vertex);
        throw;
    }
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint ok;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok) return std::make_unique<CourseProgram>(program);
    GLint length;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), ' ');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteProgram(program);
    throw ShaderError(ShaderError::Step::link, log);
}

ShaderTexts minimal_shaders()
{
    return {
        "#version 400\nlayout(location = 3) in vec3 position; layout(location = 5) in vec3 color; uniform mat4 "
        "projection, modelview; out vec4 v_color;\n"
        "void main() { v_color = vec4(color, 1); gl_Position = (projection * modelview) * vec4(position, 1); }",
        "#version 400\nin vec4 v_color; layout(location = 0) out vec4 result; void main() { result = v_color; }"};
}

ShaderTexts lit_shaders()
{
    return {R"glsl(#version 330
in vec3 position, normal, color;
in vec2 tex_coord;
uniform mat4 modelview, projection;
uniform mat3 normal_matrix;
out vec4 var_posic_ec;
out vec3 var_normal_ec, var_color;
out vec2 var_coord_text;
void main()
{
    var_posic_ec = modelview * vec4(position, 1.0);
    var_normal_ec = normalize(normal_matrix * normal);
    var_color = color;
    var_coord_text = tex_coord;
    gl_Position = projection * var_posic_ec;
}
)glsl",
            R"glsl(#version 330
in vec4 var_posic_ec;
in vec3 var_normal_ec, var_color;
in vec2 var_coord_text;
uniform int lighting, flat_shading, textured;
uniform vec3 light;
uniform sampler2D image;
out vec4 result;
void main()
{
    vec3 base = var_color;
    if (textured == 1) base = texture(image, var_coord_text).rgb;
    vec3 n = normalize(var_normal_ec);
    if (flat_shading == 1) {
        n = normalize(cross(dFdx(var_posic_ec.xyz), dFdy(var_posic_ec.xyz)));
        if (dot(n, var_posic_ec.xyz) > 0.0) n = -n;
    }
    float factor = lighting == 1 ? 0.25 + 0.75 * clamp(dot(n, light), 0.0, 1.0) : 1.0;
    result = vec4(factor * base, 1.0);
}
)glsl"};
}

}
