#include <algorithm>

#include "report/html/document.hpp"
#include "report/html/pages.hpp"
#include "report/html/sections.hpp"
#include "report/paint.hpp"

namespace umbral::grader::html {
namespace {

Markup card(const CatalogueEntry& entry)
{
    const Markup goal =
        entry.goal.png.empty()
            ? Markup("<div class=\"no-goal\"></div>")
            : markup("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"What the reference draws for: {}\">",
                     data_url(entry.goal), entry.goal.width, entry.goal.height, entry.title);
    return markup(
        "<article class=\"card\">{}<h3>{}</h3>\n<p class=\"id\">{}</p>\n<p class=\"note\">{} points · {}</p>\n<p "
        "class=\"note course\">{}</p></article>\n",
        goal, entry.title, entry.id, points_text(entry.points), entry.checked,
        fmt::format("{}", fmt::join(entry.course, ", ")));
}

Markup topic_section(std::span<const CatalogueEntry> entries)
{
    Markup cards;
    for (const CatalogueEntry& entry : entries) cards += card(entry);
    const std::string& topic = entries.front().topic;
    return markup(
        "<section class=\"topic\" aria-labelledby=\"{0}\"><h2 id=\"{0}\">{0}</h2>\n<div "
        "class=\"cards\">\n{1}</div></section>\n",
        topic, cards);
}

}

std::string catalogue_html(std::span<const CatalogueEntry> entries, const std::string& language,
                           const std::string& version)
{
    Document document;
    document.title = "Units – Umbral";
    document.bar = markup("<span class=\"brand\">Umbral</span><span class=\"who\">{} units</span>{}", entries.size(),
                          theme_button());
    document.main = markup(
        "<section class=\"summary\" aria-labelledby=\"title\" lang=\"{}\"><h1 id=\"title\">{} units</h1></section>\n",
        language, entries.size());
    for (auto first = entries.begin(); first != entries.end();) {
        const auto last = std::find_if(first, entries.end(),
                                       [&](const CatalogueEntry& entry) { return entry.topic != first->topic; });
        document.main += topic_section({first, last});
        first = last;
    }
    document.footer = markup("<dl class=\"fingerprint\"><div><dt>Umbral</dt><dd>{}</dd></div></dl>\n", version);
    return document_html(document);
}

}
