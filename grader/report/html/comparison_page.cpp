#include "report/html/document.hpp"
#include "report/html/sections.hpp"

namespace umbral::grader::html {

std::string comparison_html(const Comparison& comparison)
{
    Document document;
    document.title = comparison.yours + " and " + comparison.reference + " – Umbral";
    document.bar = markup("<span class=\"brand\">Umbral</span><span class=\"who\">compare</span>{}", theme_button());
    document.main = markup(
        "<section class=\"summary compare\" aria-labelledby=\"title\"><h1 id=\"title\">{}</h1>\n<dl "
        "class=\"files\"><div "
        "class=\"of-yours\"><dt>yours</dt><dd>{}</dd></div><div "
        "class=\"of-reference\"><dt>reference</dt><dd>{}</dd></div></dl>\n</section>\n",
        comparison.agree ? "The pictures agree" : "The pictures do not agree", comparison.yours, comparison.reference);
    document.main += "<section class=\"unit\" aria-label=\"Comparison\">\n<h2 class=\"aside\">Comparison</h2>\n";
    document.main += why_section(comparison.reasons);
    document.main += check_article(comparison.check, comparison.detail, "c1", false);
    document.main += "</section>\n";
    document.footer =
        markup("<dl class=\"fingerprint\"><div><dt>Umbral</dt><dd>{}</dd></div></dl>\n", comparison.version);
    return document_html(document);
}

}
