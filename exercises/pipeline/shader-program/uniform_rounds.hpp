#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <umbral/core/random.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/record/ask.hpp>

#include "texts.hpp"

/// Programs that come, are set, used, and go: what their uniforms hold afterwards, and which program is in use.
namespace umbral::pipeline {

using Program = std::unique_ptr<ShaderProgram>;

/// What making a program says: the step that fails, and a log as its size and a sum that depends on every byte and its
/// place.
inline std::array<float, 3> answer_to(Recorder& out, const ShaderTexts& texts)
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

/// Which of the programs is in use: 1, 2, …; 0 for none, -1 for another.
inline float place_of(GLuint name, std::span<const GLuint> names)
{
    if (name == 0) return 0;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<float>(found - names.begin() + 1);
}

inline GLuint in_use()
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

inline std::vector<float> values_of(GLuint program)
{
    std::vector<float> row;
    append_values<1>(row, program, "whole");
    append_values<1>(row, program, long_name);
    append_values<3>(row, program, "vectors[1]");
    append_values<4>(row, program, "lamp.vector4");
    append_values<9>(row, program, "matrix3");
    append_values<16>(row, program, "matrix4");
    return row;
}

/// One call of set(), of the overload for this type.
inline bool set_one(Recorder& out, ShaderProgram& program, const std::string& name, int value)
{
    return ask<static_cast<bool (ShaderProgram::*)(const std::string&, int)>(&ShaderProgram::set)>(out, program, name,
                                                                                                   value);
}
inline bool set_one(Recorder& out, ShaderProgram& program, const std::string& name, float value)
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

/// Sets a program's uniforms, the whole number to `whole`, each by its own name or, of so many one, by a name that the
/// program has not; what set() returns.
inline std::vector<float> set_all(Recorder& out, ShaderProgram& program, Random& random, Round& round, int whole,
                                  std::uint32_t one_absent_of = 3)
{
    glm::mat4 matrix(0);
    for (int i = 0; i < 4; ++i) matrix[i] = glm::vec4(random.in_cube(), random.uniform());
    const glm::vec3 vector = random.in_cube();
    const float number = random.uniform(1, 2);
    std::vector<float> returned;
    const auto set = [&](const char* name, const auto& value) {
        const bool absent = one_absent_of > 0 && random.below(one_absent_of) == 0;
        const std::string called = absent ? std::string("other_") + name : name;
        round.lines += round.chosen + "->set(\"" + called + "\", " + value_text(value) + ");\n";
        returned.push_back(set_one(out, program, called, value) ? 1.0F : 0.0F);
    };
    set("whole", whole);
    set(long_name, number);
    set("vectors[1]", vector);
    set("lamp.vector4", glm::vec4(vector, number));
    set("matrix3", glm::mat3(matrix));
    set("matrix4", matrix);
    return returned;
}

/// Rows of what happens in rounds, and how they are explained.
inline void record_round(Recorder& out, const Round& told, const std::vector<float>& returned)
{
    ask_in_words(out,
                 [&] { return "// three programs live: the first and the last of the same texts\n" + told.lines; });
    out.append("returned", std::span<const float>(returned));
}

/// Another program that comes, is set and goes, or fails: the one in use stays in use.
inline void come_and_go(Recorder& out, Random& random, Round& round, int whole)
{
    const std::uint32_t what = random.below(4);
    if (what == 3) {
        const std::vector<ShaderTexts> failing = failing_texts();
        (void)answer_to(out, failing[random.below(static_cast<std::uint32_t>(failing.size()))]);
        round.lines += "make_shader_program(...);  // fails\n";
        return;
    }
    const Program other =
        ask_new<make_shader_program>(out, "passing", what == 0 ? uniforms_elsewhere() : uniforms_of_all_types());
    if (!other) return;
    GLint before = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &before);
    ask<&ShaderProgram::use>(out, *other);
    const GLuint name = in_use();
    glUseProgram(static_cast<GLuint>(before));
    Round told{"passing->use();\nglUseProgram(...);  // the one before\n", "passing"};
    const std::vector<float> returned = set_all(out, *other, random, told, whole);
    round.lines += told.lines + "passing.reset();\n";
    record_round(out, told, returned);
    out.append("values", std::span<const float>(values_of(name)));
}

/// Programs whose first uniform is of each type in turn: what set() returns, and what they hold. Of the array the first
/// vector is set too, since only that one can be the program's first.
inline void record_first_uniforms(Random& random, Recorder& out)
{
    out.columns("first",
                "whole, number, vectors[1], lamp.vector4, matrix3, matrix4, vectors[0], whole, number, vectors[1]/3, "
                "lamp.vector4/4, matrix3/9, matrix4/16, vectors[0]/3");
    for (int first = 0; first < uniform_types; ++first) {
        const Program program = ask_new<make_shader_program>(out, "program", uniforms_beginning_with(first));
        if (!program) return;
        ask<&ShaderProgram::use>(out, *program);
        Round told{"program->use();\n", "program"};
        std::vector<float> row = set_all(out, *program, random, told, 1 + static_cast<int>(random.below(1000)), 0);
        const glm::vec3 vector = random.in_cube();
        told.lines += "program->set(\"vectors[0]\", " + value_text(vector) + ");\n";
        row.push_back(set_one(out, *program, "vectors[0]", vector) ? 1.0F : 0.0F);
        const std::vector<float> values = values_of(in_use());
        row.insert(row.end(), values.begin(), values.end());
        append_values<3>(row, in_use(), "vectors[0]");
        ask_in_words(out, [&] {
            return "// what it declares first is what line " + std::to_string(first + 2) + " sets\n" + told.lines;
        });
        out.append("first", std::span<const float>(row));
        glUseProgram(0);
    }
}

/// Three programs, two of them of the same texts; one is set while another, or none, is in use. OpenGL may have been
/// told so without asking the program.
inline void record_uniforms(Random& random, Recorder& out)
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
    // Two numbers by turns: the same is set again.
    const std::array wholes = {1 + static_cast<int>(random.below(1'000'000)),
                               -1 - static_cast<int>(random.below(1'000'000))};
    for (int round = 0; round < 16; ++round) {
        const std::uint32_t chosen = random.below(3);
        const std::uint32_t active = (chosen + 1 + random.below(3)) % 4;
        const bool directly = active == 3 || random.below(2) == 0;
        const std::string asked = "program" + std::to_string(active);
        Round told{active == 3 ? "glUseProgram(0);\n"
                   : directly  ? "glUseProgram(...);  // that of " + asked + "\n"
                               : asked + "->use();\n",
                   "program" + std::to_string(chosen)};
        if (directly)
            glUseProgram(active == 3 ? 0 : names[active]);
        else
            ask<&ShaderProgram::use>(out, *programs[active]);
        come_and_go(out, random, told, wholes[random.below(2)]);
        const std::vector<float> returned = set_all(out, *programs[chosen], random, told, wholes[random.below(2)]);
        record_round(out, told, returned);
        std::vector<float> state = {static_cast<float>(round), place_of(in_use(), names)};
        for (int i = 0; i < 16; ++i)  // bounded: each kind of error is noted once
            if (const GLenum error = glGetError(); error != GL_NO_ERROR) state[0] = static_cast<float>(error);
        out.append("state", std::span<const float>(state));
        for (const GLuint name : names) out.append("values", std::span<const float>(values_of(name)));
    }
}

}
