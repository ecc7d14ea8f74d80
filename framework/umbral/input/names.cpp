#include <algorithm>
#include <array>
#include <cctype>
#include <umbral/input/glfw.hpp>
#include <umbral/input/names.hpp>
#include <utility>

namespace umbral::input {
namespace {

using Named = std::pair<std::string_view, int>;

constexpr std::array long_names = {
    Named{"SPACE", GLFW_KEY_SPACE},
    Named{"ESCAPE", GLFW_KEY_ESCAPE},
    Named{"ENTER", GLFW_KEY_ENTER},
    Named{"TAB", GLFW_KEY_TAB},
    Named{"BACKSPACE", GLFW_KEY_BACKSPACE},
    Named{"INSERT", GLFW_KEY_INSERT},
    Named{"DELETE", GLFW_KEY_DELETE},
    Named{"RIGHT", GLFW_KEY_RIGHT},
    Named{"LEFT", GLFW_KEY_LEFT},
    Named{"DOWN", GLFW_KEY_DOWN},
    Named{"UP", GLFW_KEY_UP},
    Named{"PAGE_UP", GLFW_KEY_PAGE_UP},
    Named{"PAGE_DOWN", GLFW_KEY_PAGE_DOWN},
    Named{"HOME", GLFW_KEY_HOME},
    Named{"END", GLFW_KEY_END},
    Named{"CAPS_LOCK", GLFW_KEY_CAPS_LOCK},
    Named{"SCROLL_LOCK", GLFW_KEY_SCROLL_LOCK},
    Named{"NUM_LOCK", GLFW_KEY_NUM_LOCK},
    Named{"PRINT_SCREEN", GLFW_KEY_PRINT_SCREEN},
    Named{"PAUSE", GLFW_KEY_PAUSE},
    Named{"KP_DECIMAL", GLFW_KEY_KP_DECIMAL},
    Named{"KP_DIVIDE", GLFW_KEY_KP_DIVIDE},
    Named{"KP_MULTIPLY", GLFW_KEY_KP_MULTIPLY},
    Named{"KP_SUBTRACT", GLFW_KEY_KP_SUBTRACT},
    Named{"KP_ADD", GLFW_KEY_KP_ADD},
    Named{"KP_ENTER", GLFW_KEY_KP_ENTER},
    Named{"KP_EQUAL", GLFW_KEY_KP_EQUAL},
    Named{"LEFT_SHIFT", GLFW_KEY_LEFT_SHIFT},
    Named{"LEFT_CONTROL", GLFW_KEY_LEFT_CONTROL},
    Named{"LEFT_ALT", GLFW_KEY_LEFT_ALT},
    Named{"LEFT_SUPER", GLFW_KEY_LEFT_SUPER},
    Named{"RIGHT_SHIFT", GLFW_KEY_RIGHT_SHIFT},
    Named{"RIGHT_CONTROL", GLFW_KEY_RIGHT_CONTROL},
    Named{"RIGHT_ALT", GLFW_KEY_RIGHT_ALT},
    Named{"RIGHT_SUPER", GLFW_KEY_RIGHT_SUPER},
    Named{"MENU", GLFW_KEY_MENU},
    Named{"WORLD_1", GLFW_KEY_WORLD_1},
    Named{"WORLD_2", GLFW_KEY_WORLD_2},
};

/// Keys whose number is their character without Shift, and what they give with it.
constexpr std::string_view plain = "`1234567890-=[]\\;',./";
constexpr std::string_view shifted = "~!@#$%^&*()_+{}|:\"<>?";

/// A family of numbered names: F1 … F25, KP_0 … KP_9.
struct Family {
    std::string_view prefix;
    int first_key;
    int first_number;
    int last_number;
};
constexpr std::array families = {Family{"F", GLFW_KEY_F1, 1, 25}, Family{"KP_", GLFW_KEY_KP_0, 0, 9}};

std::string in_capitals(std::string_view name)
{
    std::string capitals(name);
    for (char& letter : capitals) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return capitals;
}

bool is_plain(int key) { return key > 0 && key < 128 && plain.find(static_cast<char>(key)) != std::string_view::npos; }
bool is_letter(int key) { return key >= GLFW_KEY_A && key <= GLFW_KEY_Z; }

}

std::optional<int> key_of(std::string_view name)
{
    const std::string capitals = in_capitals(name);
    if (capitals.size() == 1 && (is_letter(capitals[0]) || is_plain(capitals[0]))) return capitals[0];
    const auto* const found =
        std::find_if(long_names.begin(), long_names.end(), [&](const Named& named) { return named.first == capitals; });
    if (found != long_names.end()) return found->second;
    for (const Family& family : families)
        for (int number = family.first_number; number <= family.last_number; ++number)
            if (capitals == std::string(family.prefix) + std::to_string(number))
                return family.first_key + number - family.first_number;
    return std::nullopt;
}

std::string name_of_key(int key)
{
    if (is_letter(key) || is_plain(key)) return {static_cast<char>(key)};
    for (const auto& [name, number] : long_names)
        if (number == key) return std::string(name);
    for (const Family& family : families)
        if (key >= family.first_key && key <= family.first_key + family.last_number - family.first_number)
            return std::string(family.prefix) + std::to_string(key - family.first_key + family.first_number);
    return "";
}

std::optional<int> button_of(std::string_view name)
{
    for (int button = 0; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
        if (name == name_of_button(button)) return button;
    return std::nullopt;
}

std::string name_of_button(int button)
{
    switch (button) {
        case GLFW_MOUSE_BUTTON_LEFT: return "left";
        case GLFW_MOUSE_BUTTON_RIGHT: return "right";
        case GLFW_MOUSE_BUTTON_MIDDLE: return "middle";
        default: return std::to_string(button + 1);
    }
}

char character_of(int key, bool shift)
{
    if (is_letter(key)) return static_cast<char>(shift ? key : key - 'A' + 'a');
    if (key == GLFW_KEY_SPACE) return ' ';
    if (is_plain(key)) return shift ? shifted[plain.find(static_cast<char>(key))] : static_cast<char>(key);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return static_cast<char>('0' + key - GLFW_KEY_KP_0);
    return 0;
}

}
