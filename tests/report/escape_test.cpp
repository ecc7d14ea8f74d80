#include <gtest/gtest.h>

#include <random>

#include "report/layout.hpp"
#include "text/escape.hpp"
#include "text/utf8.hpp"

namespace umbral::grader {
namespace {

TEST(Escape, makes_controls_visible)
{
    EXPECT_EQ(escape_terminal("a\x1b[31mb"), "a␛[31mb");
    EXPECT_EQ(escape_terminal("a\x1b[31mb", {.lines = false, .unicode = false}), "a^[[31mb");
    EXPECT_EQ(escape_terminal("x\ny"), "x␊y");
    EXPECT_EQ(escape_terminal("x\r\ny\rz", {.lines = true}), "x\ny␍z");
    EXPECT_EQ(escape_terminal("a\tb\n\tc", {.lines = true}), "a   b\n    c");
    EXPECT_EQ(escape_terminal(std::string("\0\x07\x7f", 3)), "␀␇␡");
    EXPECT_EQ(escape_terminal("\xC2\x9B"
                              "31m"),
              "<U+009B>31m")
        << "CSI as a C1 control";
}

TEST(Escape, makes_deception_visible)
{
    EXPECT_EQ(escape_terminal("a\u202Eb"), "a<U+202E>b");
    EXPECT_EQ(escape_terminal("a\u2066b\u200Bc\uFEFF"), "a<U+2066>b<U+200B>c<U+FEFF>");
}

TEST(Escape, makes_invalid_utf8_visible)
{
    EXPECT_EQ(escape_terminal("\xFF\xC0\x80"), "<FF><C0><80>");
    EXPECT_EQ(escape_terminal("\xE2\x82"), "<E2><82>") << "cut short";
    EXPECT_EQ(escape_terminal("\xED\xA0\x80"), "<ED><A0><80>") << "a surrogate";
    EXPECT_EQ(escape_terminal("\xF4\x90\x80\x80"), "<F4><90><80><80>") << "beyond Unicode";
    EXPECT_EQ(escape_terminal("ñandú 王 🎨"), "ñandú 王 🎨");
}

TEST(Escape, any_bytes_give_harmless_text)
{
    const unsigned seed = 7;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 2000; ++round) {
        std::string bytes(random() % 40, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        const std::string pretty = escape_terminal(bytes, {.lines = true});
        for (std::string_view rest = pretty; !rest.empty(); rest.remove_prefix(first_character(rest).size)) {
            const Character character = first_character(rest);
            ASSERT_TRUE(character.valid);
            ASSERT_TRUE(character.code == '\n' ||
                        (character.code >= 0x20 && (character.code < 0x7F || character.code > 0x9F)));
        }
        for (const char c : escape_terminal(bytes, {.lines = false, .unicode = false}))
            ASSERT_TRUE(c >= 0x20 && c < 0x7F);
    }
}

TEST(Escape, html)
{
    EXPECT_EQ(escape_html("<script>alert(\"a\" & 'b')</script>\x1b"),
              "&lt;script&gt;alert(&quot;a&quot; &amp; &#39;b&#39;)&lt;/script&gt;␛");
    EXPECT_EQ(escape_html("\xFF"), "&lt;FF&gt;");
}

TEST(Layout, width_of_what_a_terminal_shows)
{
    EXPECT_EQ(display_width("abc"), 3);
    EXPECT_EQ(display_width("\x1b[1;31mabc\x1b[0m"), 3);
    EXPECT_EQ(display_width("ñandú"), 5);
    EXPECT_EQ(display_width("n\u0303"), 1);
    EXPECT_EQ(display_width("王小明"), 6);
    EXPECT_EQ(display_width(""), 0);
}

TEST(Layout, shorten_keeps_within_the_width)
{
    EXPECT_EQ(shorten("abcdef", 6, "…"), "abcdef");
    EXPECT_EQ(shorten("abcdefg", 6, "…"), "abcde…");
    EXPECT_EQ(shorten("王小明", 4, "…"), "王…") << "half a wide character is none";
    EXPECT_EQ(shorten("abc", 0, "…"), "");
}

TEST(Layout, wrap_loses_nothing_and_stays_within_the_width)
{
    EXPECT_EQ(wrap("one two three", 7), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrap("abcdefgh", 3), (std::vector<std::string>{"abc", "def", "gh"}));
    EXPECT_EQ(wrap("a\n\nb\n", 10), (std::vector<std::string>{"a", "", "b"}));
    EXPECT_TRUE(wrap("", 10).empty());
    EXPECT_EQ(flow({"1 one", "2 two", "3 three"}, 14), (std::vector<std::string>{"1 one   2 two", "3 three"}));
}

}
}
