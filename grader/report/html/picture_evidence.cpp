#include <algorithm>

#include "judge/picture/colour_map.hpp"
#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

constexpr int least_width = 512;  // smaller pictures are shown enlarged by a whole factor
constexpr int magnified_width = 320;

int enlargement(const Image& picture, int least)
{
    return std::max(1, least / std::max({picture.width, picture.height, 1}));
}

Markup image(const Image& picture, std::string_view alt, int scale)
{
    return markup("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"{}>", data_url(encode(picture)),
                  scale * picture.width, scale * picture.height, alt,
                  scale > 1 ? Markup(" class=\"enlarged\"") : Markup());
}

/// Where the magnified part lies: a light line within a dark one, visible on any picture.
Markup mark(const Image& picture, const std::optional<Magnified>& worst)
{
    if (!worst) return {};
    return markup(
        "<svg class=\"mark\" viewBox=\"0 0 {} {}\" aria-hidden=\"true\"><rect class=\"outer\" x=\"{}\" y=\"{}\" "
        "width=\"{}\" height=\"{}\"/><rect "
        "class=\"inner\" "
        "x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></svg>",
        picture.width, picture.height, worst->x, worst->y, worst->yours.width, worst->yours.height, worst->x, worst->y,
        worst->yours.width, worst->yours.height);
}

Markup legend(const PictureEvidence& evidence)
{
    if (!evidence.graded)
        return "<p class=\"legend\"><svg viewBox=\"0 0 10 10\" width=\"10\" height=\"10\" aria-hidden=\"true\"><rect "
               "width=\"10\" height=\"10\" "
               "class=\"differs\"/></svg> differs</p>";
    Markup stops;
    constexpr int count = 8;
    for (int i = 0; i <= count; ++i) {
        const glm::u8vec4 colour = magma(static_cast<double>(i) / count);
        stops +=
            markup("<rect x=\"{}\" width=\"11\" height=\"8\" fill=\"#{:02x}{:02x}{:02x}\"/>", 11 * i,
                   static_cast<unsigned>(colour.r), static_cast<unsigned>(colour.g), static_cast<unsigned>(colour.b));
    }
    return markup(
        "<p class=\"legend\">0 <svg viewBox=\"0 0 99 8\" width=\"99\" height=\"8\" aria-hidden=\"true\">{}</svg> {} of "
        "255 levels</p>",
        stops, evidence.largest);
}

Markup figure(std::string_view kind, std::string_view caption, const Image& picture, std::string_view alt,
              const Markup& over, const Markup& below = {})
{
    return markup("<figure class=\"{}\"><figcaption>{}</figcaption><div class=\"frame\">{}{}</div>{}</figure>\n", kind,
                  caption, image(picture, alt, enlargement(picture, least_width)), over, below);
}

std::string size_text(const Image& picture) { return fmt::format("{} × {} pixels", picture.width, picture.height); }

std::string equal_words(const PictureEvidence& evidence)
{
    const bool reference = evidence.expected_side == "reference";
    return fmt::format("yours and {}{}: equal in every pixel", reference ? "the " : "", evidence.expected_side);
}

Markup pixel_table(const PictureEvidence& evidence)
{
    if (evidence.pixels.empty()) return {};
    Markup rows;
    for (const PixelPair& pixel : evidence.pixels) {
        const Markup level = evidence.graded ? markup("<td class=\"number\">{}</td>", pixel.level) : Markup();
        rows += markup("<tr><th scope=\"row\">({}, {})</th><td>{}</td><td>{}</td>{}</tr>\n", pixel.x, pixel.y,
                       pixel.yours, pixel.reference, level);
    }
    return markup(
        "<details data-close open><summary>The {} that differ most here, as a table</summary>{}</details>\n",
        evidence.pixels.size() == 1 ? "pixel" : fmt::format("{} pixels", evidence.pixels.size()),
        scrolling(
            "Pixels that differ most",
            markup(
                "<table class=\"pixels\"><thead><tr><th scope=\"col\">pixel (x, y)</th><th scope=\"col\">yours</th><th "
                "scope=\"col\">{}</th>{}</tr></thead>"
                "<tbody>\n{}</tbody></table>",
                evidence.expected_side,
                evidence.graded ? Markup("<th scope=\"col\" class=\"number\">difference, of 255</th>") : Markup(),
                rows)));
}

/// "0 3 3 1 …": numbers that the script reads from an attribute.
template <class Numbers>
std::string listed(const Numbers& numbers)
{
    std::string text;
    for (const auto number : numbers)
        text += fmt::format("{}{}", text.empty() ? "" : " ", static_cast<unsigned>(number));
    return text;
}

Markup magnified(const PictureEvidence& evidence, const Markup& anchor)
{
    if (!evidence.worst) return {};
    const Magnified& worst = *evidence.worst;
    std::string texts;
    for (const std::string& text : worst.texts) texts += (texts.empty() ? "" : "|") + text;
    const int scale = enlargement(worst.yours, magnified_width);
    const auto panel = [&](const char* kind, std::string_view caption, const Image& picture) {
        return markup("<figure class=\"{}\"><figcaption>{}</figcaption><div class=\"frame\">{}</div></figure>\n", kind,
                      caption,
                      image(picture,
                            fmt::format("{}, magnified: pixels ({}, {}) to ({}, {})", caption, worst.x, worst.y,
                                        worst.x + worst.yours.width - 1, worst.y + worst.yours.height - 1),
                            scale));
    };
    Markup result = markup(
        "<div class=\"magnified\" data-magnified data-x=\"{}\" data-y=\"{}\" data-columns=\"{}\" data-rows=\"{}\" "
        "data-texts=\"{}\" data-yours=\"{}\" "
        "data-reference=\"{}\" data-levels=\"{}\" data-graded=\"{}\" data-other=\"{}\">\n<h4 id=\"{}-worst\">Where it "
        "is worst, {} times as large</h4>\n<div "
        "class=\"panels\">\n",
        worst.x, worst.y, worst.yours.width, worst.yours.height, texts, listed(worst.yours_texts),
        listed(worst.reference_texts), listed(worst.levels), evidence.graded ? 1 : 0, evidence.expected_side, anchor,
        scale);
    result += panel("yours", "yours", worst.yours);
    result += panel("reference", evidence.expected_side, worst.reference);
    result += panel("difference", "difference", worst.difference);
    result +=
        "</div>\n<p class=\"readout\" data-readout data-script hidden>Point at a pixel, or move with the arrow "
        "keys.</p>\n";
    result += pixel_table(evidence);
    result += "</div>\n";
    return result;
}

Markup controls(const Markup& anchor)
{
    return markup(
        "<div class=\"controls\" role=\"group\" aria-label=\"How to compare\" data-script hidden><button "
        "type=\"button\" data-view=\"wipe\" "
        "aria-pressed=\"true\">Wipe</button>"
        "<button type=\"button\" data-view=\"blink\" aria-pressed=\"false\" title=\"Blink (b)\">Blink</button>"
        "<button type=\"button\" data-view=\"beside\" aria-pressed=\"false\">Side by side</button>"
        "<span class=\"status\" id=\"{}-status\" aria-live=\"polite\"></span></div>\n",
        anchor);
}

}

Markup picture_evidence(const PictureEvidence& evidence, const Markup& anchor)
{
    if (!evidence.problem.empty() || !evidence.reference) {
        Markup result = evidence.problem.empty() ? Markup() : markup("<p class=\"message\">{}</p>\n", evidence.problem);
        result += "<div class=\"pictures\">\n";
        if (!evidence.yours.cells.empty())
            result += figure(
                "yours",
                evidence.problem.empty() ? equal_words(evidence) : fmt::format("yours, {}", size_text(evidence.yours)),
                evidence.yours, fmt::format("Picture: yours, {}", size_text(evidence.yours)), {});
        if (evidence.reference && !evidence.reference->cells.empty())
            result +=
                figure("reference", fmt::format("{}, {}", evidence.expected_side, size_text(*evidence.reference)),
                       *evidence.reference,
                       fmt::format("Picture: {}, {}", evidence.expected_side, size_text(*evidence.reference)), {});
        result += "</div>\n";
        return result;
    }
    Markup result =
        markup("<div class=\"comparison\" data-comparison>\n{}<div class=\"pictures\">\n", controls(anchor));
    const Markup frame = mark(evidence.yours, evidence.worst);
    result +=
        figure("yours", "yours", evidence.yours, fmt::format("Picture: yours, {}", size_text(evidence.yours)), frame);
    result += figure("reference", evidence.expected_side, *evidence.reference,
                     fmt::format("Picture: {}, {}", evidence.expected_side, size_text(evidence.yours)), frame);
    if (evidence.difference)
        result += figure(
            "difference",
            fmt::format("difference: {} {}", evidence.differing, evidence.differing == 1 ? "pixel" : "pixels"),
            *evidence.difference, fmt::format("Picture: difference of the two; {} pixels differ", evidence.differing),
            frame, legend(evidence));
    result += "</div>\n</div>\n";
    result += magnified(evidence, anchor);
    return result;
}

}
