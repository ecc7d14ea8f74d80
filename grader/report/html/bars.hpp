#pragma once

#include <optional>
#include <string>

#include "report/html/evidence.hpp"
#include "report/html/markup.hpp"

namespace umbral::grader::html {

/// A thin bar filled as score / max_score; empty unless something was earned, full only if all was. For the eye only:
/// whoever uses it says the same in words.
[[nodiscard]] Markup points_bar(long long score, long long max_score, std::string_view kind);

/// The student's time above the reference's, with both in words.
[[nodiscard]] Markup time_bars(double yours, double reference);

/// The student's error and the reference's own on a logarithmic scale whose middle is what is allowed, with all three
/// in words. Nothing if there is no error to show.
[[nodiscard]] Markup error_scale(const std::optional<double>& yours, const std::optional<double>& reference,
                                 const CheckDetail& detail);

/// "21 ms", "1.4 s"; "–" for what is not finite.
[[nodiscard]] std::string seconds_text(double seconds);

/// Three digits, as "3.36e+07" or "0.25".
[[nodiscard]] std::string short_number(double value);

}
