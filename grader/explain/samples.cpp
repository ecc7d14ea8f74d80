#include "explain/samples.hpp"

#include <algorithm>
#include <umbral/record/variation.hpp>
#include <vector>

#include "explain/as_other_mistakes.hpp"
#include "worker/seeds.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t enough_wrong = 8;  ///< answers in which something can be looked for
constexpr std::size_t most_added = 3;    ///< sets of other inputs

}

std::size_t wrong_in(const std::vector<bool>& wrong)
{
    return static_cast<std::size_t>(std::ranges::count(wrong, true));
}

std::size_t wrong_in(const AnswerTable& table)
{
    return static_cast<std::size_t>(std::ranges::count_if(table.answers, &AnswerPair::wrong));
}

std::uint64_t input_seed(const AskedCheck& asked, std::size_t place)
{
    return asked.result.hidden ? practice_seed(asked.exercise, asked.check.case_name, place)
                               : seed_at(asked.result.seed, place);
}

std::uint64_t varied_seed(const AskedCheck& asked, std::size_t place)
{
    return VariedSeed::with_mark(input_seed(asked, place));
}

double Samples::seconds_of_a_set() const
{
    const auto seconds = [&](Answers solution) {
        return worker_.trusted(asked_.exercise, solution, asked_.check.case_name, input_seed(asked_, 0)).cpu_seconds;
    };
    // The reference also runs to tell of its questions.
    const double reference = seconds(Answers::reference);
    const Answers judged = judged_against(asked_.check);
    return 2 * reference + (judged == Answers::reference ? 0 : seconds(judged)) + asked_.result.student.cpu_seconds;
}

std::size_t Samples::fresh_sets()
{
    if (!fresh_sets_) {
        const double sets = seconds_ / std::max(seconds_of_a_set(), 1e-6);
        fresh_sets_ = static_cast<std::size_t>(std::clamp<double>(sets, 0, most_fresh));
    }
    return *fresh_sets_;
}

AskedSample Samples::others(std::size_t place, const AskedSample& but) const
{
    return asked_sample(worker_, asked_, VariedSeed::without_mark(input_seed(asked_, place)), &but);
}

void Samples::add_to(AskedSample& first)
{
    const std::size_t wrong = wrong_in(first.answers);
    AskedSample all = first;
    bool same = true;
    while (used_ <= std::min(most_added, fresh_sets()) && wrong_in(all.answers) < enough_wrong) {
        const AskedSample more = others(used_++, first);
        if (!fixed_) fixed_ = !asked_.result.hidden && more.answers.answers.empty();
        if (!add(all, more)) return;
        same = same && wrong_in(more.answers) == wrong;
    }
    // Hidden inputs are always varied. As many wrong ones every time may be the same question written down, every time
    // a little different, and that is one example and not four.
    if (asked_.result.hidden && same && wrong < least_wrong) return;
    first = std::move(all);
}

const AskedSample& Samples::seen()
{
    if (!seen_) {
        seen_ = asked_sample(worker_, asked_, input_seed(asked_, 0));
        if (wrong_in(seen_->answers) < enough_wrong) add_to(*seen_);
    }
    return *seen_;
}

bool Samples::is_fixed()
{
    (void)seen();
    if (!fixed_) fixed_ = !asked_.result.hidden && others(used_++, *seen_).answers.answers.empty();
    return *fixed_;
}

const AskedSample& Samples::fresh(std::size_t number)
{
    (void)seen();
    std::optional<AskedSample>& one = fresh_.at(number - 1);
    // Behind all places that may be used otherwise.
    if (!one) one = asked_sample(worker_, asked_, varied_seed(asked_, most_added + 1 + number));
    return *one;
}

bool Samples::is_so_of_most_mistakes(const std::function<std::optional<bool>(const AskedSample& mistake)>& is_so) const
{
    return OtherMistakes(worker_, asked_).most([&](const AskedCheck& mistake) {
        return is_so(asked_sample(worker_, mistake, input_seed(asked_, 0)));
    });
}

}
