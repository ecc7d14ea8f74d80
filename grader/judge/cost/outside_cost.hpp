#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// What runs took as seen from outside their process, in milliseconds of processor time: with no size of a table of
/// costs worked on, with the first few, and with all. Each is the least of several runs.
struct OutsideCost {
    double nothing = 0;
    double first_sizes = 0;
    double all_sizes = 0;

    /// Of the work itself, without what every run of the case takes.
    [[nodiscard]] double work() const { return all_sizes - nothing; }
    [[nodiscard]] double first_work() const { return first_sizes - nothing; }
};

/// How many of the first sizes to compare with all of them: up to a quarter of the largest, but not none. Sizes
/// increase.
[[nodiscard]] std::size_t sizes_to_compare(const std::vector<double>& sizes);

/// Does a run take so much longer than the reference's that its count is worth a measurement from outside? Both in
/// milliseconds.
[[nodiscard]] bool is_worth_measuring(double student, double reference);

/// Why the counted blocks cannot be believed, as a sentence for the student; nothing if the measurement from outside
/// agrees with them. They are not believed if
/// - the work grows faster than sizes^(growth + 0.6) allow, the exponent that is worth nothing to the judge of counts,
/// and takes more than
///   three times the reference's; or
/// - much more is done than by the reference before anything is counted.
/// `sizes` are those of the reference's table, `names` the word for what they count.
[[nodiscard]] std::optional<std::string> objection_from_outside(const OutsideCost& student,
                                                                const OutsideCost& reference,
                                                                const std::vector<double>& sizes, double growth,
                                                                std::string_view names);

}
