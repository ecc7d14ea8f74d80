#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <interaction/pick-buffer/sessions.hpp>
#include <optional>

// Linked with the reference. What is expected was worked out by hand, or is GLM's.

using namespace umbral;
using namespace umbral::interaction;
using Words = std::vector<std::uint32_t>;

namespace {

constexpr double steps = 4294967295.0;

Words words_of(const SelectionBuffer& buffer) { return {buffer.words().begin(), buffer.words().end()}; }

}

TEST(PickMatrix, known_answers)
{
    const glm::mat4 matrix = pick_matrix({320, 240}, 5, {640, 480});
    EXPECT_EQ(matrix[0][0], 128);
    EXPECT_EQ(matrix[1][1], 96);
    EXPECT_EQ(matrix[3], glm::vec4(-0.2F, 0.2F, 0, 1));
    EXPECT_EQ(pick_matrix({0, 0}, 1, {1, 1}), glm::mat4(1));
}

TEST(PickMatrix, agrees_with_glm)
{
    constexpr std::uint64_t seed = 45001;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const auto below = [&](std::uint32_t count) { return static_cast<int>(random.below(count)); };
        const int width = 1 + below(3000);
        const glm::ivec2 picture(width, 1 + below(3000));
        const int column = below(4000) - 500;
        const glm::ivec2 pixel(column, below(4000) - 500);
        const float size = random.uniform(0.1F, 50);
        const glm::dvec2 centre(pixel.x + 0.5, picture.y - pixel.y - 0.5);
        const glm::dmat4 expected = glm::pickMatrix(centre, glm::dvec2(size), glm::dvec4(0, 0, picture));
        const glm::mat4 got = pick_matrix(pixel, size, picture);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                ASSERT_NEAR(got[c][r], expected[c][r], 6.1e-8 * std::abs(expected[c][r]) + 1e-9) << "seed " << seed;
    }
}

TEST(ParseSelection, known_answers)
{
    const Words words = {2, 10, 20, 3, 4, 0, 5, 6};
    const auto records = parse_selection(words, 2);
    ASSERT_TRUE(records.has_value());
    ASSERT_EQ(records->size(), 2U);
    EXPECT_EQ((*records)[0].names, Words({3, 4}));
    EXPECT_EQ((*records)[1].min_depth, 5U);
    EXPECT_TRUE((*records)[1].names.empty());
    EXPECT_EQ(nearest_record(*records), 1U);
    EXPECT_FALSE(parse_selection(words, -1));
    EXPECT_FALSE(parse_selection(words, 3));
    EXPECT_EQ(parse_selection(words, 0)->size(), 0U);
    EXPECT_FALSE(parse_selection(Words{~0U, 1, 2, 3}, 1));
    EXPECT_FALSE(nearest_record({}));
    const std::vector<SelectionRecord> far_first = {{0x90000000U, ~0U, {}}, {0x10000000U, ~0U, {}}};
    EXPECT_EQ(nearest_record(far_first), 1U) << "depths have no sign";
}

TEST(ParseSelection, reads_what_was_written)
{
    constexpr std::uint64_t seed = 45002;
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        std::vector<SelectionRecord> made(random.below(6));
        Words words;
        for (SelectionRecord& one : made) append_words(words, one = random_record(random));
        const auto parsed = parse_selection(words, static_cast<int>(made.size()));
        ASSERT_TRUE(parsed.has_value()) << "seed " << seed;
        Words again;
        for (const SelectionRecord& one : *parsed) append_words(again, one);
        ASSERT_EQ(again, words) << "seed " << seed << ", buffer " << i;
        if (!words.empty()) {
            words.pop_back();
            ASSERT_FALSE(parse_selection(words, static_cast<int>(made.size()))) << "seed " << seed;
        }
    }
}

TEST(SelectionBuffer, the_statements_example)
{
    const auto buffer = make_selection_buffer(20);
    EXPECT_TRUE(buffer->push_name(1));
    buffer->note_primitive(0.25, 0.5);
    buffer->note_primitive(0.125, 0.25);
    EXPECT_TRUE(buffer->push_name(2));
    EXPECT_TRUE(buffer->pop_name());
    EXPECT_TRUE(buffer->pop_name());
    EXPECT_FALSE(buffer->pop_name());
    buffer->note_primitive(0, 1);
    EXPECT_EQ(buffer->finish(), 2);
    EXPECT_EQ(words_of(*buffer), Words({1, 536870912, 2147483648, 1, 0, 0, 4294967295}));
    EXPECT_EQ(buffer->finish(), 0);
}

TEST(SelectionBuffer, depths_are_rounded_to_the_nearest)
{
    const auto buffer = make_selection_buffer(3);
    buffer->note_primitive(7.4 / steps, 7.6 / steps);
    EXPECT_EQ(buffer->finish(), 1);
    EXPECT_EQ(words_of(*buffer), Words({0, 7, 8}));
}

TEST(SelectionBuffer, a_record_without_room_makes_the_count_negative)
{
    for (const std::size_t room : {0, 3, 4, 5}) {
        const auto buffer = make_selection_buffer(room);
        (void)buffer->push_name(9);
        buffer->note_primitive(0, 1);
        EXPECT_EQ(buffer->finish(), room >= 4 ? 1 : -1) << room;
        EXPECT_EQ(buffer->finish(), 0) << "the next selection";
    }
}
