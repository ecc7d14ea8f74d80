#pragma once

#include <glm/glm.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/record/ask_inputs.hpp>
#include <umbral/record/recorder.hpp>
#include <vector>

/// Shaders at single points: each is drawn as one pixel of its own, without a triangle, so without interpolation.
namespace umbral {

/// What an attribute is for all vertices.
inline void feed(const gl::Program& program, const char* name, const glm::vec3& value)
{
    const int location = program.attribute_location(name);
    if (location >= 0) glVertexAttrib3fv(static_cast<GLuint>(location), &value.x);
}

/// A projection that brings every point, wherever it lies, to the middle of the viewport; w = 1.
inline glm::mat4 to_centre()
{
    glm::mat4 matrix(0);
    matrix[3] = {0, 0, 0, 1};
    return matrix;
}

/// Draws `count` points with the program in use, point i into pixel (i, 0) of what is bound: prepare(i) sets uniforms
/// and attributes before.
template <class Prepare>
void draw_single_points(int count, Prepare prepare)
{
    glDisable(GL_DEPTH_TEST);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    for (int i = 0; i < count; ++i) {
        glViewport(i, 0, 1, 1);
        prepare(static_cast<std::size_t>(i));
        glDrawArrays(GL_POINTS, 0, 1);
    }
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
}

/// What `program`, "the shaders", say, answers at single points, each a question that begins with heading(point):
/// answers(points) holds one for each.
template <class Point, class Heading, class Answers>
void record_single_points(Recorder& out, std::string_view name, std::string_view program,
                          const std::vector<Point>& points, const Heading& heading, const Answers& answers)
{
    std::vector<Point> asked;
    for (const Point& point : points) asked.push_back(inputs_asked(out, program, point));
    const auto answered = answers(asked);
    for (std::size_t i = 0; i < points.size(); ++i) {
        ask_inputs(out, program, points[i], heading(points[i]));
        out.append(name, answered[i]);
    }
}

}
