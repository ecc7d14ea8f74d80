#pragma once

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/lab4_program.hpp>
#include <vector>

/// What labs 1 to 3 bring: an object of coloured boxes, and a camera that the arrow keys move round it.
namespace umbral::texturing {

/// A box without lighting: each side has a colour of its own.
inline void draw_box(const glm::vec3& color)
{
    constexpr std::array<float, 3> shades = {0.75F, 1, 0.55F};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            const glm::vec3 shade = color * shades[static_cast<std::size_t>(axis)] * (side < 0 ? 0.8F : 1.0F);
            glColor3fv(value_ptr(shade));
            glBegin(GL_QUADS);
            for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
                glm::vec3 place(0);
                place[axis] = side;
                place[(axis + 1) % 3] = side * corner.x;
                place[(axis + 2) % 3] = corner.y;
                glVertex3fv(value_ptr(place));
            }
            glEnd();
        }
}

inline constexpr glm::vec3 paper{0.93F, 0.93F, 0.90F};

/// The whole picture in the colour of paper, with OpenGL's state as draw() may expect it: without a depth test it hides
/// nothing that comes later, near as it is.
inline void draw_backdrop()
{
    for (const GLenum stack : {GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(stack);
        glLoadIdentity();
    }
    glColor3fv(value_ptr(paper));
    glBegin(GL_QUADS);
    for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) glVertex3f(corner.x, corner.y, -1);
    glEnd();
}

/// How the camera stands: turned about the scene, in radians, and its lens, in degrees of height.
struct CameraPose {
    float longitude = 0.12F;
    float latitude = 0.36F;
    float lens = 24;
};

/// How the camera stands at first: varied, a little aside, and with another lens.
inline CameraPose first_pose(Variation& vary)
{
    const CameraPose written;
    return {vary.near(written.longitude, 0.3F), vary.near(written.latitude, 0.12F), vary.near(written.lens, 2.0F)};
}

/// The camera moves by itself, too: from that second on it stands so.
struct TimedPose {
    double time = 0;
    CameraPose pose;
};

class ColouredBoxes : public EarlierLabs {
public:
    explicit ColouredBoxes(std::vector<TimedPose> motion = {}, const CameraPose& start = {})
        : moved_(start), motion_(std::move(motion))
    {
    }

    /// A key as it came: its number, what was done to it, and the modifiers.
    using KeyRow = std::array<int, 3>;

    void draw() override
    {
        ++draws;
        drawing = true;
        glClearColor(paper.r, paper.g, paper.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_backdrop();
        const bool found_depth_test = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE;
        glEnable(GL_DEPTH_TEST);
        std::array<GLint, 4> viewport{};
        glGetIntegerv(GL_VIEWPORT, viewport.data());
        glMatrixMode(GL_PROJECTION);
        const glm::mat4 lens = projection(static_cast<float>(viewport[2]) / static_cast<float>(viewport[3]));
        glLoadMatrixf(value_ptr(lens));
        glMatrixMode(GL_MODELVIEW);
        glm::mat4 place = translate(view(), {0, 0.3F, 0});
        for (int storey = 0; storey < 5; ++storey) {
            const float size = 0.62F - 0.09F * static_cast<float>(storey);
            glLoadMatrixf(value_ptr(scale(place, {size, 0.2F, size})));
            draw_box({0.25F + 0.15F * static_cast<float>(storey), 0.35F, 0.85F - 0.15F * static_cast<float>(storey)});
            place = rotate(translate(place, {0, 0.42F, 0}), 0.5F, {0, 1, 0});
        }
        if (!found_depth_test) glDisable(GL_DEPTH_TEST);  // what was left wrong is wrong in each frame
        drawing = false;
    }

    void key(int key, int action, int mods) override
    {
        keys.push_back({key, action, mods});
        if (action == GLFW_RELEASE) return;
        if (key == GLFW_KEY_LEFT) moved_.longitude -= 0.2F;
        if (key == GLFW_KEY_RIGHT) moved_.longitude += 0.2F;
        if (key == GLFW_KEY_UP) moved_.latitude += 0.1F;
        if (key == GLFW_KEY_DOWN) moved_.latitude -= 0.1F;
    }

    [[nodiscard]] glm::mat4 view() const override
    {
        const CameraPose now = pose();
        glm::mat4 view = translate(glm::mat4(1), {0, 0, -7.1F});
        view = rotate(rotate(view, now.latitude, {1, 0, 0}), -now.longitude, {0, 1, 0});
        return translate(view, {0.1F, -0.8F, -0.2F});
    }

    [[nodiscard]] glm::mat4 projection(float aspect) const override
    {
        return glm::perspective(glm::radians(pose().lens), aspect, 1.0F, 20.0F);
    }

    std::vector<KeyRow> keys;  ///< that came here
    int draws = 0;
    bool drawing = false;  ///< draw() is under way

private:
    [[nodiscard]] CameraPose pose() const
    {
        CameraPose now = moved_;
        for (const TimedPose& one : motion_)
            if (one.time <= glfwGetTime()) now = one.pose;
        return now;
    }

    CameraPose moved_;  // by keys
    std::vector<TimedPose> motion_;
};

}
