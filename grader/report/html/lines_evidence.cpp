#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

struct Kind {
    const char* name;
    const char* sign;
    const char* words;
};

Kind kind_of(LineKind kind)
{
    switch (kind) {
        case LineKind::changed: return {"changed", "≠", "differs"};
        case LineKind::missing: return {"missing", "−", "missing in yours"};
        case LineKind::extra: return {"extra", "+", "only in yours"};
        default: return {"same", "", ""};
    }
}

Markup side(const char* kind, std::optional<std::size_t> number, const std::string& text)
{
    if (!number) return markup("<td class=\"line\"></td><td class=\"{} none\"></td>", kind);
    return markup("<td class=\"line\">{}</td><td class=\"{}\"><code>{}</code></td>", *number, kind, text);
}

Markup row(const LinePair& line)
{
    if (line.kind == LineKind::omitted)
        return markup("<tr class=\"omitted\"><td colspan=\"5\">{} equal {}</td></tr>\n", line.omitted,
                      line.omitted == 1 ? "line" : "lines");
    const Kind kind = kind_of(line.kind);
    const Markup sign = *kind.sign == '\0' ? Markup()
                                           : markup("<span role=\"img\" aria-label=\"{}\" title=\"{}\">{}</span>",
                                                    kind.words, kind.words, kind.sign);
    return markup("<tr class=\"{}\"><td class=\"sign\">{}</td>{}{}</tr>\n", kind.name, sign,
                  side("of-yours", line.yours_number, line.yours),
                  side("of-reference", line.expected_number, line.expected));
}

}

Markup lines_evidence(const LinesEvidence& evidence)
{
    if (evidence.lines.empty()) return {};
    Markup body;
    for (const LinePair& line : evidence.lines) body += row(line);
    Markup result = markup(
        "<p class=\"counts\"><span><b>−</b> {} missing</span> <span><b>+</b> {} too many</span> <span><b>≠</b> {} "
        "different</span></p>\n",
        evidence.missing, evidence.extra, evidence.changed);
    result +=
        scrolling(evidence.what, markup("<table class=\"lines\"><caption>{} in their order</caption><thead><tr><th "
                                        "scope=\"col\"><span class=\"aside\">difference</span></th><th "
                                        "scope=\"col\" class=\"of-yours\" colspan=\"2\">yours</th><th scope=\"col\" "
                                        "class=\"of-reference\" colspan=\"2\">expected</th></tr></thead>\n"
                                        "<tbody>\n{}</tbody></table>",
                                        evidence.what, body));
    if (evidence.cut) result += "<p class=\"note\">There are more; these are the first.</p>\n";
    return result;
}

}
