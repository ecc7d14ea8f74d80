#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <umbral/record/tensor.hpp>
#include <utility>
#include <vector>

namespace umbral {

/// A number that no question has.
inline constexpr std::uint32_t no_question = 0xFFFFFFFFU;

/// Questions of a student's run that are not asked again, because an earlier run ended in them, or to see what another
/// one gives without them. They are counted from 0; in their place the driver gets an empty answer.
struct PassedOver {
    std::vector<std::uint32_t> questions{};
    std::map<std::string, std::uint32_t, std::less<>>
        functions{};                   ///< that are not asked from a question on, as Progress is told their names
    std::uint32_t end = no_question;   ///< the first one that is never asked: there the case ends
    std::uint32_t only = no_question;  ///< if given, all others are passed over
};

/// In a recording, before a value's name: the rows of its table that follow from an answer that nobody gave, since the
/// question was passed over or reached a stub.
inline constexpr std::string_view rows_without_answer = "?lost ";

/// How far a student's run came with its questions, written where it can be read when the run is dead: a crash is told
/// with the question that led to it, and a second run passes over that one and goes on.
class Progress {
public:
    /// `asked` takes the number of questions begun, `function` the name of what was called last, zero-terminated. `end`
    /// ends the case with what is recorded, and does not return.
    Progress(std::uint32_t& asked, std::span<char> function, PassedOver passed_over, std::function<void()> end);

    /// Has `turn` called whenever a question begins: what runs beside this one takes its turn then.
    void at_each_question(std::function<void()> turn) { turn_ = std::move(turn); }

    /// The next question begins, a call of `function`. True if it is to be passed over.
    bool begin(std::string_view function);
    /// Ends the case: what was asked has no empty answer, and what follows needs one.
    void end() const { end_(); }

    /// A row of the table `value` was recorded.
    void add_row(std::string_view value, std::uint32_t row);
    /// Adds the rows without an answer to a recording's tensors.
    void write(std::map<std::string, Tensor, std::less<>>& tensors) const;

private:
    std::uint32_t& asked_;
    std::span<char> function_;
    PassedOver passed_over_;
    std::function<void()> end_;
    std::function<void()> turn_{};
    bool passes_over_ = false;
    unsigned stubs_before_ = 0;  ///< how often a stub had been reached when the question began
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> lost_;
};

}
