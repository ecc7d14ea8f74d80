#include <gtest/gtest.h>

#include <kit/input_words.hpp>
#include <limits>
#include <map>
#include <sstream>

namespace umbral {
namespace {

/// The names by their codes, as reports read them.
std::map<float, std::string> names_in(const std::string& lines)
{
    std::map<float, std::string> names;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);) {
        std::size_t used = 0;
        const auto code = static_cast<float>(std::stoi(line, &used));
        EXPECT_TRUE(names.emplace(code, line.substr(used + 1)).second) << line << ": its code has a name already";
    }
    return names;
}

TEST(InputWords, tell_key_and_action)
{
    const std::map<float, std::string> names = names_in(key_names());
    EXPECT_EQ(names.at(key_code(GLFW_KEY_S, GLFW_PRESS)), "key S, press");
    EXPECT_EQ(names.at(key_code(GLFW_KEY_LEFT_SHIFT, GLFW_RELEASE)), "key LEFT_SHIFT, release");
    EXPECT_EQ(names.at(key_code(GLFW_KEY_4, GLFW_REPEAT)), "key 4, repeat");
    EXPECT_EQ(names.at(key_code(GLFW_KEY_UNKNOWN, GLFW_PRESS)), "unknown key, press");
    EXPECT_EQ(names.at(key_code(GLFW_KEY_S, 7)), "key S, unknown action");
    EXPECT_EQ(names_in(key_names("modifiers")).at(key_code(GLFW_KEY_S, GLFW_PRESS)), "key S, press: modifiers");
    EXPECT_EQ(names_in(button_names()).at(button_code(GLFW_MOUSE_BUTTON_RIGHT, true)), "right button, press");
}

TEST(InputWords, codes_of_keys_and_buttons_differ_whatever_numbers_a_program_gives)
{
    std::map<float, std::string> names = names_in(key_names());
    const std::size_t keys = names.size();
    const std::map<float, std::string> buttons = names_in(button_names());
    names.insert(buttons.begin(), buttons.end());
    EXPECT_EQ(names.size(), keys + buttons.size());
    for (const int key : {std::numeric_limits<int>::min(), -2, GLFW_KEY_LAST + 1, std::numeric_limits<int>::max()})
        for (const int action : {-1, 0, 3, std::numeric_limits<int>::max()})
            EXPECT_GE(key_code(key, action), 1000) << key << " " << action;
    EXPECT_FALSE(names.contains(key_code(std::numeric_limits<int>::max(), GLFW_PRESS)));
    EXPECT_FALSE(names.contains(button_code(std::numeric_limits<int>::max(), true)));
    EXPECT_FALSE(names.contains(button_code(-7, true)));
}

}
}
