#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/judges/picture_pair.hpp"
#include "bench/judges/rule_table.hpp"

namespace umbral::grader {

/// How long one comparison of two pictures of 512 x 512 takes on one thread, in milliseconds: the best of several.
struct JudgeTimes {
    double identical = 0;
    double noise = 0;      ///< one level of noise everywhere
    double all_wrong = 0;  ///< every pixel far off
};
[[nodiscard]] JudgeTimes time_image_rule();

/// What `umbral bench judges` found out.
struct JudgeBench {
    std::vector<MeasuredPair> pairs;
    double pictures_per_submission = 0;  ///< image checks of all units
    JudgeTimes times;
};

/// What is known of a pair before any rule has looked at it.
[[nodiscard]] MeasuredPair unmeasured(const PicturePair& pair);
/// The same with what all rules say.
[[nodiscard]] MeasuredPair measure(const PicturePair& pair);

/// Tables for people: rules on the held-out half, with and without noise; margins; faults that were not caught; time.
[[nodiscard]] std::string as_markdown(const JudgeBench& bench);
/// Every pair with every measure, and the tables' figures.
[[nodiscard]] nlohmann::json as_json(const JudgeBench& bench);

}
