#include <fmt/format.h>

#include <algorithm>

#include "report/layout.hpp"
#include "report/notices.hpp"
#include "report/paint.hpp"
#include "report/terminal.hpp"

namespace umbral::grader {

std::string class_notices(const ClassResult& result, const TerminalStyle& style)
{
    const Paint paint(style);
    const int width = std::max(style.width, 60);
    std::string text;
    for (const Notice& notice : notices(result)) {
        const Tone tone = notice.fault ? Tone::fault : Tone::strong;
        bool first = true;
        const auto add = [&](const std::string& paragraph, Tone looks) {
            for (const std::string& line : wrap(paint.safe(paragraph), width - 4)) {
                text += fmt::format("  {} {}\n", first ? paint(tone, notice.fault ? "!" : paint.symbol("·", "-")) : " ",
                                    paint(looks, line));
                first = false;
            }
        };
        text += "\n";
        add(notice.headline, tone);
        add(notice.cause, Tone::plain);
        add(notice.remedy, Tone::strong);
        add(who_in_words(notice), Tone::quiet);
    }
    return text;
}

}
