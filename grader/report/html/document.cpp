#include "report/html/document.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "report/html/base64.hpp"
#include "report/html/resources.hpp"

namespace umbral::grader::html {
namespace {

using Part = std::pair<std::string_view, std::string_view>;

/// `form` with each {{name}} replaced, in one pass: what goes in is never searched again.
template <std::size_t Count>
std::string fill(std::string_view form, const std::array<Part, Count>& parts)
{
    std::string result;
    for (std::size_t open = form.find("{{"); open != std::string_view::npos; open = form.find("{{")) {
        const std::size_t close = form.find("}}", open);
        const std::string_view name = form.substr(open + 2, close - open - 2);
        result += form.substr(0, open);
        bool known = false;
        for (const auto& [key, text] : parts)
            if (key == name) result += text, known = true;
        if (!known) throw std::logic_error("page.html: nothing is called '" + std::string(name) + "'");
        form.remove_prefix(close + 2);
    }
    return result.append(form);
}

}

std::string document_html(const Document& document)
{
    // The same in every report of a run: worked out once.
    static const std::string style_hash = source_hash(resources::style);
    static const std::string script_hash = source_hash(resources::script);
    const Markup title = escaped(document.title);
    return fill(resources::page, std::array<Part, 8>{{{"style-hash", style_hash},
                                                      {"script-hash", script_hash},
                                                      {"title", title.view()},
                                                      {"style", resources::style},
                                                      {"bar", document.bar.view()},
                                                      {"main", document.main.view()},
                                                      {"footer", document.footer.view()},
                                                      {"script", resources::script}}});
}

Markup theme_button()
{
    return "<button type=\"button\" class=\"quiet\" id=\"theme\" data-script hidden aria-label=\"Change between light "
           "and dark\" title=\"Light or dark (t)\">"
           "<svg viewBox=\"0 0 16 16\" width=\"16\" height=\"16\" aria-hidden=\"true\"><circle cx=\"8\" cy=\"8\" "
           "r=\"6.2\" fill=\"none\" "
           "stroke=\"currentColor\" stroke-width=\"1.5\"/><path d=\"M8 1.8a6.2 6.2 0 0 1 0 12.4z\" "
           "fill=\"currentColor\"/></svg></button>\n";
}

Markup step_buttons()
{
    return "<nav class=\"steps\" aria-label=\"Checks\" data-script hidden>"
           "<button type=\"button\" class=\"quiet\" id=\"previous\" aria-label=\"Previous check\" title=\"Previous "
           "check (k)\">"
           "<svg viewBox=\"0 0 16 16\" width=\"16\" height=\"16\" aria-hidden=\"true\"><path d=\"M3.5 10.5 8 6l4.5 "
           "4.5\" fill=\"none\" "
           "stroke=\"currentColor\" stroke-width=\"1.6\" stroke-linecap=\"round\" "
           "stroke-linejoin=\"round\"/></svg></button>"
           "<span id=\"position\" aria-live=\"polite\"></span>"
           "<button type=\"button\" class=\"quiet\" id=\"next\" aria-label=\"Next check\" title=\"Next check (j)\">"
           "<svg viewBox=\"0 0 16 16\" width=\"16\" height=\"16\" aria-hidden=\"true\"><path d=\"M3.5 5.5 8 "
           "10l4.5-4.5\" fill=\"none\" "
           "stroke=\"currentColor\" stroke-width=\"1.6\" stroke-linecap=\"round\" "
           "stroke-linejoin=\"round\"/></svg></button></nav>\n";
}

}
