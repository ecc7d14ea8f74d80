#include <array>
#include <kit/varied.hpp>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "stage.hpp"
#include "texts.hpp"
#include "uniform_rounds.hpp"

namespace umbral {
namespace {

using namespace pipeline;

void record_answer(Recorder& out, const ShaderTexts& texts)
{
    out.columns("log", "bytes, their sum");
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

/// How many programs and shaders there are.
glm::vec2 objects() { return {living(glIsProgram), living(glIsShader)}; }

// Shaders of programs that live may stay attached to them; so shaders are only compared across a failure, and at the
// end.
void leaks(Case&, Recorder& out)
{
    out.columns("alive", "programs, shaders");
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
        set_one(out, *program, long_name, 2.0F);
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
                               {model, lamp, true, true, false, true},
                               {model, lamp, true, false, true}},
                              352));
    out.image("smooth", lit({{seen(varied_turn(c.vary, 1.1F)), lamp, true, false, false, true}}, 160));
    const glm::mat4 wide = seen(varied_turn(c.vary, 0.5F), {1.25F, 0.62F, 1});
    const glm::mat4 floor = ground(c.vary.near(0.4F, 0.2F));
    out.image("stretched", lit({{wide, lamp, true, false, false},
                                {wide, lamp, true, true, false},
                                {floor, lamp, true, false, false, false, true},
                                {floor, lamp, true, false, true, false, true}},
                               224));
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
         const std::vector<Shot> shots{{seen(varied_turn(c.vary, -0.4F))},
                                       {ground(c.vary.near(0.3F, 0.2F)), {}, false, false, false, false, true},
                                       {ground(c.vary.near(-0.5F, 0.2F)), {}, false, false, false, false, true},
                                       {seen(varied_turn(c.vary, 0.9F))}};
         ask_shots(out, "minimal_shaders()", shots);
         out.image("picture", draw(shots, minimal_shaders(), minimal_interface(), 224));
     }},
    {"errors", errors},
    {"long log",
     [](Case& c, Recorder& out) {
         for (const int count : {1, 40, 200, 1000})
             record_answer(out, varied(c.vary, with_many_errors(c.vary.near(count, count / 10))));
     }},
    {"uniforms",
     [](Case& c, Recorder& out) {
         record_uniforms(c.random, out);
         record_first_uniforms(c.random, out);
     }},
    {"leaks", leaks},
    {"calls", record_life},
    {"random", random},
};

}
