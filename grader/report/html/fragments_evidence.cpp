#include <algorithm>

#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

struct Count {
    const char* kind;
    const char* words;
    std::size_t count;
};

/// Signs as in the sketch, and colours as in the picture, each with its words.
Markup legend(const FragmentsEvidence& evidence)
{
    Markup items;
    for (const Count& item :
         {Count{"right", "right", evidence.right}, Count{"missing", "missing", evidence.missing},
          Count{"extra", "too many", evidence.extra}, Count{"changed", "another value", evidence.changed}})
        items += markup(
            "<li class=\"{}\"><svg viewBox=\"0 0 10 10\" width=\"12\" height=\"12\" aria-hidden=\"true\"><rect "
            "width=\"10\" height=\"10\"/></svg>{} {}</li>",
            item.kind, item.count, item.words);
    return markup("<ul class=\"legend\">{}</ul>", items);
}

}

Markup fragments_evidence(const FragmentsEvidence& evidence)
{
    Markup result = "<div class=\"fragments\">\n<div class=\"drawn\">\n";
    if (evidence.picture) {
        const Image& picture = *evidence.picture;
        const int scale = std::clamp(360 / std::max({picture.width, picture.height, 1}), 1, 24);
        result += markup(
            "<figure><figcaption>pixels from ({}, {})</figcaption><div class=\"frame\"><img class=\"enlarged\" "
            "src=\"{}\" width=\"{}\" height=\"{}\" "
            "alt=\"Fragments: {} right, {} "
            "missing, {} too many, {} of another value\"></div>{}</figure>\n",
            evidence.x, evidence.y, data_url(encode(picture)), scale * picture.width, scale * picture.height,
            evidence.right, evidence.missing, evidence.extra, evidence.changed, legend(evidence));
    }
    if (!evidence.sketch.empty())
        result += markup("<pre class=\"sketch\" tabindex=\"0\" aria-label=\"The same in characters\">{}</pre>\n",
                         evidence.sketch);
    result += "</div>\n";
    result += rows_evidence(evidence.rows);
    result += "</div>\n";
    return result;
}

}
