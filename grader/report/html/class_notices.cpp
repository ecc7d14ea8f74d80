#include "report/html/sections.hpp"
#include "report/notices.hpp"

namespace umbral::grader::html {

Markup class_notices(const ClassResult& result)
{
    Markup items;
    for (const Notice& notice : notices(result)) {
        items += markup("<li class=\"{}\"><h2>{}</h2>\n", notice.fault ? "fault" : "note", notice.headline);
        if (!notice.cause.empty()) items += markup("<p class=\"cause\">{}</p>\n", notice.cause);
        items += markup("<p class=\"remedy\">{}</p>\n", notice.remedy);
        if (!notice.who.empty()) items += markup("<p class=\"concerned\">{}</p>\n", who_in_words(notice));
        items += "</li>\n";
    }
    return items.empty() ? Markup() : markup("<ul class=\"notices\" role=\"alert\">\n{}</ul>\n", items);
}

}
