#pragma once

#include "plain.hpp"

/// Cases of rubric line 6: directions and lights.
namespace umbral::texturing {

// Rubric 6: lights.

inline void directions(Case& c, Recorder& out)
{
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    for (const glm::vec2 angles : {glm::vec2(0, 0),
                                   {quarter, 0},
                                   {-quarter, 0},
                                   {2 * quarter, 0},
                                   {0, quarter},
                                   {0, -quarter},
                                   {quarter / 3, quarter / 3},
                                   {-quarter / 2, -quarter / 3}})
        out.append("by hand", ask<direction>(out, angles.x, angles.y));
    for (int i = 0; i < 200; ++i) {
        const float alpha = c.random.uniform(-6.3F, 6.3F);
        out.append("random", ask<direction>(out, alpha, c.random.uniform(-quarter, quarter)));
        // The same turn at another height, and that height at another turn.
        if (i % 20 != 0) continue;
        const float beta = c.random.uniform(-quarter, quarter);
        for (const float other : {alpha, 0.5F * alpha, 0.0F}) out.append("random", ask<direction>(out, other, beta));
        out.append("random", ask<direction>(out, alpha, 0));
    }
}

inline void record_lights(Recorder& out)
{
    std::array<GLfloat, 4> value{};
    std::vector<float> row;
    glGetFloatv(GL_LIGHT_MODEL_AMBIENT, value.data());
    row.insert(row.end(), value.begin(), value.begin() + 3);
    GLint control = 0;
    glGetIntegerv(GL_LIGHT_MODEL_COLOR_CONTROL, &control);
    row.push_back(control == GL_SEPARATE_SPECULAR_COLOR ? 1.0F : 0.0F);
    // Highlights are those of a viewer far away.
    GLint local = 0;
    glGetIntegerv(GL_LIGHT_MODEL_LOCAL_VIEWER, &local);
    row.push_back(local != 0 ? 1.0F : 0.0F);
    GLint depth = 0;
    glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
    row.push_back(static_cast<float>(depth));
    glm::mat4 stack(0);
    glGetFloatv(GL_MODELVIEW_MATRIX, value_ptr(stack));
    for (int i = 0; i < 16; ++i) row.push_back(stack[i / 4][i % 4]);
    out.columns("model",
                "GL_LIGHT_MODEL_AMBIENT/3, separate specular, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_MODELVIEW_STACK_DEPTH, "
                "GL_MODELVIEW_MATRIX/16");
    out.append("model", std::span<const float>(row));
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light) {
        const bool on = glIsEnabled(light) == GL_TRUE;
        std::vector<float> told{on ? 1.0F : 0.0F};
        for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION}) {
            glGetLightfv(light, part, value.data());
            // A direction may have any length.
            const glm::vec3 place(value[0], value[1], value[2]);
            if (part == GL_POSITION && value[3] == 0 && place != glm::vec3(0))
                for (int i = 0; i < 3; ++i) value[static_cast<std::size_t>(i)] = normalize(place)[i];
            for (std::size_t i = 0; i < (part == GL_POSITION ? 4U : 3U); ++i) told.push_back(on ? value[i] : 0);
        }
        for (const GLenum part : {GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_SPOT_CUTOFF}) {
            glGetLightfv(light, part, value.data());
            told.push_back(on ? value[0] : 0);
        }
        out.columns("lights",
                    "enabled, GL_AMBIENT/3, GL_DIFFUSE/3, GL_SPECULAR/3, GL_POSITION/4, GL_CONSTANT_ATTENUATION, "
                    "GL_LINEAR_ATTENUATION, GL_SPOT_CUTOFF");
        out.append("lights", std::span<const float>(told));
    }
}

inline glm::mat4 random_view(Random& random)
{
    const glm::vec3 axis = random.unit_vector();
    return rotate(translate(glm::mat4(1), 4.0F * random.in_cube()), random.uniform(0, 3), axis);
}

inline void lights(Case& c, Recorder& out)
{
    for (const std::size_t count : {2U, 8U, 3U, 0U, 1U}) {
        std::vector<Light> all(count);
        for (Light& light : all) {
            light.color = 0.5F * (c.random.in_cube() + 1.0F);
            light.directional = c.random.below(2) == 0;
            light.alpha = c.random.uniform(-3, 3);
            light.beta = c.random.uniform(-1.5F, 1.5F);
            light.position = 5.0F * c.random.in_cube();
        }
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(random_view(c.random)));
        const glm::mat4 view = random_view(c.random);
        ask<activate_lights>(out, all, view);
        record_lights(out);
        if (count < 2) continue;
        // Seen from elsewhere; and as many others from there, of which some lack a colour.
        const glm::mat4 other = random_view(c.random);
        ask<activate_lights>(out, all, other);
        record_lights(out);
        for (std::size_t i = 0; i < count; ++i) {
            all[i].color[static_cast<int>((count + i) % 3)] = 0;
            all[i].directional = !all[i].directional;
        }
        ask<activate_lights>(out, all, other);
        record_lights(out);
    }
}

}
