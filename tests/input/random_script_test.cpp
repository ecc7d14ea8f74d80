#include <gtest/gtest.h>

#include <array>
#include <set>
#include <umbral/input/glfw.hpp>
#include <umbral/input/random_script.hpp>
#include <umbral/input/script.hpp>

namespace umbral::input {
namespace {

EventScript script_of(std::uint64_t seed, const RandomScriptSettings& settings = {})
{
    Random random(seed);
    return random_script(random, settings);
}

/// Which buttons and keys are down, as a window sees it.
struct Held {
    std::set<int> buttons;
    std::set<int> keys;

    void operator()(const MouseButton& event)
    {
        if (event.pressed)
            EXPECT_TRUE(buttons.insert(event.button).second) << "pressed twice";
        else
            EXPECT_EQ(buttons.erase(event.button), 1U) << "released, but was not down";
    }
    void operator()(const Key& event)
    {
        if (event.action == Key::Action::press) {
            EXPECT_TRUE(keys.insert(event.key).second) << "pressed twice";
        } else {
            EXPECT_TRUE(keys.contains(event.key)) << "repeated or released, but was not down";
        }
        if (event.action == Key::Action::release) keys.erase(event.key);
    }
    void operator()(const Focus& event)
    {
        if (event.gained) return;
        buttons.clear();
        keys.clear();
    }
    template <class Other>
    void operator()(const Other&)
    {
    }
};

TEST(RandomScript, is_what_a_user_can_do)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Held held;
        double now = 0;
        const EventScript script = script_of(seed);
        for (const auto& [time, event] : script) {
            EXPECT_GT(time, now);
            now = time;
            std::visit(held, event);
        }
        EXPECT_TRUE(held.buttons.empty() && held.keys.empty()) << "something is still down at the end";
        EXPECT_TRUE(std::holds_alternative<Close>(script.back().event));
        EXPECT_EQ(parse_script(to_text(script)), script) << "its text reads back";
        if (HasFailure()) return;
    }
}

TEST(RandomScript, has_every_kind_sooner)
{
    std::array<int, std::variant_size_v<Event>> seen{};
    for (std::uint64_t seed = 1; seed <= 50; ++seed)
        for (const TimedEvent& event : script_of(seed)) ++seen.at(event.event.index());
    for (const std::size_t kind : {0, 1, 2, 3, 5, 6, 10}) EXPECT_GT(seen.at(kind), 30) << "kind " << kind;
}

TEST(RandomScript, keeps_to_its_settings)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        for (const auto& [time, event] :
             script_of(seed, {.resizes = false, .focus_losses = false, .fractions = false})) {
            EXPECT_FALSE(std::holds_alternative<Resize>(event) || std::holds_alternative<Focus>(event));
            if (const auto* move = std::get_if<CursorMove>(&event)) {
                EXPECT_EQ(move->place, floor(move->place));
            }
            if (const auto* scroll = std::get_if<Scroll>(&event)) {
                EXPECT_EQ(scroll->offset, floor(scroll->offset));
            }
        }
    }
    EXPECT_EQ(script_of(7), script_of(7));
    EXPECT_NE(script_of(7), script_of(8));
}

}
}
