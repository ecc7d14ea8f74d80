#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral {

/// In a recording: rows "question, place" of the basic blocks that each question came through, each once, in the order
/// in which they ran first. A place is an address behind the block's beginning, counted from where the library lies.
inline constexpr std::string_view blocks_of_questions = "?blocks";

/// Takes down through which basic blocks of counted code (cost.hpp) each question of a run went.
class BlockTrace {
public:
    /// So many rows are taken down; of a run with more nothing is told.
    static constexpr std::size_t most_rows = std::size_t{1} << 18U;

    /// Follows the library that lies from `base` on, as long as this lives. One at a time.
    explicit BlockTrace(std::uintptr_t base);
    BlockTrace(const BlockTrace&) = delete;
    BlockTrace& operator=(const BlockTrace&) = delete;
    ~BlockTrace();

    /// The next question begins. They are counted from 0; what runs before the first belongs to none.
    void next_question() noexcept { ++questions_; }

    /// A block runs, whose code goes on at `address`.
    void pass(std::uintptr_t address);

    /// Adds what was taken down to a recording's tensors.
    void write(std::map<std::string, Tensor, std::less<>>& tensors) const;

private:
    std::uintptr_t base_;
    std::uint32_t questions_ = 0;
    std::vector<std::uint32_t> last_{};  ///< for each place, the last question that came through it, counted from 1
    std::vector<std::uint32_t> rows_{};
};

}
