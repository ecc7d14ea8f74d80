#pragma once

#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/input/headless.hpp>
#include <umbral/pipeline/region.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Windows that are played to, and windows that are drawn.
namespace umbral::pipeline {

/// Takes down what it is told to show. Shows one box after the other, as often as `next` is called.
class LoggedViewer final : public Viewer {
public:
    explicit LoggedViewer(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}

    [[nodiscard]] Box contents() const override { return boxes_[current_ % boxes_.size()]; }
    void show(const glm::ivec2& pixels, const glm::mat4& projection) override
    {
        rows.push_back({1, static_cast<float>(pixels.x), static_cast<float>(pixels.y), projection[0].x, projection[1].y,
                        projection[3].x, projection[3].y});
        moments.push_back({event, contents()});
    }
    void next() { ++current_; }

    /// When something was shown: before the first event, or because of one; and what was to be seen then.
    struct Moment {
        std::size_t events;
        Box contents;
    };

    std::vector<std::vector<float>> rows;
    std::vector<Moment> moments;  ///< of each row
    std::size_t event = 0;        ///< how many there have been

private:
    std::vector<Box> boxes_;
    std::size_t current_ = 0;
};

/// Plays a script to a window of 640 x 480 as its event loop would; the viewer's contents change after each event. From
/// the third event on the window belongs to `heir`, if there is one.
inline void play(const input::EventScript& script, glm::dvec2 content_scale, LoggedViewer& viewer,
                 LoggedViewer* heir = nullptr)
{
    const input::Headless session(script, {.content_scale = content_scale});
    glfwInit();
    GLFWwindow* window = glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr);
    glfwSetWindowUserPointer(window, static_cast<Viewer*>(&viewer));
    keep_proportions(window);
    for (std::size_t event = 0; !session.script_is_over(); ++event) {
        for (LoggedViewer* const told : {&viewer, heir})
            if (told != nullptr) told->event = event + 1;
        if (event == 2 && heir != nullptr) glfwSetWindowUserPointer(window, static_cast<Viewer*>(heir));
        viewer.next();
        glfwWaitEvents();
    }
}

/// Plays a script to a window of 640 x 480 that calls keep_proportions after so many events, one time or more. From its
/// second time on the window belongs to `heir`.
inline void play_registered(const input::EventScript& script, const std::vector<std::size_t>& after,
                            LoggedViewer& viewer, LoggedViewer& heir)
{
    const input::Headless session(script, {});
    glfwInit();
    GLFWwindow* window = glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr);
    std::size_t times = 0;
    for (std::size_t event = 0; !session.script_is_over(); ++event) {
        viewer.event = heir.event = event;
        if (times < after.size() && event == after[times]) {
            glfwSetWindowUserPointer(window, static_cast<Viewer*>(times == 0 ? &viewer : &heir));
            keep_proportions(window);
            ++times;
        }
        viewer.event = heir.event = event + 1;
        viewer.next();
        heir.next();
        glfwWaitEvents();
    }
}

/// Plays a script to the first of two windows that are there at the same time, of 640 x 480 and 300 x 200. Before each
/// of its events the program gives the second one another size, which comes as an event of its own.
inline void play_beside(const input::EventScript& script, LoggedViewer& viewer, LoggedViewer& other)
{
    const input::Headless session(script, {});
    glfwInit();
    const auto open = [](int width, int height, LoggedViewer& shows) {
        GLFWwindow* window = glfwCreateWindow(width, height, "Umbral", nullptr, nullptr);
        glfwSetWindowUserPointer(window, static_cast<Viewer*>(&shows));
        keep_proportions(window);
        return window;
    };
    open(640, 480, viewer);
    GLFWwindow* const second = open(300, 200, other);
    for (std::size_t event = 0; !session.script_is_over(); ++event) {
        viewer.event = other.event = event / 2 + 1;
        viewer.next();
        other.next();
        if (event % 2 == 0) glfwSetWindowSize(second, 300, static_cast<int>(event) + 1);
        glfwWaitEvents();
    }
}

/// A polygon to fill, in the coordinates of what is shown.
struct Patch {
    std::vector<glm::dvec2> corners;
    glm::vec3 color;
};

/// A star of `points` tips (a circle, if both radii are the same).
inline Patch star(glm::dvec2 centre, double outer, double inner, int points, glm::vec3 color, double turn = 0)
{
    Patch patch{{}, color};
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points + turn;
        patch.corners.push_back(centre + (i % 2 == 0 ? outer : inner) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return patch;
}

/// Three units wide and two high, not about the origin: nothing but right proportions keeps its circles round.
inline constexpr Box tile = {{1, -2, -1}, {4, 0, 1}};

inline std::vector<Patch> ornament()
{
    std::vector<Patch> patches = {{{{1, -2}, {4, -2}, {4, 0}, {1, 0}}, {0.10F, 0.16F, 0.27F}}};
    const auto rose = [&](glm::dvec2 centre, double radius, int tips, glm::vec3 petals) {
        patches.push_back(star(centre, radius, radius, 40, ink::mist));
        patches.push_back(star(centre, 0.93 * radius, 0.93 * radius, 40, ink::night));
        patches.push_back(star(centre, 0.9 * radius, 0.42 * radius, tips, petals));
        patches.push_back(star(centre, 0.66 * radius, 0.4 * radius, tips, ink::night, std::numbers::pi / tips));
        patches.push_back(star(centre, 0.58 * radius, 0.26 * radius, tips, ink::white, std::numbers::pi / tips));
        patches.push_back(star(centre, 0.2 * radius, 0.2 * radius, 20, petals));
    };
    rose({2.5, -1}, 0.9, 12, ink::orange);
    for (const double x : {1.38, 3.62}) {
        rose({x, -1.62}, 0.33, 8, ink::blue);
        rose({x, -0.38}, 0.33, 8, ink::green);
        rose({x, -1}, 0.22, 6, ink::red);
    }
    return patches;
}

/// A window in the drawing: its lower left corner and size, in pixels of the drawing.
struct Pane {
    glm::dvec2 corner;
    glm::ivec2 size;
};

/// Draws the ornament as a window of that size shows it.
inline void draw_pane(Recorder& out, Drawing& drawing, const Pane& pane)
{
    const Box region = ask<visible_region>(out, tile, pane.size.x, pane.size.y);
    const glm::dmat4 projection(ask<projection_of>(out, region));
    const auto on_paper = [&](glm::dvec2 place) {
        const glm::dvec2 ndc(projection * glm::dvec4(place, 0, 1));
        return pane.corner + (0.5 * ndc + 0.5) * glm::dvec2(pane.size);
    };
    const glm::dvec2 size(pane.size);
    const std::vector<glm::dvec2> frame = {pane.corner, pane.corner + glm::dvec2(size.x, 0), pane.corner + size,
                                           pane.corner + glm::dvec2(0, size.y)};
    drawing.area(frame, ink::slate);
    for (const auto& [corners, color] : ornament()) {
        std::vector<glm::dvec2> moved;
        for (const glm::dvec2& corner : corners) moved.push_back(on_paper(corner));
        drawing.area(moved, color);
    }
    drawing.outline(frame, ink::white, 2.5);
}

/// Four windows: wide, square, tall, and one with the contents' own proportions.
inline Image windows_picture(Recorder& out, Variation& vary)
{
    Drawing drawing(512, 432, {0, 0}, {512, 432});
    for (Pane pane : {Pane{{16, 276}, {480, 140}}, Pane{{16, 16}, {244, 244}}, Pane{{276, 16}, {76, 244}},
                      Pane{{368, 174}, {129, 86}}, Pane{{368, 16}, {128, 142}}}) {
        for (int axis = 0; axis < 2; ++axis)
            pane.size[axis] =
                static_cast<int>(static_cast<float>(pane.size[axis]) * vary.one_of(1.0F, std::array{0.6F, 0.7F, 0.8F}));
        draw_pane(out, drawing, pane);
    }
    return drawing.picture();
}

/// Events of a window that is dragged, minimised and shown again.
inline constexpr const char* resizing = R"(
0.1 resize 800 600
0.2 resize 0 0               # minimised
0.3 resize 800 600
0.4 resize 300 500
0.5 resize 0 500
0.6 resize 1024 500
0.7 press left 10 10         # not every event is a new size
0.8 release left
0.9 resize 1024 0
1.0 resize 501 333
1.1 resize 1 400
1.2 key R press
1.3 resize 400 400
)";

}
