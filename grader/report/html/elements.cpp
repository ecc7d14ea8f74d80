#include "report/html/sections.hpp"

namespace umbral::grader::html {

Markup scrolling(std::string_view label, const Markup& table)
{
    return markup("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">{}</div>\n", label, table);
}

const char* kind_of(Verdict verdict)
{
    switch (verdict) {
        case Verdict::ok: return "ok";
        case Verdict::partial: return "partial";
        case Verdict::missing:
        case Verdict::not_implemented: return "none";
        case Verdict::grader_fault: return "fault";
        default: return "bad";
    }
}

Markup verdict_chip(Verdict verdict)
{
    const auto sign = [&]() -> Markup {
        switch (verdict) {
            case Verdict::ok: return "<path d=\"M4.6 8.4 7 10.8l4.6-5.2\"/>";
            case Verdict::partial: return "<path class=\"filled\" d=\"M8 1.7a6.3 6.3 0 0 1 0 12.6z\"/>";
            case Verdict::missing:
            case Verdict::not_implemented: return "";
            case Verdict::grader_fault: return "<path d=\"M8 4.4v4.4M8 11v.6\"/>";
            default: return "<path d=\"m5.4 5.4 5.2 5.2m0-5.2-5.2 5.2\"/>";
        }
    };
    return markup(
        "<span class=\"chip {}\"><svg viewBox=\"0 0 16 16\" width=\"16\" height=\"16\" aria-hidden=\"true\"><circle "
        "cx=\"8\" cy=\"8\" "
        "r=\"6.3\"/>{}</svg>{}</span>",
        kind_of(verdict), sign(), in_words(verdict));
}

Markup fingerprint_footer(const Fingerprint& fingerprint)
{
    Markup list;
    const auto add = [&](const char* name, std::string_view value) {
        if (!value.empty()) list += markup("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
    };
    add("Umbral", fingerprint.version + (fingerprint.commit.empty() ? "" : " (" + fingerprint.commit + ")"));
    add("processor", fingerprint.cpu);
    add("compiler", fingerprint.compiler);
    add("OpenGL", fingerprint.gl);
    add("mathematics", fingerprint.libm);
    std::string protections;
    for (const std::string& one : fingerprint.protections) protections += (protections.empty() ? "" : ", ") + one;
    add("sandbox", protections);
    return list.empty() ? Markup() : markup("<dl class=\"fingerprint\">{}</dl>\n", list);
}

}
