#include <gtest/gtest.h>

#include <cstring>
#include <umbral/record/block_trace.hpp>
#include <umbral/record/cost.hpp>

extern "C" void __sanitizer_cov_trace_pc();  // NOLINT(bugprone-reserved-identifier): the compiler chose the name

namespace umbral {
namespace {

using Rows = std::vector<std::uint32_t>;

std::optional<Rows> written(const BlockTrace& trace)
{
    std::map<std::string, Tensor, std::less<>> tensors;
    trace.write(tensors);
    const auto found = tensors.find(blocks_of_questions);
    if (found == tensors.end()) return std::nullopt;
    Rows rows(found->second.bytes.size() / sizeof(std::uint32_t));
    if (!rows.empty()) std::memcpy(rows.data(), found->second.bytes.data(), found->second.bytes.size());
    EXPECT_EQ(std::size_t{found->second.rows} * 2, rows.size());
    return rows;
}

TEST(BlockTrace, takes_down_each_place_once_a_question)
{
    BlockTrace trace(1000, [] {});
    trace.pass(1007);  // before the first question
    trace.next_question();
    for (int i = 0; i < 3; ++i)
        for (const std::uintptr_t address : {1004, 1002, 1004}) trace.pass(address);
    trace.next_question();
    trace.next_question();
    trace.pass(1004);
    EXPECT_EQ(written(trace), (Rows{0, 4, 0, 2, 2, 4}));
}

TEST(BlockTrace, says_which_questions_an_exception_ended)
{
    BlockTrace trace(0, [] {});
    trace.end_by_exception();  // before the first question
    trace.next_question();
    trace.pass(6);
    trace.next_question();
    trace.pass(6);
    trace.end_by_exception();
    EXPECT_EQ(written(trace), (Rows{0, 6, 1, 6, 1, ended_by_exception}));
}

TEST(BlockTrace, passes_over_what_lies_outside_of_the_library)
{
    BlockTrace trace(1U << 30U, [] {});
    trace.next_question();
    trace.pass(7);
    trace.pass(3U << 30U);
    EXPECT_EQ(written(trace), Rows{});
}

TEST(BlockTrace, tells_nothing_of_a_run_with_too_many)
{
    BlockTrace trace(0, [] {});
    for (std::size_t i = 0; i <= BlockTrace::most_rows; ++i) {
        trace.next_question();
        trace.pass(5);
    }
    EXPECT_EQ(written(trace), std::nullopt);
}

TEST(BlockTrace, ends_a_question_that_goes_round_for_ever_and_tells_where)
{
    std::uint64_t ends = 0;
    BlockTrace trace(0, [&] { ++ends; });
    trace.next_question();
    for (std::uint64_t i = 0; i < BlockTrace::most_blocks; ++i) trace.pass(7);
    trace.next_question();
    trace.pass(3);
    std::uint64_t passed = 1;
    for (; ends == 0; ++passed) trace.pass(passed % 2 == 0 ? 9 : 11);
    EXPECT_EQ(passed, BlockTrace::most_blocks + BlockTrace::blocks_in_loop);
    std::map<std::string, Tensor, std::less<>> tensors;
    trace.write(tensors);
    const Tensor& loop = tensors.at(std::string(blocks_of_loop));
    Rows places(loop.bytes.size() / sizeof(std::uint32_t));
    std::memcpy(places.data(), loop.bytes.data(), loop.bytes.size());
    EXPECT_EQ(places, (Rows{9, 11}));
}

TEST(BlockTrace, is_told_of_blocks_as_long_as_it_lives)
{
    const std::uint64_t before = blocks_executed();
    {
        BlockTrace trace(reinterpret_cast<std::uintptr_t>(&written) & ~std::uintptr_t{0xFFFFF}, [] {});
        trace.next_question();
        __sanitizer_cov_trace_pc();
        const auto rows = written(trace);
        ASSERT_TRUE(rows);
        EXPECT_EQ(rows->size(), 2U);
    }
    __sanitizer_cov_trace_pc();
    EXPECT_EQ(blocks_executed(), before + 2);
}

}
}
