#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral {

/// In a recording: rows "question, place" of the basic blocks that each question came through, each once, in the order
/// in which they ran first. A place is an address behind the block's beginning, counted from where the library lies.
inline constexpr std::string_view blocks_of_questions = "?blocks";

/// As a place: the question ended by an exception.
inline constexpr std::uint32_t ended_by_exception = 0xFFFFFFFF;

/// In a recording that ended in a question which took too long: the places that it came through last.
inline constexpr std::string_view blocks_of_loop = "?loop";

/// Takes down through which basic blocks of counted code (cost.hpp) each question of a run went.
class BlockTrace {
public:
    /// So many rows are taken down; of a run with more nothing is told.
    static constexpr std::size_t most_rows = std::size_t{1} << 18U;
    /// So many blocks may one question run: a second's work, and the same at every desk.
    static constexpr std::uint64_t most_blocks = 100'000'000;
    /// So many of those that run then are taken for those of its loop.
    static constexpr std::uint64_t blocks_in_loop = 10'000;

    /// Follows the library that lies from `base` on, as long as this lives. One at a time. `end` ends the run where a
    /// question takes too long, and does not return.
    BlockTrace(std::uintptr_t base, std::function<void()> end);
    BlockTrace(const BlockTrace&) = delete;
    BlockTrace& operator=(const BlockTrace&) = delete;
    ~BlockTrace();

    /// The next question begins. They are counted from 0; what runs before the first belongs to none.
    void next_question() noexcept
    {
        ++questions_;
        passed_ = 0;
    }

    /// An exception ends the current question.
    void end_by_exception();

    /// A block runs, whose code goes on at `address`.
    void pass(std::uintptr_t address);

    /// Adds what was taken down to a recording's tensors.
    void write(std::map<std::string, Tensor, std::less<>>& tensors) const;

private:
    void pass_too_late(std::uint32_t place);
    void add_row(std::uint32_t place);

    std::uintptr_t base_;
    std::function<void()> end_;
    std::uint64_t passed_ = 0;  ///< blocks of the current question
    std::set<std::uint32_t> loop_{};
    std::uint32_t questions_ = 0;
    std::vector<std::uint32_t> last_{};  ///< for each place, the last question that came through it, counted from 1
    std::vector<std::uint32_t> rows_{};
};

}
