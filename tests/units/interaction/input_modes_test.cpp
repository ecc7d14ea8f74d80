#include <gtest/gtest.h>

#include <umbral/input/headless.hpp>
#include <umbral/input/random_script.hpp>
#include <umbral/input/script.hpp>
#include <umbral/interaction/input_modes.hpp>
#include <vector>

namespace umbral::interaction {
namespace {

/// A window with the unit's callbacks.
struct Listening {
    explicit Listening(const input::EventScript& script, const input::HeadlessSettings& settings = {})
        : session(script, settings)
    {
        glfwInit();
        window = glfwCreateWindow(640, 480, "test", nullptr, nullptr);
        glfwSetWindowUserPointer(window, &memory);
        install_input(window);
    }
    explicit Listening(const char* script) : Listening(input::parse_script(script)) {}

    [[nodiscard]] std::vector<InputEvent> all() const
    {
        std::vector<InputEvent> events;
        while (const auto event = next_event(window)) events.push_back(*event);
        return events;
    }

    input::Headless session;
    InputMemory memory;
    GLFWwindow* window = nullptr;
};

// The statement's example.
TEST(InputModes, one_click_in_three_modes)
{
    const char* const script = "0.1 press left\n0.2 move 20 7.5\n0.3 release left\n";
    {
        const Listening listening(input::parse_script(script), {.pointer = {12, 7.5}});
        glfwWaitEventsTimeout(0.1);
        glfwWaitEventsTimeout(0.05);
        const auto moved = request_event(listening.window, InputKind::cursor_moved);
        ASSERT_TRUE(moved);
        EXPECT_EQ(moved->time, 0.2);
        EXPECT_EQ(moved->change, glm::dvec2(8, 0));
        EXPECT_EQ(moved->after.buttons, 1U);
    }
    const Listening listening(input::parse_script(script), {.pointer = {12, 7.5}});
    glfwWaitEvents();
    glfwWaitEvents();
    EXPECT_EQ(sample_mouse(listening.window).cursor, glm::dvec2(20, 7.5));
    EXPECT_EQ(sample_mouse(listening.window).buttons, 1U);
    glfwWaitEvents();
    EXPECT_EQ(sample_mouse(listening.window).buttons, 0U);
    const std::vector<InputEvent> events = listening.all();
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].after.buttons, 1U);
    EXPECT_EQ(events[1].after.buttons, 1U);
    EXPECT_EQ(events[2].after.buttons, 0U);
    EXPECT_FALSE(next_event(listening.window));
}

TEST(InputModes, a_request_ends_when_its_window_is_to_close)
{
    const Listening listening("0.1 key A press\n0.2 close\n0.2 press left\n");
    EXPECT_TRUE(request_event(listening.window, InputKind::button_pressed)) << "the answer came with the end";
    EXPECT_FALSE(request_event(listening.window, InputKind::button_pressed));
    EXPECT_EQ(listening.session.usage().polls, 2U);
    EXPECT_EQ(listening.session.usage().waits, 2U);
    EXPECT_EQ(listening.all().size(), 2U) << "the queue keeps what requests were answered with";
}

/// What a script must give, told from the script itself: no GLFW, no callbacks.
struct Model {
    void operator()(const input::CursorMove& event)
    {
        const glm::dvec2 change = event.place - after.cursor;
        after.cursor = event.place;
        if (change != glm::dvec2(0)) add(InputKind::cursor_moved, 0, change);
    }
    void operator()(const input::MouseButton& event)
    {
        if (event.placed) (*this)(input::CursorMove{event.place});
        set(event.button, event.pressed);
    }
    void operator()(const input::Scroll& event) { add(InputKind::scrolled, 0, event.offset); }
    void operator()(const input::Key& event)
    {
        if (event.action == input::Key::Action::repeat) return;
        const bool down = event.action == input::Key::Action::press;
        if (std::erase(keys, event.key) > 0 && down) {
            keys.push_back(event.key);
            return;
        }
        if (down) keys.push_back(event.key);
        add(down ? InputKind::key_pressed : InputKind::key_released, event.key);
    }
    void operator()(const input::Focus& event)
    {
        if (event.gained) return;
        std::sort(keys.begin(), keys.end());
        for (const int key : keys) add(InputKind::key_released, key);
        keys.clear();
        for (int button = 0; button < 8; ++button)
            if ((after.buttons >> static_cast<unsigned>(button)) % 2 == 1) set(button, false);
    }
    template <class Other>
    void operator()(const Other&)
    {
    }

    void set(int button, bool pressed)
    {
        const unsigned value = 1U << static_cast<unsigned>(button);
        after.buttons = pressed ? after.buttons + value : after.buttons - value;
        add(pressed ? InputKind::button_pressed : InputKind::button_released, button);
    }
    void add(InputKind kind, int code, glm::dvec2 change = {0, 0})
    {
        events.push_back({kind, code, time, change, after});
    }

    double time = 0;
    MouseState after;
    std::vector<int> keys;
    std::vector<InputEvent> events;
};

TEST(InputModes, random_sessions_give_what_the_model_gives)
{
    std::size_t seen = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const input::EventScript script = input::random_script(random);
        Model model;
        for (const auto& [time, event] : script) {
            model.time = time;
            std::visit(model, event);
        }
        const Listening listening(script);
        std::vector<InputEvent> events;
        while (!listening.session.script_is_over()) {
            glfwWaitEvents();
            if (seed % 2 == 0) continue;
            for (const InputEvent& event : listening.all()) events.push_back(event);
        }
        for (const InputEvent& event : listening.all()) events.push_back(event);
        ASSERT_EQ(events.size(), model.events.size());
        for (std::size_t i = 0; i < events.size(); ++i) {
            EXPECT_EQ(events[i].kind, model.events[i].kind) << i;
            EXPECT_EQ(events[i].code, model.events[i].code) << i;
            EXPECT_EQ(events[i].time, model.events[i].time) << i;
            EXPECT_EQ(events[i].change, model.events[i].change) << i;
            EXPECT_EQ(events[i].after.cursor, model.events[i].after.cursor) << i;
            EXPECT_EQ(events[i].after.buttons, model.events[i].after.buttons) << i;
        }
        seen += events.size();
    }
    EXPECT_GT(seen, 20'000U);
}

}
}
