#include "explain/questions_in_turn.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "question/names.hpp"

namespace umbral::grader {
namespace {

using Key = std::tuple<std::string, std::string, std::string, std::string>;
Key key_of(const OtherQuestion& one) { return {one.function, one.place, one.change, one.other}; }

/// "angle" of "0.axis.angle".
std::string_view last_field(std::string_view place) { return place.substr(place.rfind('.') + 1); }

bool is_whole_argument(std::string_view place)
{
    return place.find_first_not_of("0123456789") == std::string_view::npos;
}

/// What the parameters of functions are called, looked up once for each.
class ParameterNames {
public:
    explicit ParameterNames(const std::string& headers) : headers_(headers) {}

    [[nodiscard]] const std::vector<std::string>& of(const std::string& function)
    {
        const auto [known, is_new] = names_.try_emplace(function);
        if (is_new && !function.empty()) known->second = parameter_names(headers_, function);
        return known->second;
    }

private:
    const std::string& headers_;
    std::map<std::string, std::vector<std::string>> names_;
};

/// Ways to misunderstand one part of the arguments.
class Turns {
public:
    void add(QuestionInTurn question)
    {
        const bool is_exchange = question.question.change.empty();
        const bool is_taken = !is_exchange && !question.question.other.empty();
        // Changes and other parts in turn, and a part exchanged with another for two of each.
        const std::size_t place = is_exchange ? 4 * exchanges_++ + 2 : is_taken ? 2 * taken_++ + 1 : 2 * changes_++;
        questions_.emplace_back(place, std::move(question));
    }

    [[nodiscard]] std::vector<QuestionInTurn> likeliest_first() const
    {
        std::vector<std::pair<std::size_t, QuestionInTurn>> sorted = questions_;
        std::ranges::stable_sort(sorted, {}, [](const auto& one) { return one.first; });
        std::vector<QuestionInTurn> result;
        for (auto& [place, question] : sorted) result.push_back(std::move(question));
        return result;
    }

private:
    std::vector<std::pair<std::size_t, QuestionInTurn>> questions_;
    std::size_t changes_ = 0;
    std::size_t taken_ = 0;
    std::size_t exchanges_ = 0;
};

/// The turns of all parts, in the order in which these come.
class AllTurns {
public:
    void add(const std::string& part, QuestionInTurn question)
    {
        const auto [known, is_new] = index_.try_emplace(part, turns_.size());
        if (is_new) turns_.emplace_back();
        question.declared = count_++;
        turns_[known->second].add(std::move(question));
    }

    [[nodiscard]] std::vector<QuestionInTurn> in_turn() const
    {
        std::vector<std::vector<QuestionInTurn>> all;
        for (const Turns& one : turns_) all.push_back(one.likeliest_first());
        std::vector<QuestionInTurn> result;
        for (std::size_t round = 0; result.size() < count_; ++round)
            for (const std::vector<QuestionInTurn>& one : all)
                if (round < one.size()) result.push_back(one[round]);
        return result;
    }

private:
    std::map<std::string, std::size_t> index_;
    std::vector<Turns> turns_;
    std::size_t count_ = 0;
};

/// Is `all` the same change as the one before it, of the same field, but in all calls?
bool is_same_everywhere(const OtherQuestion& one, const OtherQuestion& all)
{
    return !one.function.empty() && one.place.find('.') != std::string::npos && one.change == all.change &&
           last_field(one.place) == last_field(all.place) && last_field(one.other) == last_field(all.other);
}

/// May a number of this name be an angle, which is told in degrees or in radians? Names of other quantities say so.
bool may_be_angle(const std::string& words)
{
    constexpr std::array<std::string_view, 22> others{
        "plane",  "near", "far",  "size",   "width", "height", "length",   "distance", "radius", "depth", "scale",
        "factor", "step", "time", "second", "index", "count",  "exponent", "weight",   "error",  "t_min", "t_max"};
    const std::string_view name = last_field(words);
    return std::ranges::none_of(others,
                                [&](std::string_view other) { return name.find(other) != std::string_view::npos; });
}

/// Is a quantity that is no angle changed as an angle is?
bool is_no_angle(const OtherQuestion& one, ParameterNames& parameters)
{
    return one.change.starts_with("turned from ") && !may_be_angle(in_words(one.place, parameters.of(one.function)));
}

void add_known(const QuestionLog& log, ParameterNames& parameters, AllTurns& turns)
{
    std::map<Key, std::size_t> times;
    for (const OtherQuestion& one : log.others) ++times[key_of(one)];
    std::set<Key> added;
    for (std::size_t i = 0; i < log.others.size(); ++i) {
        const OtherQuestion& one = log.others[i];
        if (!added.insert(key_of(one)).second || is_no_angle(one, parameters)) continue;
        QuestionInTurn question{one};
        if (i + 1 < log.others.size()) {
            const OtherQuestion& next = log.others[i + 1];
            const bool same = next.function.empty() && times[key_of(next)] == 1 && is_same_everywhere(one, next);
            if (same && added.insert(key_of(next)).second) question.everywhere = next;
        }
        turns.add(one.function + ' ' + one.place, std::move(question));
    }
}

/// Changes of whole parts, which several parts can have in common.
std::vector<OtherQuestion> plain_changes(const QuestionLog& log)
{
    std::set<Key> known;
    std::vector<OtherQuestion> changes;
    for (const OtherQuestion& one : log.others)
        if (!one.function.empty() && !one.place.empty() && one.other.empty() && known.insert(key_of(one)).second)
            changes.push_back(one);
    return changes;
}

void add_together(const std::string& part, std::span<const OtherQuestion> changes, AllTurns& turns)
{
    OtherQuestion all = changes.front();
    for (const OtherQuestion& one : changes.subspan(1)) all.also.push_back({one.function, one.place});
    turns.add(part, {std::move(all)});
}

/// What is called alike in calls of different functions that objects have their state from.
void add_of_objects(const QuestionLog& log, const std::vector<OtherQuestion>& plain, ParameterNames& parameters,
                    AllTurns& turns)
{
    std::set<std::string> functions;
    for (const auto& [asked, changing] : log.histories) functions.insert(changing.begin(), changing.end());
    std::map<std::pair<std::string, std::string>, std::vector<OtherQuestion>> alike;
    std::vector<std::pair<std::string, std::string>> order;
    for (const OtherQuestion& one : plain) {
        if (!functions.contains(one.function)) continue;
        const std::string words = in_words(one.place, parameters.of(one.function));
        if (words.starts_with("the ")) continue;
        std::vector<OtherQuestion>& same = alike[{std::string(last_field(words)), one.change}];
        if (same.empty()) order.emplace_back(last_field(words), one.change);
        same.push_back(one);
    }
    for (const auto& name_and_change : order) {
        const std::vector<OtherQuestion>& same = alike[name_and_change];
        const bool of_one =
            std::ranges::all_of(same, [&](const OtherQuestion& one) { return one.function == same.front().function; });
        if (!of_one) add_together("the parts called " + name_and_change.first, same, turns);
    }
}

/// Lists of one function that say together what there is, such as places of lights beside their colours.
void add_of_lists(const std::vector<OtherQuestion>& plain, AllTurns& turns)
{
    std::map<std::pair<std::string, std::string>, std::vector<OtherQuestion>> alike;
    for (const OtherQuestion& one : plain)
        if (is_of_list(one)) alike[{one.function, one.change}].push_back(one);
    for (const auto& [function_and_change, same] : alike)
        if (same.size() > 1) add_together("the lists of " + function_and_change.first, same, turns);
}

/// Calls of two functions left out: what is set by one may be used as what is set by the other.
void add_left_out(const QuestionLog& log, AllTurns& turns)
{
    std::vector<OtherQuestion> all;
    for (const OtherQuestion& one : log.others)
        if (one.change == left_out) all.push_back(one);
    constexpr std::size_t most = 5;  ///< functions of which pairs are tried
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
        for (std::size_t j = i + 1; j < std::min(all.size(), most); ++j)
            add_together("calls left out", std::array{all[i], all[j]}, turns);
}

/// All arguments of a function, if each can be changed as the others can.
void add_of_functions(const std::vector<OtherQuestion>& plain, AllTurns& turns)
{
    std::map<std::string, std::map<std::string, std::vector<OtherQuestion>>> by_place;
    std::vector<std::string> order;
    for (const OtherQuestion& one : plain) {
        if (!by_place.contains(one.function)) order.push_back(one.function);
        by_place[one.function][one.place].push_back(one);
    }
    for (const std::string& function : order) {
        const auto& places = by_place[function];
        const std::vector<OtherQuestion>& first = places.begin()->second;
        const bool are_alike = std::ranges::all_of(places, [&](const auto& one) {
            return is_whole_argument(one.first) &&
                   std::ranges::equal(one.second, first, {}, &OtherQuestion::change, &OtherQuestion::change);
        });
        if (!are_alike || places.size() < 2) continue;
        for (std::size_t i = 0; i < first.size(); ++i) {
            std::vector<OtherQuestion> same;
            for (const auto& [place, changes] : places) same.push_back(changes[i]);
            add_together("the arguments of " + function, same, turns);
        }
    }
}

}

std::vector<QuestionInTurn> questions_in_turn(const QuestionLog& log, const std::string& headers)
{
    AllTurns turns;
    ParameterNames parameters(headers);
    add_known(log, parameters, turns);
    const std::vector<OtherQuestion> plain = plain_changes(log);
    add_of_objects(log, plain, parameters, turns);
    add_of_lists(plain, turns);
    add_left_out(log, turns);
    add_of_functions(plain, turns);
    return turns.in_turn();
}

bool may_change(const QuestionLog& log, const std::string& function, const std::string& asked)
{
    if (function == asked) return true;
    const auto changing = log.histories.find(asked);
    return changing != log.histories.end() && std::ranges::find(changing->second, function) != changing->second.end();
}

bool is_of_list(const OtherQuestion& question)
{
    constexpr std::array<std::string_view, 4> changes{"in reverse order", "without its first element",
                                                      "without its last element", "cut to its first element"};
    return std::ranges::find(changes, question.change) != changes.end();
}

int far_fetched(const OtherQuestion& question)
{
    if (!question.also.empty()) return several_at_once;
    if (question.change == taken_for_another || question.change.find(" taken as ") != std::string::npos)
        return one_for_another;
    if (question.change.starts_with("taken as") || question.change.starts_with("without its translation")) return 0;
    if (question.change.empty() || question.change.starts_with("normalised")) return 1;
    return 2;
}

}
