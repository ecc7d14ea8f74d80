#include <array>
#include <kit/varied.hpp>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "stage.hpp"
#include "texts.hpp"

namespace umbral {
namespace {

using namespace pipeline;
using Program = std::unique_ptr<ShaderProgram>;

/// What making a program says: the step that fails, and a log as its size and a sum that depends on every byte and its
/// place.
std::array<float, 3> answer_to(Recorder& out, const ShaderTexts& texts)
{
    try {
        const Program program = ask<make_shader_program>(out, texts);
        return {};
    } catch (const ShaderError& error) {
        const std::string_view log = error.what();
        std::uint32_t sum = 0;
        for (const char letter : log) sum = (31 * sum + static_cast<unsigned char>(letter)) % 1000003;
        return {static_cast<float>(error.step()), static_cast<float>(log.size()), static_cast<float>(sum)};
    }
}

void record_answer(Recorder& out, const ShaderTexts& texts)
{
    const auto [step, size, sum] = answer_to(out, texts);
    out.append("step", step);
    out.append("log", glm::vec2(size, sum));
}

// Between them programs that are right, so that who always throws is wrong as well.
void errors(Case& c, Recorder& out)
{
    std::size_t next = 0;
    const std::vector<ShaderTexts> right = right_texts();
    for (const ShaderTexts& texts : in_random_order(c.vary, failing_texts())) {
        record_answer(out, varied(c.vary, texts));
        const auto [step, size, sum] = answer_to(out, right[next++ % right.size()]);
        out.append("step", step);
    }
}

/// Which of the programs is in use: 1, 2, …; 0 for none, -1 for another.
float place_of(GLuint name, std::span<const GLuint> names)
{
    if (name == 0) return 0;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<float>(found - names.begin() + 1);
}

GLuint in_use()
{
    GLint name = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &name);
    return static_cast<GLuint>(name);
}

/// A uniform's numbers as the program has them; zeros if there is no program.
template <std::size_t count>
void append_values(std::vector<float>& row, GLuint program, const char* uniform)
{
    std::array<GLfloat, count> values{};
    if (glIsProgram(program) == GL_TRUE) glGetUniformfv(program, glGetUniformLocation(program, uniform), values.data());
    row.insert(row.end(), values.begin(), values.end());
}

std::vector<float> values_of(GLuint program)
{
    std::vector<float> row;
    append_values<1>(row, program, "whole");
    append_values<1>(row, program, "number");
    append_values<3>(row, program, "vectors[1]");
    append_values<4>(row, program, "lamp.vector4");
    append_values<9>(row, program, "matrix3");
    append_values<16>(row, program, "matrix4");
    return row;
}

/// One call of set(), of the overload for this type.
bool set_one(Recorder& out, ShaderProgram& program, const std::string& name, int value)
{
    return ask<static_cast<bool (ShaderProgram::*)(const std::string&, int)>(&ShaderProgram::set)>(out, program, name,
                                                                                                   value);
}
bool set_one(Recorder& out, ShaderProgram& program, const std::string& name, float value)
{
    return ask<static_cast<bool (ShaderProgram::*)(const std::string&, float)>(&ShaderProgram::set)>(out, program, name,
                                                                                                     value);
}
template <class Value>
bool set_one(Recorder& out, ShaderProgram& program, const std::string& name, const Value& value)
{
    return ask<static_cast<bool (ShaderProgram::*)(const std::string&, const Value&)>(&ShaderProgram::set)>(
        out, program, name, value);
}

/// A value as set() is given it. A float without a fraction is still one: another overload takes whole numbers.
template <class Value>
std::string value_text(const Value& value)
{
    const std::string text = literal::of_value(value, true, {});
    return std::is_same_v<Value, float> && text.find_first_of(".eF") == std::string::npos ? text + ".0F" : text;
}

/// What was done to the programs in one round, as code.
struct Round {
    std::string lines;
    std::string chosen;  ///< which program is set
};

/// Sets a program's uniforms, each by its own name or by one that the program has not; what set() returns.
std::vector<float> set_all(Recorder& out, ShaderProgram& program, Random& random, Round& round)
{
    glm::mat4 matrix(0);
    for (int i = 0; i < 4; ++i) matrix[i] = glm::vec4(random.in_cube(), random.uniform());
    const glm::vec3 vector = random.in_cube();
    const int whole = static_cast<int>(random.below(2'000'000)) - 1'000'000;
    const float number = random.uniform(1, 2);
    std::vector<float> returned;
    const auto set = [&](const char* name, const auto& value) {
        const bool absent = random.below(3) == 0;
        const std::string called = absent ? std::string("other_") + name : name;
        round.lines += round.chosen + "->set(\"" + called + "\", " + value_text(value) + ");\n";
        returned.push_back(set_one(out, program, called, value) ? 1.0F : 0.0F);
    };
    set("whole", whole);
    set("number", number);
    set("vectors[1]", vector);
    set("lamp.vector4", glm::vec4(vector, number));
    set("matrix3", glm::mat3(matrix));
    set("matrix4", matrix);
    return returned;
}

/// Another program that comes and goes, or fails: the one in use stays in use.
void come_and_go(Recorder& out, Random& random, Round& round)
{
    const std::uint32_t what = random.below(3);
    if (what == 1) {
        const Program other = ask<make_shader_program>(out, uniforms_elsewhere());
        round.lines += "make_shader_program(...).reset();\n";
    }
    if (what == 2) {
        const std::vector<ShaderTexts> failing = failing_texts();
        (void)answer_to(out, failing[random.below(static_cast<std::uint32_t>(failing.size()))]);
        round.lines += "make_shader_program(...);  // fails\n";
    }
}

// Three programs, two of them of the same texts; one is set while another, or none, is in use.
void uniforms(Case& c, Recorder& out)
{
    std::array<Program, 3> programs;
    std::array<GLuint, 3> names{};
    for (std::size_t i = 0; i < programs.size(); ++i) {
        programs[i] = ask_new<make_shader_program>(out, "program" + std::to_string(i),
                                                   i == 1 ? uniforms_elsewhere() : uniforms_of_all_types());
        if (!programs[i]) return;
        ask<&ShaderProgram::use>(out, *programs[i]);
        names[i] = in_use();
    }
    out.columns("returned", "whole, number, vectors[1], lamp.vector4, matrix3, matrix4");
    out.columns("state", "round or glGetError, program in use");
    out.columns("values", "whole, number, vectors[1]/3, lamp.vector4/4, matrix3/9, matrix4/16");
    for (int round = 0; round < 12; ++round) {
        const std::uint32_t chosen = c.random.below(3);
        const std::uint32_t active = (chosen + 1 + c.random.below(3)) % 4;
        if (active < 3)
            ask<&ShaderProgram::use>(out, *programs[active]);
        else
            glUseProgram(0);
        Round told{active < 3 ? "program" + std::to_string(active) + "->use();\n" : "glUseProgram(0);\n",
                   "program" + std::to_string(chosen)};
        come_and_go(out, c.random, told);
        const std::vector<float> returned = set_all(out, *programs[chosen], c.random, told);
        ask_in_words(out,
                     [&] { return "// three programs live: the first and the last of the same texts\n" + told.lines; });
        out.append("returned", std::span<const float>(returned));
        std::vector<float> state = {static_cast<float>(round), place_of(in_use(), names)};
        for (int i = 0; i < 16; ++i)  // bounded: each kind of error is noted once
            if (const GLenum error = glGetError(); error != GL_NO_ERROR) state[0] = static_cast<float>(error);
        out.append("state", std::span<const float>(state));
        for (const GLuint name : names) out.append("values", std::span<const float>(values_of(name)));
    }
}

/// How many programs and shaders there are.
glm::vec2 objects() { return {living(glIsProgram), living(glIsShader)}; }

// Shaders of programs that live may stay attached to them; so shaders are only compared across a failure, and at the
// end.
void leaks(Case&, Recorder& out)
{
    const glm::vec2 at_first = objects();
    std::vector<Program> programs;
    for (const ShaderTexts& texts : failing_texts()) {
        programs.push_back(ask<make_shader_program>(out, uniforms_of_all_types()));
        const glm::vec2 before(at_first.x, objects().y);
        (void)answer_to(out, texts);
        out.append("alive", objects() - before);
    }
    while (programs.size() > 1) {
        programs.pop_back();
        ask_in_words(out, [&] { return "programs.pop_back();  // leaves " + std::to_string(programs.size()); });
        out.append("alive", glm::vec2(objects().x - at_first.x, 0));
    }
    programs.clear();
    ask_in_words(out, [] { return "programs.clear();"; });
    out.append("alive", objects() - at_first);
}

void record_life(Case&, Recorder& out)
{
    gl::begin_trace();
    Program program = ask_new<make_shader_program>(out, "program", uniforms_of_all_types());
    gl::record_trace(out, "birth", gl::end_trace());
    gl::begin_trace();
    if (program) {
        set_one(out, *program, "number", 2.0F);
        ask<&ShaderProgram::use>(out, *program);
        set_one(out, *program, "whole", 3);
    }
    program.reset();
    gl::record_trace(out, "life and death", gl::end_trace());
}

void pictures(Case& c, Recorder& out)
{
    const glm::vec3 lamp = glm::normalize(c.vary.near(glm::vec3(-0.5F, 0.7F, 0.8F), 0.4F));
    const auto lit = [&](const std::vector<Shot>& shots, int size) {
        ask_shots(out, "lit_shaders()", shots);
        return draw(shots, lit_shaders(), lit_interface(), size);
    };
    const glm::mat4 model = seen(varied_turn(c.vary, 0.3F));
    out.image("switches", lit({{model, lamp, false, false, false},
                               {model, lamp, false, false, true},
                               {model, lamp, true, true, false},
                               {model, lamp, true, false, true}},
                              352));
    out.image("smooth", lit({{seen(varied_turn(c.vary, 1.1F)), lamp, true, false, false, true}}, 160));
    const glm::mat4 wide = seen(varied_turn(c.vary, 0.5F), {1.25F, 0.62F, 1});
    out.image("stretched", lit({{wide, lamp, true, false, false}}, 160));
}

void random(Case& c, Recorder& out)
{
    for (const char* name : {"first", "second"}) {
        Shot shot;
        const float turn = c.random.uniform(0, 6.28F);
        const float width = c.random.uniform(0.7F, 1.2F);
        shot.modelview = seen(turn, {width, c.random.uniform(0.7F, 1.2F), 1});
        shot.light = glm::normalize(c.random.in_cube() + glm::vec3(0, 0, 1.2F));
        shot.lighting = true;
        shot.textured = c.random.below(2) == 0;
        shot.flat = c.random.below(2) == 0;
        shot.cut = c.random.below(2) == 0;
        ask_shots(out, "lit_shaders()", {shot});
        out.image(name, draw({shot}, lit_shaders(), lit_interface(), 160));
    }
}

}

const Driver driver = {
    {"pictures", pictures},
    {"minimal",
     [](Case& c, Recorder& out) {
         const std::vector<Shot> shots{{seen(varied_turn(c.vary, -0.4F))}};
         ask_shots(out, "minimal_shaders()", shots);
         out.image("picture", draw(shots, minimal_shaders(), minimal_interface(), 192));
     }},
    {"errors", errors},
    {"long log",
     [](Case& c, Recorder& out) {
         for (const int count : {1, 40, 200, 1000})
             record_answer(out, varied(c.vary, with_many_errors(c.vary.near(count, count / 10))));
     }},
    {"uniforms", uniforms},
    {"leaks", leaks},
    {"calls", record_life},
    {"random", random},
};

}
