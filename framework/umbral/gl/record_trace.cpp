#include <charconv>
#include <cmath>
#include <string>
#include <umbral/gl/record_trace.hpp>

namespace umbral::gl {
namespace {

// Enumerants and counts in full; other numbers with the nine digits that tell floats apart.
void write_number(std::string& text, double value)
{
    constexpr double exact = 9007199254740992.0;
    char digits[32];
    const bool whole = std::abs(value) < exact && value == std::trunc(value);
    const auto end = whole ? std::to_chars(std::begin(digits), std::end(digits), static_cast<long long>(value))
                           : std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::general, 9);
    text.append(std::begin(digits), end.ptr);
}

}

void record_trace(Recorder& out, std::string_view name, const Trace& trace)
{
    std::string text;
    for (const TracedCall& call : trace.calls) {
        text += call.name;
        for (const double argument : call.arguments) {
            text += ' ';
            write_number(text, argument);
        }
        if (call.bytes > 0) text += " | " + std::to_string(call.bytes);
        text += '\n';
    }
    if (trace.truncated) text += "...\n";
    out.text(name, text);
}

}
