#include "umbral/record/block_trace.hpp"

#include <algorithm>
#include <utility>

#include "umbral/record/cost.hpp"
#include "umbral/record/tensor_of.hpp"

namespace umbral {
namespace {

/// Code of a student's library lies far below that.
constexpr std::uintptr_t most_places = std::uintptr_t{1} << 22U;

}

BlockTrace::BlockTrace(std::uintptr_t base, std::function<void()> end) : base_(base), end_(std::move(end))
{
    follow_blocks(this);
}

BlockTrace::~BlockTrace() { follow_blocks(nullptr); }

void BlockTrace::pass(std::uintptr_t address)
{
    const std::uintptr_t place = address - base_;
    if (questions_ == 0 || place >= most_places) return;
    if (++passed_ > most_blocks) return pass_too_late(static_cast<std::uint32_t>(place));
    if (place >= last_.size()) last_.resize(std::max<std::size_t>(place + 1, 2 * last_.size()), 0);
    if (last_[place] == questions_) return;
    last_[place] = questions_;
    add_row(static_cast<std::uint32_t>(place));
}

void BlockTrace::end_by_exception()
{
    if (questions_ > 0) add_row(ended_by_exception);
}

void BlockTrace::add_row(std::uint32_t place)
{
    if (rows_.size() > most_rows * 2) return;
    rows_.push_back(questions_ - 1);
    rows_.push_back(place);
}

void BlockTrace::pass_too_late(std::uint32_t place)
{
    loop_.insert(place);
    if (passed_ >= most_blocks + blocks_in_loop) end_();
}

void BlockTrace::write(std::map<std::string, Tensor, std::less<>>& tensors) const
{
    if (rows_.size() <= most_rows * 2) tensors[std::string(blocks_of_questions)] = tensor_of<std::uint32_t>(rows_, 2);
    const std::vector<std::uint32_t> loop(loop_.begin(), loop_.end());
    if (!loop.empty()) tensors[std::string(blocks_of_loop)] = tensor_of<std::uint32_t>(loop);
}

}
