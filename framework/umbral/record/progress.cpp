#include "umbral/record/progress.hpp"

#include <algorithm>
#include <cstring>
#include <umbral/core/not_implemented_count.hpp>
#include <utility>

#include "umbral/record/tensor_of.hpp"

namespace umbral {

Progress::Progress(std::uint32_t& asked, std::span<char> function, PassedOver passed_over, std::function<void()> end)
    : asked_(asked), function_(function), passed_over_(std::move(passed_over)), end_(std::move(end))
{
}

bool Progress::begin(std::string_view function)
{
    if (turn_) turn_();
    const std::uint32_t question = asked_++;
    const std::size_t size = std::min(function.size(), function_.size() - 1);
    std::memcpy(function_.data(), function.data(), size);
    function_[size] = 0;
    stubs_before_ = not_implemented_count();
    if (question >= passed_over_.end) end_();
    const auto found = passed_over_.functions.find(function);
    passes_over_ = (passed_over_.only != no_question && question != passed_over_.only) ||
                   std::ranges::find(passed_over_.questions, question) != passed_over_.questions.end() ||
                   (found != passed_over_.functions.end() && question >= found->second);
    return passes_over_;
}

void Progress::add_row(std::string_view value, std::uint32_t row)
{
    if (!passes_over_ && not_implemented_count() == stubs_before_) return;
    auto found = lost_.find(value);
    if (found == lost_.end()) found = lost_.emplace(std::string(value), std::vector<std::uint32_t>()).first;
    found->second.push_back(row);
}

void Progress::write(std::map<std::string, Tensor, std::less<>>& tensors) const
{
    for (const auto& [value, rows] : lost_)
        tensors[std::string(rows_without_answer) + value] = tensor_of<std::uint32_t>(rows);
}

}
