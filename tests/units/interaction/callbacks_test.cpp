#include <gtest/gtest.h>

#include <cmath>
#include <interaction/command_log.hpp>
#include <map>
#include <umbral/input/headless.hpp>
#include <umbral/input/random_script.hpp>
#include <umbral/input/script.hpp>

namespace umbral::interaction {
namespace {

using Rows = std::vector<CommandRow>;

Rows commands_of(const input::EventScript& script, const input::HeadlessSettings& settings = {}, bool listens = false)
{
    const input::Headless session(script, settings);
    glfwInit();
    LoggedWindow window(glfwCreateWindow(640, 480, "test", nullptr, nullptr), listens);
    while (!session.script_is_over()) {
        glfwWaitEvents();
        window.look();
    }
    return window.rows();
}

Rows commands_of(const char* script, const input::HeadlessSettings& settings = {}, bool listens = false)
{
    return commands_of(input::parse_script(script), settings, listens);
}

constexpr CommandRow first_viewport = {6, 640, 480, 4.0F / 3};

// Worked by hand.
TEST(Callbacks, gestures)
{
    EXPECT_EQ(commands_of("0 press left 10 20\n1 move 13 18\n2 move 13 20.5\n3 release left\n4 move 0 0"),
              (Rows{first_viewport, {1, 3, 2}, {1, 0, -2.5F}}));
    EXPECT_EQ(commands_of("0 press right 10 20\n1 move -5 40\n2 release right"), (Rows{first_viewport, {2, -15, -20}}));
    EXPECT_EQ(commands_of("0 key LEFT_SHIFT press\n1 press left 1 1\n2 key LEFT_SHIFT release\n3 move 2 2"),
              (Rows{first_viewport, {2, 1, -1}}));
    EXPECT_EQ(commands_of("0 scroll 5 0\n1 scroll 0 -1\n2 scroll 0 2"),
              (Rows{first_viewport, {3, 1.1F}, {3, static_cast<float>(1 / 1.21)}}));
    EXPECT_EQ(commands_of("0 key R press\n1 key R repeat\n2 key R release\n3 key 3 press\n4 key ESCAPE press"),
              (Rows{first_viewport, {4}, {5, 3}, {7}}));
    EXPECT_EQ(commands_of("0 resize 0 0\n1 resize 100 50", {.content_scale = {3, 3}}),
              (Rows{{6, 1920, 1440, 4.0F / 3}, {6, 300, 150, 2}}));
}

TEST(Callbacks, keys_are_passed_on)
{
    const auto passed = [](int key, int action, int mods) {
        return CommandRow{key_code(key, action), static_cast<float>(key), static_cast<float>(mods)};
    };
    EXPECT_EQ(
        commands_of("0 key A press\n1 key A repeat\n2 key A release\n3 key LEFT_SHIFT press\n4 key 1 press", {}, true),
        (Rows{first_viewport,
              passed(GLFW_KEY_A, GLFW_PRESS, 0),
              passed(GLFW_KEY_A, GLFW_REPEAT, 0),
              passed(GLFW_KEY_A, GLFW_RELEASE, 0),
              passed(GLFW_KEY_LEFT_SHIFT, GLFW_PRESS, 0),
              {5, 1},
              passed(GLFW_KEY_1, GLFW_PRESS, GLFW_MOD_SHIFT)}));
}

/// What a script must give, told from the script itself: no GLFW, no callbacks.
struct Model {
    explicit Model(double scale) : scale_(scale) { viewport({640, 480}); }

    void operator()(const input::CursorMove& event)
    {
        const glm::dvec2 motion = event.place - place_;
        place_ = event.place;
        if (began_ >= 0 && motion != glm::dvec2(0)) add(pans_ ? 2 : 1, motion.x, -motion.y);
    }
    void operator()(const input::MouseButton& event)
    {
        if (event.placed) (*this)(input::CursorMove{event.place});
        if (event.pressed && began_ < 0 && event.button <= 1) {
            began_ = event.button;
            pans_ = event.button == 1 || held(340) || held(344);
        } else if (event.pressed && began_ < 0) {
            began_ = -1;
        } else if (!event.pressed && began_ == event.button) {
            began_ = -1;
        }
    }
    void operator()(const input::Scroll& event)
    {
        if (event.offset.y != 0) add(3, std::exp2(-event.offset.y * std::log2(1.1)));
    }
    void operator()(const input::Key& event)
    {
        bool shortcut = false;
        for (const int key : {341, 345, 342, 346, 343, 347}) shortcut = shortcut || held(key);
        if (event.action == input::Key::Action::press && !shortcut) {
            if (event.key == 'R') add(4);
            if (event.key >= '1' && event.key <= '3') add(5, event.key - '0');
        }
        keys_[event.key] = event.action != input::Key::Action::release;
    }
    void operator()(const input::Resize& event)
    {
        if (event.size != size_) viewport(event.size);
    }
    void operator()(const input::Focus& event)
    {
        if (event.gained) return;
        began_ = -1;
        keys_.clear();
    }
    template <class Other>
    void operator()(const Other&)
    {
    }

    Rows rows;

private:
    bool held(int key) { return keys_[key]; }
    void add(int code, double a = 0, double b = 0, double c = 0)
    {
        rows.push_back({static_cast<float>(code), static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)});
    }
    void viewport(glm::ivec2 size)
    {
        size_ = size;
        const double width = std::round(scale_ * size.x);
        const double height = std::round(scale_ * size.y);
        if (width > 0 && height > 0) add(6, width, height, width / height);
    }

    double scale_;
    glm::ivec2 size_{0};
    glm::dvec2 place_{0};
    int began_ = -1;  ///< the button
    bool pans_ = false;
    std::map<int, bool> keys_;
};

TEST(Callbacks, random_sessions_give_what_the_model_gives)
{
    std::size_t seen = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        const input::EventScript script = input::random_script(random);
        const double scale = seed % 2 == 0 ? 1 : 1.5;
        Model model(scale);
        for (const auto& [time, event] : script) std::visit(model, event);
        const Rows rows = commands_of(script, {.content_scale = glm::dvec2(scale)});
        ASSERT_EQ(rows.size(), model.rows.size()) << "seed " << seed;
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t j = 0; j < 4; ++j)
                ASSERT_NEAR(rows[i][j], model.rows[i][j], 1e-6 * std::abs(model.rows[i][j]))
                    << "seed " << seed << ", command " << i;
        seen += rows.size();
    }
    EXPECT_GT(seen, 20'000U);
}

}
}
