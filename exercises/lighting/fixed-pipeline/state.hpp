#pragma once

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>
#include <umbral/gl/opengl.hpp>
#include <utility>
#include <vector>

#include "../random.hpp"

/// OpenGL's state about lighting: what stands there before the unit is called, and what is read afterwards.
namespace umbral::lighting {

inline constexpr GLenum light_name(int i) { return static_cast<GLenum>(GL_LIGHT0 + i); }

inline void switch_on(GLenum name, bool on) { on ? glEnable(name) : glDisable(name); }

inline bool coin(Random& random) { return random.below(2) == 0; }

inline void disturb_lights(Random& random)
{
    for (int i = 0; i < 8; ++i) {
        switch_on(light_name(i), coin(random));
        for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION}) {
            const glm::vec4 number(random_color(random), 1);
            glLightfv(light_name(i), part, glm::value_ptr(number));
        }
        const glm::vec3 direction = random.unit_vector();
        glLightfv(light_name(i), GL_SPOT_DIRECTION, glm::value_ptr(direction));
        glLightf(light_name(i), GL_SPOT_CUTOFF, random.uniform(10, 80));
        glLightf(light_name(i), GL_SPOT_EXPONENT, random.uniform(0, 20));
        glLightf(light_name(i), GL_CONSTANT_ATTENUATION, random.uniform(1.2F, 2));
        glLightf(light_name(i), GL_LINEAR_ATTENUATION, random.uniform(0.1F, 1));
        glLightf(light_name(i), GL_QUADRATIC_ATTENUATION, random.uniform(0.1F, 1));
    }
}

inline void disturb_materials(Random& random)
{
    constexpr std::array tracked = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
    const glm::vec3 color = random_color(random);
    glColor3fv(glm::value_ptr(color));
    glColorMaterial(GL_FRONT_AND_BACK, tracked[random.below(5)]);
    switch_on(GL_COLOR_MATERIAL, coin(random));
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        for (const GLenum part : {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
            const glm::vec4 number(random_color(random), 0.25F);
            glMaterialfv(face, part, glm::value_ptr(number));
        }
        glMaterialf(face, GL_SHININESS, random.uniform(1, 100));
    }
}

/// Leaves matrix mode, matrices and depths of the stacks as nobody can have expected them.
inline void disturb_matrices(Random& random)
{
    for (const auto& [mode, depth_name, most_name] :
         {std::tuple<GLenum, GLenum, GLenum>{GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH},
          {GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH}}) {
        glMatrixMode(mode);
        GLint depth = 1;
        for (glGetIntegerv(depth_name, &depth); depth > 1; --depth) glPopMatrix();
        // Of two stacks one has place for two more, and no others.
        GLint most = 0;
        glGetIntegerv(most_name, &most);
        const GLint pushes = coin(random) ? most - 3 : static_cast<GLint>(random.below(3));
        for (GLint i = 0; i <= pushes; ++i) {
            glm::mat4 matrix(1);
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 3; ++row) matrix[column][row] += random.uniform(-2, 2);
            glLoadMatrixf(glm::value_ptr(matrix));
            if (i < pushes) glPushMatrix();
        }
    }
    constexpr std::array modes = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
    glMatrixMode(static_cast<GLenum>(modes[random.below(3)]));
}

/// Arrays that others have drawn from: told, and not enabled any more.
inline void disturb_arrays(Random& random)
{
    constexpr std::array types = {GL_SHORT, GL_FLOAT, GL_DOUBLE};
    glVertexPointer(2 + static_cast<GLint>(random.below(3)), static_cast<GLenum>(types[random.below(3)]), 40, nullptr);
    glNormalPointer(static_cast<GLenum>(types[random.below(3)]), 24, nullptr);
}

/// Everything that the unit must not rely on. `matrices` only where nobody needs those that are there.
inline void disturb(Random& random)
{
    disturb_lights(random);
    disturb_materials(random);
    disturb_matrices(random);
    disturb_arrays(random);
    const glm::vec4 ambient(random_color(random), 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, coin(random) ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, coin(random) ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, coin(random) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    glShadeModel(coin(random) ? GL_FLAT : GL_SMOOTH);
    glFrontFace(coin(random) ? GL_CW : GL_CCW);
    for (const GLenum name : {GL_LIGHTING, GL_NORMALIZE, GL_RESCALE_NORMAL}) switch_on(name, coin(random));
}

inline void append_integer(std::vector<float>& row, GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    row.push_back(static_cast<float>(value));
}

/// GL_POSITION of a light, in eye coordinates.
inline glm::vec4 position_of_light(int i)
{
    glm::vec4 position(0);
    glGetLightfv(light_name(i), GL_POSITION, glm::value_ptr(position));
    return position;
}

/// Red, green and blue of its three colours.
inline std::array<float, 9> colors_of_light(int i)
{
    std::array<float, 9> colors{};
    std::size_t at = 0;
    for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
        std::array<float, 4> color{};
        glGetLightfv(light_name(i), part, color.data());
        for (std::size_t k = 0; k < 3; ++k) colors[at++] = color[k];
    }
    return colors;
}

/// Four colours with alpha, and the exponent.
inline std::array<float, 17> material_of(GLenum face)
{
    std::array<float, 17> numbers{};
    std::size_t at = 0;
    for (const GLenum part : {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
        glGetMaterialfv(face, part, &numbers[at]);
        at += 4;
    }
    glGetMaterialfv(face, GL_SHININESS, &numbers[at]);
    return numbers;
}

inline constexpr const char* neutral_columns =
    "GL_MATRIX_MODE, modelview depth, projection depth, modelview/16, projection/16, light 0 on, light 1 on, light 7 "
    "on, light 0 position/4, light 0 colours/9, light 7 colours/9, light 0 cutoff, front material/17, back "
    "material/17, A_G/4, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE, GL_SHADE_MODEL, GL_FRONT_FACE, "
    "GL_LIGHTING, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_COLOR_MATERIAL, GL_COLOR_MATERIAL_PARAMETER, GL_VERTEX_ARRAY, "
    "GL_NORMAL_ARRAY, GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_CULL_FACE, "
    "GL_DEPTH_TEST, GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH, GL_LIGHT_MODEL_COLOR_CONTROL, "
    "GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, "
    "glGetError, GL_CURRENT_COLOR/4, light 3 position/4, light 3 colours/9, light 3 direction/3, light 3 exponent, "
    "light 3 "
    "attenuation/3";

/// All that draw_lit has to put back, as one row of numbers.
inline std::vector<float> neutral_state()
{
    std::vector<float> row;
    const auto append_floats = [&](GLenum name, std::size_t count) {
        std::array<float, 16> numbers{};
        glGetFloatv(name, numbers.data());
        row.insert(row.end(), numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count));
    };
    const auto append_all = [&](const auto& numbers) { row.insert(row.end(), numbers.begin(), numbers.end()); };
    for (const GLenum name : {GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH})
        append_integer(row, name);
    append_floats(GL_MODELVIEW_MATRIX, 16);
    append_floats(GL_PROJECTION_MATRIX, 16);
    for (const int i : {0, 1, 7}) append_integer(row, light_name(i));
    const glm::vec4 position = position_of_light(0);
    row.insert(row.end(), {position.x, position.y, position.z, position.w});
    append_all(colors_of_light(0));
    append_all(colors_of_light(7));
    float cutoff = 0;
    glGetLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, &cutoff);
    row.push_back(cutoff);
    append_all(material_of(GL_FRONT));
    append_all(material_of(GL_BACK));
    append_floats(GL_LIGHT_MODEL_AMBIENT, 4);
    for (const GLenum name : {GL_LIGHT_MODEL_LOCAL_VIEWER,
                              GL_LIGHT_MODEL_TWO_SIDE,
                              GL_SHADE_MODEL,
                              GL_FRONT_FACE,
                              GL_LIGHTING,
                              GL_NORMALIZE,
                              GL_RESCALE_NORMAL,
                              GL_COLOR_MATERIAL,
                              GL_COLOR_MATERIAL_PARAMETER,
                              GL_VERTEX_ARRAY,
                              GL_NORMAL_ARRAY,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_CURRENT_PROGRAM,
                              GL_CULL_FACE,
                              GL_DEPTH_TEST,
                              GL_ATTRIB_STACK_DEPTH,
                              GL_CLIENT_ATTRIB_STACK_DEPTH,
                              GL_LIGHT_MODEL_COLOR_CONTROL,
                              GL_VERTEX_ARRAY_SIZE,
                              GL_VERTEX_ARRAY_TYPE,
                              GL_VERTEX_ARRAY_STRIDE,
                              GL_NORMAL_ARRAY_TYPE,
                              GL_NORMAL_ARRAY_STRIDE})
        append_integer(row, name);
    row.push_back(static_cast<float>(glGetError()));
    append_floats(GL_CURRENT_COLOR, 4);
    const glm::vec4 fourth = position_of_light(3);
    row.insert(row.end(), {fourth.x, fourth.y, fourth.z, fourth.w});
    append_all(colors_of_light(3));
    for (const auto& [name, count] : {std::pair<GLenum, int>{GL_SPOT_DIRECTION, 3},
                                      {GL_SPOT_EXPONENT, 1},
                                      {GL_CONSTANT_ATTENUATION, 1},
                                      {GL_LINEAR_ATTENUATION, 1},
                                      {GL_QUADRATIC_ATTENUATION, 1}}) {
        std::array<float, 4> numbers{};
        glGetLightfv(GL_LIGHT3, name, numbers.data());
        row.insert(row.end(), numbers.begin(), numbers.begin() + count);
    }
    return row;
}

}
