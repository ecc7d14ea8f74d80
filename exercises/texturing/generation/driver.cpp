#include <kit/numbers_changed.hpp>
#include <span>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "measure.hpp"
#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

constexpr std::array all_generations = {Generation::off, Generation::object, Generation::eye};

// The course's own planes, and some that a hand can work out.
void planes(Case& c, Recorder& out)
{
    const auto record = [&](const char* name, const glm::vec3& origin, const glm::vec3& axis) {
        out.append(name, ask<plane_along>(out, origin, axis));
    };
    // Varied, they are turned exactly.
    const auto by_hand = [&](const glm::vec3& origin, const glm::vec3& axis) {
        const ExactMap map = c.vary.exact_map(1);
        record("by hand", map.place(origin), map.place(axis));
    };
    by_hand({0, 0, 0}, {1, 0, 0});
    by_hand({0, 0, 0}, {0, 1, 0});
    by_hand({2, 5, -1}, {0, 0, 4});
    by_hand({1, 2, 3}, {0.5F, -0.25F, 1});
    by_hand({-3, 0, 2}, {0, 0, 0});
    by_hand({4, -8, 16}, {-2, 0.5F, 0.125F});
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 origin = 4.0F * random_plane(c.random);
        const glm::vec3 axis = random_plane(c.random);
        record("random", origin, i % 8 == 0 ? glm::vec3(0) : axis);
        if (i % 5 != 1) continue;
        // Coordinates that are 0 or equal, and questions that differ in one number from the one before.
        for (const auto& [from, along] : numbers_changed(c.random, std::pair(origin, axis), 4))
            record("random", from, along);
        record("random", axis, axis);
        record("random", {0, 0, 0}, axis);
    }
}

/// Planes as programs have them: one coefficient is 0 in each, or all but one are.
Generator with_zeros(Random& random, Generator generator)
{
    for (glm::vec4* const plane : {&generator.s_plane, &generator.t_plane}) {
        const auto which = static_cast<glm::length_t>(random.below(4));
        glm::vec4 only(0);
        only[which] = (*plane)[which];
        (*plane)[which] = 0;
        if (random.below(3) == 0) *plane = only;
    }
    return generator;
}

/// Whatever the matrices are when the unit is called; and, half of the times, what somebody else has told OpenGL about
/// texture coordinates since the last call.
void choose_state(Random& random)
{
    if (random.below(2) == 0) choose_generators(random);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(value_ptr(random_modelview(random)));
    constexpr std::array modes = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
    glMatrixMode(static_cast<GLenum>(modes[random.below(3)]));
}

void set(Recorder& out, const Generator& generator) { ask<set_generator>(out, generator); }

// Each generator is set under one matrix, and used for several vertices under others. Now and then it is the one
// before, or differs from it in one plane or in the mode only: others may have set their own in between.
void fixed(Case& c, Recorder& out, const char* name, int rounds)
{
    const gl::Framebuffer target(8, 8);
    const FixedProbe probe;
    Generator generator;
    for (int round = 0; round < rounds; ++round) {
        const Generation generation = round < 2 ? Generation::off : all_generations[c.random.below(3)];
        Generator other = random_generator(c.random, generation);
        if (round % 4 == 0) other = with_zeros(c.random, other);
        if (round % 3 != 2) generator = other;
        if (round % 12 == 5) generator.s_plane = other.s_plane;
        if (round % 12 == 8) generator.t_plane = other.t_plane;
        if (round % 12 == 11) generator.generation = other.generation;
        choose_state(c.random);
        set(out, generator);
        for (int i = 0; i < 4; ++i) out.append(name, probe.read(random_vertex(c.random)));
    }
}

// From one mode to the same one or another, in every order; planes of the one not used are kept by OpenGL.
void sequence(Case& c, Recorder& out)
{
    const gl::Framebuffer target(8, 8);
    const FixedProbe probe;
    for (const Generation first : all_generations)
        for (const Generation second : all_generations)
            for (const Generation third : all_generations)
                for (const Generation generation : {first, second, third}) {
                    const Generator generator = random_generator(c.random, generation);
                    choose_state(c.random);
                    set(out, generator);
                    out.append("st", probe.read(random_vertex(c.random)));
                }
}

void shader(Case& c, Recorder& out, const char* name, int rounds)
{
    const ShaderProbe probe(ask<generator_vertex_shader>(out));
    for (int round = 0; round < rounds; ++round)
        for (const Generation generation : all_generations) {
            Generator generator = random_generator(c.random, generation);
            if (round % 4 == 0) generator = with_zeros(c.random, generator);
            const Vertex vertex = random_vertex(c.random);
            const glm::vec2 color(c.random.uniform(), vertex.tex_coord.y);
            out.columns(name, "st.s, st.t, shade.r, shade.g");
            out.append(name, probe.read(vertex, generator, color));
        }
}

float integer(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<float>(value);
}

/// What the unit must leave alone, and the four switches.
void record_state(Recorder& out)
{
    std::vector<float> row;
    for (const GLenum name :
         {GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH,
          GL_ATTRIB_STACK_DEPTH, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q, GL_TEXTURE_2D,
          GL_LIGHTING, GL_ACTIVE_TEXTURE, GL_CURRENT_PROGRAM})
        row.push_back(integer(name));
    row.push_back(static_cast<float>(glGetError()));
    for (const GLenum name : {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX}) {
        std::array<GLfloat, 16> matrix{};
        glGetFloatv(name, matrix.data());
        row.insert(row.end(), matrix.begin(), matrix.end());
    }
    out.columns("left",
                "GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH, "
                "GL_ATTRIB_STACK_DEPTH, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q, "
                "GL_TEXTURE_2D, GL_LIGHTING, GL_ACTIVE_TEXTURE, GL_CURRENT_PROGRAM, glGetError, "
                "GL_MODELVIEW_MATRIX/16, GL_PROJECTION_MATRIX/16, GL_TEXTURE_MATRIX/16");
    out.append("left", std::span<const float>(row));
}

void state(Case& c, Recorder& out)
{
    for (int round = 0; round < 24; ++round) {
        const Generation generation = all_generations[static_cast<std::size_t>(round) % 3];
        const Generator generator = random_generator(c.random, generation);
        for (const GLenum mode : {GL_PROJECTION, GL_TEXTURE}) {
            glMatrixMode(mode);
            glLoadMatrixf(value_ptr(random_modelview(c.random)));
        }
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(random_modelview(c.random)));
        constexpr std::array modes = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
        c.random.below(2) == 0 ? glEnable(GL_TEXTURE_2D) : glDisable(GL_TEXTURE_2D);
        glActiveTexture(GL_TEXTURE0 + c.random.below(4));
        for (const GLenum other : {GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
            c.random.below(2) == 0 ? glEnable(other) : glDisable(other);
        // Room for one matrix more.
        glMatrixMode(GL_MODELVIEW);
        GLint most = 0;
        glGetIntegerv(GL_MAX_MODELVIEW_STACK_DEPTH, &most);
        const int pushed = round % 2 == 0 ? 0 : most - 2;
        for (int i = 0; i < pushed; ++i) glPushMatrix();
        glMatrixMode(static_cast<GLenum>(modes[c.random.below(3)]));
        set(out, generator);
        record_state(out);
        glMatrixMode(GL_MODELVIEW);
        for (int i = 0; i < pushed; ++i) glPopMatrix();
    }
    glActiveTexture(GL_TEXTURE0);
}

}

const Driver driver = {
    {"board", [](Case& c, Recorder& out) { out.image("picture", board(out, 480, 360, c.vary)); }},
    {"planes", planes},
    {"fixed", [](Case& c, Recorder& out) { fixed(c, out, "st", 60); }},
    {"sequence", sequence},
    {"shader", [](Case& c, Recorder& out) { shader(c, out, "values", 60); }},
    {"state", state},
    {"random",
     [](Case& c, Recorder& out) {
         fixed(c, out, "fixed", 30);
         shader(c, out, "shader", 30);
     }},
};

}
