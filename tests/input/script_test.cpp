#include <gtest/gtest.h>

#include <umbral/input/glfw.hpp>
#include <umbral/input/names.hpp>
#include <umbral/input/script.hpp>

namespace umbral::input {
namespace {

/// What parsing says is wrong; empty if nothing.
std::string complaint(const std::string& text)
{
    try {
        (void)parse_script(text, "drag.txt");
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Script, reads_every_kind_of_event)
{
    const EventScript script = parse_script(R"(# a session
0 press left 120 80.5
0.15 move -3 85   # outside
0.15 release left

.2 scroll 0.5 -1
0.4 key r press
0.5 key F25 repeat
0.6 key left_shift release
0.7 char 241
1 resize 800 0
2 focus off
3 enter on
4 iconify on
5 refresh
6 close)");
    const EventScript expected = {{0, MouseButton{GLFW_MOUSE_BUTTON_LEFT, true, true, {120, 80.5}}},
                                  {0.15, CursorMove{{-3, 85}}},
                                  {0.15, MouseButton{GLFW_MOUSE_BUTTON_LEFT, false}},
                                  {0.2, Scroll{{0.5, -1}}},
                                  {0.4, Key{GLFW_KEY_R, Key::Action::press}},
                                  {0.5, Key{GLFW_KEY_F25, Key::Action::repeat}},
                                  {0.6, Key{GLFW_KEY_LEFT_SHIFT, Key::Action::release}},
                                  {0.7, Character{U'ñ'}},
                                  {1, Resize{{800, 0}}},
                                  {2, Focus{false}},
                                  {3, CursorEnter{true}},
                                  {4, Iconify{true}},
                                  {5, Refresh{}},
                                  {6, Close{}}};
    EXPECT_EQ(script, expected);
    EXPECT_EQ(parse_script(to_text(script)), script);
}

TEST(Script, empty_texts_have_no_events)
{
    EXPECT_TRUE(parse_script("").empty());
    EXPECT_TRUE(parse_script("\n  \n# nothing\n\t").empty());
}

TEST(Script, complaints_name_the_line_and_what_was_expected)
{
    EXPECT_EQ(complaint("0.1 press left\n0.2 press lft 3 4"),
              "drag.txt:2: expected a button (left, right, middle or 4 to 8), got 'lft'");
    EXPECT_EQ(complaint("0.1 pres left"),
              "drag.txt:1: expected press, release, move, scroll, key, char, resize, focus, enter, iconify, refresh or "
              "close, got 'pres'");
    EXPECT_EQ(complaint("0.5 close\n0.4 close"),
              "drag.txt:2: expected a time in seconds, not before the line above (0.5), got '0.4'");
    EXPECT_EQ(complaint("now close"),
              "drag.txt:1: expected a time in seconds, not before the line above (0), got 'now'");
    EXPECT_EQ(complaint("1 move 3"), "drag.txt:1: expected a place's y between -1e6 and 1e6, got the end of the line");
    EXPECT_EQ(complaint("1 move 3 4 5"), "drag.txt:1: expected the end of the line, got '5'");
    EXPECT_EQ(complaint("1 key Q"), "drag.txt:1: expected press, repeat or release, got the end of the line");
    EXPECT_EQ(complaint("1 key QQ press"),
              "drag.txt:1: expected the name of a key (as R, 1, F5, LEFT_SHIFT or ESCAPE), got 'QQ'");
    EXPECT_EQ(complaint("1 focus maybe"), "drag.txt:1: expected on or off, got 'maybe'");
}

TEST(Script, refuses_numbers_that_are_none)
{
    for (const char* text : {"1 move nan 0", "1 move 0 inf", "1 move 1e300 0", "1 move 1x 0", "-1 close", "nan close",
                             "inf close", "1 resize -1 5", "1 resize 2.5 5", "1 resize 99999999999999999999 5",
                             "1 char 31", "1 char 1114112", "1 scroll 0", "1 press 9", "1 press 0", "1"})
        EXPECT_NE(complaint(text), "") << text;
}

TEST(Names, keys_come_back)
{
    int keys = 0;
    for (int key = -2; key <= GLFW_KEY_LAST + 1; ++key) {
        const std::string name = name_of_key(key);
        if (name.empty()) continue;
        ++keys;
        EXPECT_EQ(key_of(name), key) << name;
    }
    EXPECT_EQ(keys, 120) << "GLFW 3.3 names 120 keys";
    EXPECT_EQ(key_of(""), std::nullopt);
    EXPECT_EQ(key_of("F26"), std::nullopt);
    EXPECT_EQ(key_of("F0"), std::nullopt);
    EXPECT_EQ(name_of_key(GLFW_KEY_UNKNOWN), "");
}

TEST(Names, characters_of_an_american_keyboard)
{
    EXPECT_EQ(character_of(GLFW_KEY_A, false), 'a');
    EXPECT_EQ(character_of(GLFW_KEY_A, true), 'A');
    EXPECT_EQ(character_of(GLFW_KEY_2, true), '@');
    EXPECT_EQ(character_of(GLFW_KEY_SLASH, true), '?');
    EXPECT_EQ(character_of(GLFW_KEY_GRAVE_ACCENT, true), '~');
    EXPECT_EQ(character_of(GLFW_KEY_KP_7, false), '7');
    EXPECT_EQ(character_of(GLFW_KEY_ENTER, false), 0);
    EXPECT_EQ(character_of(GLFW_KEY_LEFT_SHIFT, true), 0);
}

}
}
