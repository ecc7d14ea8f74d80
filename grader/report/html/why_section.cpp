#include "report/html/sections.hpp"
#include "report/reasons.hpp"

namespace umbral::grader::html {

Markup why_section(std::span<const Explanation> explanations)
{
    const auto reasons = main_reasons(explanations);
    if (reasons.empty()) return {};
    const char* sure = sure_words(reasons.front().confidence);
    Markup result = "<div class=\"why\"><h3>Why</h3>\n";
    if (reasons.size() == 1) {
        result += markup("<p class=\"hint\">{}</p>\n<p class=\"sure\">That is {} the reason.</p>\n",
                         reasons.front().sentence, sure);
    } else {
        for (std::size_t i = 0; i < reasons.size(); ++i)
            result += markup("<p class=\"hint\"><span class=\"sure\">{}</span> {}</p>\n",
                             i == 0 ? "Either:" : "Or:", reasons[i].sentence);
        result += markup("<p class=\"sure\">It is {} one of these: they give the same results here.</p>\n", sure);
    }
    const auto others = other_reasons(explanations);
    if (!others.empty()) {
        result += "<p class=\"sure\">It may also be:</p>\n<ul>\n";
        for (const Explanation& other : others)
            result +=
                markup("<li>{} <span class=\"sure\">({})</span></li>\n", other.sentence, sure_words(other.confidence));
        result += "</ul>\n";
    }
    result += "</div>\n";
    return result;
}

}
