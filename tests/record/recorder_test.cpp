#include <gtest/gtest.h>

#include <stdexcept>
#include <umbral/record/recorder.hpp>

namespace umbral {
namespace {

TEST(Recorder, rows_that_may_be_missing_and_rows_that_are_always_there_share_a_table)
{
    Recorder out;
    out.append("sizes", glm::vec2(3, 4));
    out.append("sizes", std::optional<glm::vec2>());
    out.append("sizes", glm::vec2(5, 6));
    out.append("sizes", std::optional(glm::vec2(7, 8)));
    const Tensor& table = out.tensors().at("sizes");
    EXPECT_EQ(table.rows, 4U);
    EXPECT_EQ(table.present, (std::vector<std::uint8_t>{1, 0, 1, 1}));
    EXPECT_EQ(table.bytes.size(), 4 * sizeof(glm::vec2));
}

TEST(Recorder, of_a_table_all_rows_have_one_type)
{
    Recorder out;
    out.append("sizes", std::optional<float>());
    EXPECT_THROW(out.append("sizes", glm::vec2(1, 2)), std::logic_error);
    EXPECT_THROW(out.append("sizes", 1.0), std::logic_error);
}

}
}
