#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "judge/evidence/evidence.hpp"
#include "judge/explain/explain.hpp"
#include "judge/rows/alignment.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/tensor_view.hpp"
#include "model/exercise.hpp"
#include "model/named_rows.hpp"

namespace umbral::grader {

/// Names of event codes, or of other things that are counted, from lines such as "3 zoom"; other lines are passed over.
[[nodiscard]] std::map<double, std::string> event_names(std::string_view lines);

/// The same without what follows a colon, "zoom" of "3 zoom: centre/2, factor", which says what the numbers are called.
[[nodiscard]] std::map<double, NamedRows> event_kinds(std::string_view lines, std::size_t components);

/// Writes events with their names, and their numbers with theirs: "zoom (centre 2 0.5, factor 3)" where the line of
/// that code is "3 zoom: centre/2, factor". Numbers without a name are left out if there are names; where there are
/// none, those at the end that are 0 and that no expected event of that code uses.
class EventWriter {
public:
    EventWriter(const TensorView& expected, std::string_view names);

    [[nodiscard]] std::string operator()(std::span<const double> event, int digits = usual_digits) const;

    /// Both, the second one beside the first. Of two of a kind that hold many names, what is equal is left out, but for
    /// the first: "an object (name 10, …, specular 0 0 0, …)".
    [[nodiscard]] std::pair<std::string, std::string> beside(std::span<const double> one, std::span<const double> other,
                                                             int digits) const;

private:
    struct Kind {
        std::string name;
        std::vector<ColumnGroup> columns;
    };

    /// Numbers of an event that are shown together, "specular 0 0 0".
    [[nodiscard]] std::vector<std::string> parts(std::span<const double> event, int digits) const;
    [[nodiscard]] std::string with_parts(std::span<const double> event, const std::vector<std::string>& parts) const;

    std::map<double, Kind> kinds_;
    std::map<double, std::size_t> used_;
};

/// What each number of an event is called: nothing unless all kinds of events that have names for their numbers call
/// each the same.
[[nodiscard]] std::vector<std::string> event_columns(std::string_view names, std::size_t components);

/// Wrong as a mistake is: sequences that differ by at most a twentieth of what parts them from the expected one.
[[nodiscard]] Resemblance same_events(const FailingCheck& failing, const Tensor& mistake);

/// What a page shows of events; nothing if they are right.
[[nodiscard]] Evidence events_evidence(const Check& check, const Observation& observation, bool right);

/// The events of two tables aligned: equal codes, and numbers within the check's tolerance (none: equal). Where `a` is
/// far longer than `b`, its end is left out, so that the time is bounded by what was expected.
[[nodiscard]] Alignment align_events(const Check& check, const TensorView& a, const TensorView& b);

}
