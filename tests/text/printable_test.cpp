#include <gtest/gtest.h>

#include <random>

#include "text/printable.hpp"

namespace umbral {
namespace {

constexpr std::size_t plenty = 1 << 20;

TEST(Printable, keeps_good_text)
{
    for (const std::string text : {"", "a\tb\n", "¿Dónde corta?", "θ → 𝜃", "\xF4\x8F\xBF\xBF"})
        EXPECT_EQ(printable(text, plenty), text);
}

TEST(Printable, replaces_what_terminals_obey)
{
    EXPECT_EQ(printable("\x1b[2Jx", plenty), "\uFFFD[2Jx");
    EXPECT_EQ(printable(std::string("a\0b\r\x7f", 5), plenty), "a\uFFFDb\uFFFD\uFFFD");
    EXPECT_EQ(printable("\u0085\u009b1m", plenty), "\uFFFD\uFFFD1m");
    EXPECT_EQ(printable("\u202Eabc\u2066", plenty), "\uFFFDabc\uFFFD");
}

TEST(Printable, replaces_what_turns_or_hides_text)
{
    // All of Unicode's property Bidi_Control, and what no reader can see: letters as tags among them.
    for (const std::string one :
         {"\u061C", "\u200E", "\u200F", "\u202A",     "\u202B",     "\u202C",     "\u202D",     "\u202E",    "\u2066",
          "\u2067", "\u2068", "\u2069", "\u00AD",     "\u180E",     "\u200B",     "\u2060",     "\u206A",    "\u2028",
          "\u2029", "\uFEFF", "\uFFF9", "\U000E0041", "\U000E007F", "\u034F",     "\u115F",     "\u17B4",    "\u180B",
          "\u3164", "\uFE00", "\uFE0F", "\uFFA0",     "\U0001BCA0", "\U0001D173", "\U000E0100", "\U000E01EF"})
        EXPECT_EQ(printable("a" + one + "b", plenty), "a\uFFFDb");
}

// In any script: those of Thai are the best known.
TEST(Printable, keeps_few_marks_of_any_script)
{
    for (const std::string mark :
         {"\u0E47", "\u0651", "\u05C1", "\u0F74", "\u0941", "\u0EC8", "\u302A", "\uA670", "\U0001D167", "\U00011A0A"}) {
        std::string few = "a";
        for (int i = 0; i < 4; ++i) few += mark;
        EXPECT_EQ(printable(few + mark + "b", plenty), few + "\uFFFDb") << mark;
    }
}

// Towers of accents reach over the lines above and below.
TEST(Printable, keeps_few_marks_on_a_letter)
{
    const std::string mark = "\u0301";
    std::string tower = "a";
    for (int i = 0; i < 4; ++i) tower += mark;
    EXPECT_EQ(printable(tower + "b" + mark, plenty), tower + "b" + mark);
    EXPECT_EQ(printable(tower + mark + "\u0489b" + mark, plenty), tower + "\uFFFD\uFFFDb" + mark);
}

TEST(Printable, replaces_each_byte_of_invalid_utf8)
{
    EXPECT_EQ(printable("\xC0\xAF", plenty), "\uFFFD\uFFFD") << "over-long '/'";
    EXPECT_EQ(printable("\xE0\x80\xAF", plenty), "\uFFFD\uFFFD\uFFFD") << "over-long in three bytes";
    EXPECT_EQ(printable("\xED\xA0\x80", plenty), "\uFFFD\uFFFD\uFFFD") << "surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80", plenty), "\uFFFD\uFFFD\uFFFD\uFFFD") << "past U+10FFFF";
    EXPECT_EQ(printable("\xC3", plenty), "\uFFFD") << "cut short";
    EXPECT_EQ(printable("\xC3"
                        "a\xFF",
                        plenty),
              "\uFFFD"
              "a\uFFFD");
}

TEST(Printable, cuts_between_characters_and_says_so)
{
    EXPECT_EQ(printable("abcdef", 6), "abcdef");
    EXPECT_EQ(printable("abcdef", 4), "abcd\n[cut here: 2 more bytes]");
    EXPECT_EQ(printable("aéé", 4), "aé\n[cut here: 2 more bytes]");
    EXPECT_EQ(printable("\x01", 2), "\n[cut here: 1 more bytes]");
}

TEST(Printable, is_stable_under_random_bytes)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < 2000; ++round) {
        std::string text(random() % 40, '\0');
        for (char& byte : text) byte = static_cast<char>(random());
        const std::string once = printable(text, plenty);
        ASSERT_EQ(printable(once, plenty), once);
        ASSERT_LE(once.size(), 3 * text.size());
    }
}

}
}
