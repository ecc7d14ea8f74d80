#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "explain/asked_sample.hpp"

namespace umbral::grader {

/// Something that is so for 1 answer of 100 but one is found out with these many; few are asked at a time.
inline constexpr std::size_t enough_answers = 200;
inline constexpr std::size_t least_confirmed = 2;  ///< sets of fresh inputs with wrong answers

[[nodiscard]] std::size_t wrong_in(const std::vector<bool>& wrong);
[[nodiscard]] std::size_t wrong_in(const AnswerTable& table);

/// Inputs of a check's case, from 0 on: of a visible one first those that were graded, of a hidden one practice inputs.
[[nodiscard]] std::uint64_t input_seed(const AskedCheck& asked, std::size_t place);

/// The same with what is written down in the driver varied: inputs on which is confirmed what others showed.
[[nodiscard]] std::uint64_t varied_seed(const AskedCheck& asked, std::size_t place);

/// A check's answers in which something is looked for, and others on which it is confirmed; each found out once, when
/// first asked for.
class Samples {
public:
    /// Fresh sets take no more than `seconds`. Both others must live as long.
    Samples(Worker& worker, const AskedCheck& asked, double seconds) : worker_(worker), asked_(asked), seconds_(seconds)
    {
    }

    /// Where few answers are wrong, with answers to other questions of the case, up to three times as many.
    [[nodiscard]] const AskedSample& seen();

    /// Does the case ask the same at every desk? Of a hidden one nobody knows: no.
    [[nodiscard]] bool is_fixed();

    /// How many sets of inputs that were not seen may be asked: six, or as many as there is time for, what the trusted
    /// solutions take among it.
    [[nodiscard]] std::size_t fresh_sets();

    /// Answers to inputs that were not seen, 1 to fresh_sets(). What is written down in the driver is varied in them:
    /// what is so of the one scene that it draws may be so by chance.
    [[nodiscard]] const AskedSample& fresh(std::size_t number);

    /// Is it so of most of the unit's known mistakes, asked the same as was seen (as_other_mistakes.hpp)?
    [[nodiscard]] bool is_so_of_most_mistakes(
        const std::function<std::optional<bool>(const AskedSample& mistake)>& is_so) const;

private:
    static constexpr std::size_t most_fresh = 6;

    [[nodiscard]] double seconds_of_a_set() const;
    [[nodiscard]] AskedSample others(std::size_t place, const AskedSample& but) const;
    void add_to(AskedSample& first);

    Worker& worker_;
    const AskedCheck& asked_;
    double seconds_;
    std::optional<AskedSample> seen_;
    std::size_t used_ = 1;  ///< places of seeds
    std::optional<bool> fixed_;
    std::optional<std::size_t> fresh_sets_;
    std::array<std::optional<AskedSample>, most_fresh> fresh_;
};

}
