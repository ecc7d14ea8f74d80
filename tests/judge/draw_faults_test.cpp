#include <gtest/gtest.h>

#include "judge/trace/draw_faults.hpp"

namespace umbral::grader::test {
namespace {

// 34962 is GL_ARRAY_BUFFER, 34963 GL_ELEMENT_ARRAY_BUFFER, 5126 GL_FLOAT, 5125 GL_UNSIGNED_INT, 35044 GL_STATIC_DRAW:
// 128 vertices of 12 bytes, and 6 indices.
const std::string made =
    "glBindVertexArray 1\nglBindBuffer 34962 1\nglBufferData 34962 1536 1 35044 | 1536\n"
    "glVertexAttribPointer 0 3 5126 0 12 0\nglEnableVertexAttribArray 0\n"
    "glBindBuffer 34963 2\nglBufferData 34963 24 1 35044 | 24\nglBindBuffer 34962 0\nglBindVertexArray 0\n";
const std::string drawn = "glBindVertexArray 1\nglDrawElements 4 6 5125 0\n";

std::string with(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::vector<std::string> faults(const std::string& yours, const std::string& expected = made + drawn)
{
    std::vector<std::string> names;
    for (const DrawFault& one : draw_faults(*parse_gl_trace(yours), *parse_gl_trace(expected)))
        names.push_back(one.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(DrawFaults, are_none_where_all_is_there)
{
    EXPECT_EQ(faults(made + drawn), Names{});
    EXPECT_EQ(faults(made + "glBindVertexArray 1\nglDrawArrays 4 0 128\n"), Names{});
    // Other types and strides, as long as the buffer holds as many.
    EXPECT_EQ(faults(with(with(made, "34962 1536 1", "34962 3072 1"), "5126 0 12 0", "5126 0 24 12") + drawn), Names{});
    EXPECT_EQ(faults(with(made, "5126 0 12 0", "5126 0 0 0") + drawn), Names{});
}

TEST(DrawFaults, tell_of_indices_that_the_buffer_does_not_hold)
{
    const auto found = draw_faults(*parse_gl_trace(made + "glBindVertexArray 1\nglDrawElements 4 6 5125 12\n"),
                                   *parse_gl_trace(made + drawn));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].sentence,
              "Your draw call reads past the end of the index buffer: glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, "
              "12) takes 6 indices of 4 bytes from byte 12 on, and the buffer has 24 bytes. Look at the number of "
              "indices, their type, the offset, and the size that the buffer was given.");
    EXPECT_EQ(faults(made + "glBindVertexArray 1\nglDrawRangeElements 4 0 9 7 5125 0\n"), Names{found[0].name});
    EXPECT_EQ(faults(made + "glBindVertexArray 1\nglDrawElements 4 12 5123 0\n"), Names{});
}

TEST(DrawFaults, tell_of_vertices_that_the_buffer_does_not_hold)
{
    const std::string wide = with(made, "0 3 5126 0 12 0", "0 4 5126 0 16 0");
    const auto found = draw_faults(*parse_gl_trace(wide + drawn), *parse_gl_trace(made + drawn));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].sentence.find("attribute 0 takes 4 numbers (16 bytes) every 16 bytes, from byte 0 on, so its "
                                     "buffer of 1,536 bytes holds 96 vertices; 128 are needed"),
              std::string::npos)
        << found[0].sentence;
    EXPECT_EQ(faults(made + "glBindVertexArray 1\nglDrawArrays 4 1 128\n"), Names{found[0].name});
    // Once for each instance.
    EXPECT_EQ(faults(wide + "glBindVertexArray 1\nglVertexAttribDivisor 0 1\nglDrawElements 4 6 5125 0\n"), Names{});
}

TEST(DrawFaults, tell_of_attributes_that_are_fed_or_enabled_alone)
{
    EXPECT_EQ(faults(with(made, "glEnableVertexAttribArray 0", "glEnableVertexAttribArray 1") + drawn),
              (Names{"an attribute that is not enabled", "an attribute without data"}));
}

TEST(DrawFaults, say_nothing_of_what_the_calls_do_not_show)
{
    // Made before the trace; fed from the application's memory; by other functions; an address for an offset.
    EXPECT_EQ(faults("glBindVertexArray 1\nglDrawElements 4 9999 5125 0\n"), Names{});
    EXPECT_EQ(faults("glVertexAttribPointer 0 3 5126 0 0 1\nglEnableVertexAttribArray 0\nglDrawArrays 4 0 9999\n"),
              Names{});
    EXPECT_EQ(faults(made + "glVertexArrayElementBuffer 1 7\nglBindVertexArray 1\nglDrawElements 4 9999 5125 0\n"),
              Names{});
    EXPECT_EQ(faults(made + "glBindVertexArray 1\nglDrawElements 4 6 5125 1\n"), Names{});
    // Objects that have no number.
    EXPECT_EQ(faults(made + "glBindVertexArray nan\nglBindBuffer 34963 inf\nglBindBuffer 34962 -1\n" + drawn), Names{});
    // Arguments that are missing, or no numbers of anything.
    EXPECT_EQ(
        faults(made + "glBindVertexArray\nglVertexAttribPointer -3 1e300\nglDrawElements\nglDrawArrays 1e300 5 9\n"),
        Names{});
}

}
}
