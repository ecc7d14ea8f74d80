#pragma once

#include <string>

namespace umbral::render::budget {

/// What is asked of a picture: an error, and it shall be cheap; or a time, and it shall be accurate.
struct Wish {
    bool is_error = true;
    double value = 0;  ///< of full scale, 0.01 for 1 %; or seconds. > 0
};

/// "1%" and "2s", "250ms", of which one must be given, the other empty. Throws std::runtime_error that
/// says what was expected and what came: errors are above 0 % and below 100 %, times above 0 s and at most a day.
[[nodiscard]] Wish parse_wish(const std::string& error, const std::string& time);

}
