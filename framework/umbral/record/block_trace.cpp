#include "umbral/record/block_trace.hpp"

#include <algorithm>
#include <cstring>

#include "umbral/record/cost.hpp"

namespace umbral {
namespace {

/// Code of a student's library lies far below that.
constexpr std::uintptr_t most_places = std::uintptr_t{1} << 22U;
constexpr std::uint32_t columns = 2;

}

BlockTrace::BlockTrace(std::uintptr_t base) : base_(base) { follow_blocks(this); }

BlockTrace::~BlockTrace() { follow_blocks(nullptr); }

void BlockTrace::pass(std::uintptr_t address)
{
    const std::uintptr_t place = address - base_;
    if (questions_ == 0 || place >= most_places || rows_.size() > most_rows * columns) return;
    if (place >= last_.size()) last_.resize(std::max<std::size_t>(place + 1, 2 * last_.size()), 0);
    if (last_[place] == questions_) return;
    last_[place] = questions_;
    rows_.push_back(questions_ - 1);
    rows_.push_back(static_cast<std::uint32_t>(place));
}

void BlockTrace::write(std::map<std::string, Tensor, std::less<>>& tensors) const
{
    if (rows_.size() > most_rows * columns) return;
    Tensor tensor{Element::uint32, static_cast<std::uint32_t>(rows_.size() / columns), 1, columns, {}, {}};
    tensor.bytes.resize(rows_.size() * sizeof rows_.front());
    if (!rows_.empty()) std::memcpy(tensor.bytes.data(), rows_.data(), tensor.bytes.size());
    tensors[std::string(blocks_of_questions)] = std::move(tensor);
}

}
