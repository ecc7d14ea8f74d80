#include <umbral/core/student_error.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/shader_log.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

namespace umbral::gl {
namespace {

using Shaders = GlTest;

/// The error that making a program gives; fails the test if there is none.
std::pair<StudentError::Kind, std::string> error_of(const char* vertex, const char* fragment)
{
    try {
        const Program program(vertex_source(vertex), fragment_source(fragment));
    } catch (const StudentError& error) {
        return {error.kind(), error.what()};
    }
    ADD_FAILURE() << "the program was made";
    return {};
}

TEST_F(Shaders, compile_errors_name_the_students_file_and_line)
{
    const auto [kind, text] =
        error_of(plain_vertex, "#version 330\nout vec4 result;\nvoid main()\n{\n    result = vec4(colour, 1.0);\n}\n");
    EXPECT_EQ(kind, StudentError::Kind::compile_error);
    EXPECT_NE(text.find("test.frag:5: error"), std::string::npos) << text;
    EXPECT_NE(text.find("colour"), std::string::npos) << text;
    const auto [vertex_kind, vertex_text] = error_of("#version 330\nvoid main() { gl_Position = 1 }\n", plain_fragment);
    EXPECT_EQ(vertex_kind, StudentError::Kind::compile_error);
    EXPECT_NE(vertex_text.find("test.vert:2: error"), std::string::npos) << vertex_text;
}

TEST_F(Shaders, link_errors_are_the_students_too)
{
    const auto [kind, text] =
        error_of("#version 330\nout vec3 shade;\nvoid main() { shade = vec3(1.0); gl_Position = vec4(0.0); }\n",
                 "#version 330\nin vec4 shade;\nout vec4 result;\nvoid main() { result = shade; }\n");
    EXPECT_EQ(kind, StudentError::Kind::compile_error);
    EXPECT_NE(text.find("shade"), std::string::npos) << text;
}

TEST_F(Shaders, empty_and_hostile_sources_are_refused_not_crashed_on)
{
    EXPECT_EQ(error_of("", "").first, StudentError::Kind::compile_error);
    EXPECT_EQ(error_of("#version 330\n#error 0:1(2): text\n", plain_fragment).first, StudentError::Kind::compile_error);
    const std::string deep = "#version 330\nout vec4 r; void main() { r = " + std::string(200, '(') + "; }";
    EXPECT_EQ(error_of(plain_vertex, deep.c_str()).first, StudentError::Kind::compile_error);
}

const Interface expected{{{"position", GL_FLOAT_VEC3, 1}, {"normal", GL_FLOAT_VEC3, 1}},
                         {{"color", GL_FLOAT_VEC4, 1}, {"weights", GL_FLOAT, 4}, {"model", GL_FLOAT_MAT4, 1}}};

std::string mismatch_of(const char* vertex, const char* fragment)
{
    const Program program(vertex_source(vertex), fragment_source(fragment));
    try {
        program.require_interface(expected);
    } catch (const StudentError& error) {
        EXPECT_EQ(error.kind(), StudentError::Kind::interface_mismatch);
        return error.what();
    }
    return "";
}

TEST_F(Shaders, introspection_lists_what_is_used)
{
    const Program program(
        vertex_source(
            "#version 330\nin vec3 position; uniform mat4 model; uniform float weights[4]; uniform vec2 unused;\n"
            "void main() { gl_Position = model * vec4(position, weights[3] + float(gl_VertexID)); }\n"),
        fragment_source(plain_fragment));
    const Interface found = program.interface();
    ASSERT_EQ(found.attributes.size(), 1U);
    EXPECT_EQ(found.attributes[0], (Variable{"position", GL_FLOAT_VEC3, 1}));
    EXPECT_EQ(found.uniforms.size(), 3U);
    EXPECT_NE(std::find(found.uniforms.begin(), found.uniforms.end(), Variable{"weights", GL_FLOAT, 4}),
              found.uniforms.end());
    EXPECT_EQ(missing_names(expected, found), std::vector<std::string>{"normal"});
    EXPECT_NO_THROW(program.require_interface(expected));
}

TEST_F(Shaders, mismatches_name_what_is_expected_and_what_came)
{
    EXPECT_EQ(mismatch_of(plain_vertex, plain_fragment), "");
    EXPECT_EQ(mismatch_of(plain_vertex,
                          "#version 330\nuniform vec3 color; out vec4 r; void main() { r = vec4(color, 1.0); }\n"),
              "your uniform is declared 'vec3 color', expected 'vec4 color'");
    EXPECT_EQ(mismatch_of("#version 330\nin vec2 position; uniform float weights[5];\nvoid main() { gl_Position = "
                          "vec4(position, weights[4], 1.0); }\n",
                          plain_fragment),
              "your attribute is declared 'vec2 position', expected 'vec3 position'\n"
              "your uniform is declared 'float weights[5]', expected 'float weights[4]'");
    EXPECT_EQ(mismatch_of("#version 330\nin vec3 position; uniform mat4 modle;\nvoid main() { gl_Position = modle * "
                          "vec4(position, 1.0); }\n",
                          plain_fragment),
              "your uniform 'mat4 modle' is not part of the interface, so nothing gives it a value; expected one of: "
              "color, weights, model");
}

TEST_F(Shaders, uniforms_arrive_in_the_shader)
{
    const Framebuffer target(1, 1);
    target.clear();
    const Program program(
        vertex_source(plain_vertex),
        fragment_source(
            "#version 330\nuniform mat4 model; uniform mat3 turn; uniform vec3 list[3]; uniform vec4 fours[2];\n"
            "uniform float weights[3]; uniform int which; uniform vec2 pair; uniform float one;\nout vec4 result;\n"
            "void main() { result = vec4(model[3][1] + turn[2][0] + one, list[which].z, weights[2] + pair.y, "
            "fours[1].w); }\n"));
    glm::mat4 model(0);
    model[3][1] = 0.2F;  // column 3, row 1, in GLM and in GLSL
    glm::mat3 turn(0);
    turn[2][0] = 0.2F;
    program.set("model", model);
    program.set("turn", turn);
    program.set("one", 0.2F);
    program.set("which", 1);
    program.set("pair", glm::vec2(0, 0.2F));
    program.set("list", std::array{glm::vec3(0), glm::vec3(0, 0, 0.8F), glm::vec3(0)});
    program.set("fours", std::array{glm::vec4(0), glm::vec4(0, 0, 0, 0.4F)});
    program.set("weights", std::array{0.0F, 0.0F, 0.2F});
    program.set("not there", 1.0F);
    rectangle(-1, 1, -1, 1).draw(program);
    EXPECT_EQ(target.read_pixels().at(0, 0), glm::u8vec4(153, 204, 102, 102));
    EXPECT_NO_THROW(check_errors("setting uniforms"));
}

TEST(ShaderLog, renames_only_what_names_a_place)
{
    EXPECT_EQ(with_file_name("0:12(5): error: x\n", "phong.frag"), "phong.frag:12: error: x");
    EXPECT_EQ(with_file_name("0(7) : error C1008: y\n", "phong.frag"), "phong.frag:7: error C1008: y");
    EXPECT_EQ(with_file_name("a note\n0:1(2): warning: w\n", "a.vert"), "a note\na.vert:1: warning: w");
    for (const char* odd : {"0:12", "0:(5): z", "0:12(5)", "12", "0(7)", ":12(5): e", "0::1"})
        EXPECT_EQ(with_file_name(odd, "f"), odd);
    EXPECT_EQ(with_file_name("", "f"), "");
}

TEST(ShaderLog, is_bounded)
{
    std::string log;
    for (int i = 0; i < 1000; ++i) log += "0:1(1): error: again\n";
    const std::string text = with_file_name(log, "f");
    EXPECT_LT(text.size(), 1000U);
    EXPECT_NE(text.find("980 lines more"), std::string::npos) << text;
}

}
}
