#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <umbral/input/names.hpp>
#include <umbral/input/script.hpp>

namespace umbral::input {
namespace {

constexpr const char* kinds =
    "press, release, move, scroll, key, char, resize, focus, enter, iconify, refresh or close";

/// One line, read word by word; every failure names the place.
class LineReader {
public:
    LineReader(std::string_view line, std::string where)
        : where_(std::move(where)), words_(std::string(line.substr(0, line.find('#'))))
    {
        next();
    }

    [[nodiscard]] bool at_end() const { return word_.empty(); }

    [[noreturn]] void fail(const std::string& expected) const
    {
        throw std::invalid_argument(where_ + ": expected " + expected +
                                    (at_end() ? ", got the end of the line" : ", got '" + word_ + "'"));
    }

    std::string word(const std::string& expected)
    {
        if (at_end()) fail(expected);
        std::string taken = word_;
        next();
        return taken;
    }

    template <class Number>
    Number number(const std::string& expected, Number low, Number high)
    {
        Number value{};
        const auto [end, error] = std::from_chars(word_.data(), word_.data() + word_.size(), value);
        if (error != std::errc() || end != word_.data() + word_.size() || !(value >= low && value <= high))
            fail(expected);
        next();
        return value;
    }

    double coordinate(const std::string& expected) { return number(expected + " between -1e6 and 1e6", -1e6, 1e6); }

    glm::dvec2 pair(const std::string& expected)
    {
        const double x = coordinate(expected + " x");
        return {x, coordinate(expected + " y")};
    }

    template <class Value>
    Value one_of(std::initializer_list<std::pair<const char*, Value>> choices, const std::string& expected)
    {
        for (const auto& [name, value] : choices) {
            if (word_ != name) continue;
            next();
            return value;
        }
        fail(expected);
    }

    int button()
    {
        const auto button = button_of(word_);
        if (!button) fail("a button (left, right, middle or 4 to 8)");
        next();
        return *button;
    }

    int key()
    {
        const auto key = key_of(word_);
        if (!key) fail("the name of a key (as R, 1, F5, LEFT_SHIFT or ESCAPE)");
        next();
        return *key;
    }

private:
    void next()
    {
        word_.clear();
        words_ >> word_;
    }

    std::string where_;
    std::istringstream words_;
    std::string word_;
};

bool on_or_off(LineReader& line) { return line.one_of<bool>({{"on", true}, {"off", false}}, "on or off"); }

Event mouse_button(LineReader& line, bool pressed)
{
    MouseButton event{line.button(), pressed};
    event.placed = !line.at_end();
    if (event.placed) event.place = line.pair("a place's");
    return event;
}

Event key(LineReader& line)
{
    const int code = line.key();
    using Action = Key::Action;
    return Key{code,
               line.one_of<Action>({{"press", Action::press}, {"repeat", Action::repeat}, {"release", Action::release}},
                                   "press, repeat or release")};
}

Event resize(LineReader& line)
{
    const auto size = [&](const char* what) {
        return line.number(std::string("a ") + what + ", a whole number from 0 to 32768", 0, 32768);
    };
    const int width = size("width");
    return Resize{{width, size("height")}};
}

Event read_event(LineReader& line)
{
    using Reader = Event (*)(LineReader&);
    const auto reader = line.one_of<Reader>(
        {{"press", [](LineReader& rest) { return mouse_button(rest, true); }},
         {"release", [](LineReader& rest) { return mouse_button(rest, false); }},
         {"move", [](LineReader& rest) -> Event { return CursorMove{rest.pair("a place's")}; }},
         {"scroll", [](LineReader& rest) -> Event { return Scroll{rest.pair("an offset's")}; }},
         {"key", key},
         {"char",
          [](LineReader& rest) -> Event {
              return Character{rest.number<std::uint32_t>("a Unicode number from 32 to 1114111", 32, 0x10FFFF)};
          }},
         {"resize", resize},
         {"focus", [](LineReader& rest) -> Event { return Focus{on_or_off(rest)}; }},
         {"enter", [](LineReader& rest) -> Event { return CursorEnter{on_or_off(rest)}; }},
         {"iconify", [](LineReader& rest) -> Event { return Iconify{on_or_off(rest)}; }},
         {"refresh", [](LineReader&) -> Event { return Refresh{}; }},
         {"close", [](LineReader&) -> Event { return Close{}; }}},
        kinds);
    return reader(line);
}

/// The shortest decimal that reads back as the same number.
std::string shortest(double number)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string pair_text(glm::dvec2 pair) { return shortest(pair.x) + " " + shortest(pair.y); }
const char* switch_text(bool on) { return on ? "on" : "off"; }

struct Writer {
    std::string operator()(const MouseButton& event) const
    {
        return (event.pressed ? "press " : "release ") + name_of_button(event.button) +
               (event.placed ? " " + pair_text(event.place) : "");
    }
    std::string operator()(const CursorMove& event) const { return "move " + pair_text(event.place); }
    std::string operator()(const Scroll& event) const { return "scroll " + pair_text(event.offset); }
    std::string operator()(const Key& event) const
    {
        constexpr const char* actions[] = {" release", " press", " repeat"};
        return "key " + name_of_key(event.key) + actions[static_cast<int>(event.action)];
    }
    std::string operator()(const Character& event) const
    {
        return "char " + std::to_string(static_cast<std::uint32_t>(event.code_point));
    }
    std::string operator()(const Resize& event) const
    {
        return "resize " + std::to_string(event.size.x) + " " + std::to_string(event.size.y);
    }
    std::string operator()(const Focus& event) const { return std::string("focus ") + switch_text(event.gained); }
    std::string operator()(const CursorEnter& event) const
    {
        return std::string("enter ") + switch_text(event.entered);
    }
    std::string operator()(const Iconify& event) const
    {
        return std::string("iconify ") + switch_text(event.iconified);
    }
    std::string operator()(const Refresh&) const { return "refresh"; }
    std::string operator()(const Close&) const { return "close"; }
};

}

EventScript parse_script(std::string_view text, const std::string& where)
{
    EventScript script;
    std::istringstream lines{std::string(text)};
    int number = 0;
    double now = 0;
    for (std::string content; std::getline(lines, content);) {
        LineReader line(content, where + ":" + std::to_string(++number));
        if (line.at_end()) continue;
        now = line.number("a time in seconds, not before the line above (" + shortest(now) + ")", now, 1e6);
        script.push_back({now, read_event(line)});
        if (!line.at_end()) line.fail("the end of the line");
    }
    return script;
}

std::string to_text(const EventScript& script)
{
    std::string text;
    for (const auto& [time, event] : script) text += shortest(time) + " " + std::visit(Writer{}, event) + "\n";
    return text;
}

}
