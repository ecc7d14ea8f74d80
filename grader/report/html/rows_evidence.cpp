#include <algorithm>

#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

Markup entry(const std::string& text, bool differs)
{
    return differs ? markup("<mark><span class=\"sign\" aria-label=\"differs:\">≠</span>{}</mark>", text)
                   : escaped(text);
}

bool differs(const RowPair& row, std::size_t component)
{
    return component < row.differs.size() && row.differs[component];
}

/// Components as cells below common headings; a row without a value is one wide cell.
Markup cells(const RowPair& row, const std::vector<std::string>& texts, std::size_t columns, const char* side)
{
    if (texts.size() != columns)
        return markup("<td class=\"{}\" colspan=\"{}\">{}</td>", side, columns,
                      entry(texts.empty() ? "nothing" : texts.front(), true));
    Markup result;
    for (std::size_t i = 0; i < columns; ++i)
        result += markup("<td class=\"number {}\">{}</td>", side, entry(texts[i], differs(row, i)));
    return result;
}

/// Beyond it a question hides the table that it stands in.
constexpr std::size_t short_question = 320;

bool is_long(const RowPair& row) { return row.question.size() > short_question; }

/// What this row was asked, as `code` shows it. Of the long ones only the first is shown at once: the others unfold.
Markup unfolding(const std::vector<RowPair>& rows, const RowPair& row, const Markup& code)
{
    if (!is_long(row) || &row == &*std::ranges::find_if(rows, is_long)) return code;
    return markup("<details><summary>what was asked</summary>{}</details>", code);
}

Markup table_of(const std::vector<RowPair>& rows, const RowsEvidence& evidence, std::string_view caption)
{
    if (rows.empty()) return {};
    std::size_t columns = 1;
    for (const RowPair& row : rows) columns = std::max({columns, row.yours.size(), row.expected.size()});
    Markup names;
    if (evidence.headings.size() == columns) {
        names = "<tr><td></td>";
        for (int side = 0; side < 2; ++side)
            for (const std::string& heading : evidence.headings)
                names += markup("<th scope=\"col\" class=\"number\">{}</th>", heading);
        names += "<td></td></tr>";
    }
    Markup body;
    for (const RowPair& row : rows) {
        body += markup("<tr><th scope=\"row\">{}</th>{}{}<td class=\"note\">{}</td></tr>\n", row.name,
                       cells(row, row.yours, columns, "of-yours"), cells(row, row.expected, columns, "of-reference"),
                       row.note);
        if (!row.question.empty())
            body += markup("<tr class=\"question\"><td></td><td colspan=\"{}\">{}</td></tr>\n", 2 * columns + 1,
                           unfolding(rows, row, markup("<code>{}</code>", row.question)));
    }
    return scrolling(caption, markup("<table class=\"rows\"><caption>{0}</caption><thead><tr><th scope=\"col\"><span "
                                     "class=\"aside\">row</span></th><th "
                                     "scope=\"colgroup\" class=\"number of-yours\" "
                                     "colspan=\"{1}\">yours</th><th scope=\"colgroup\" class=\"number of-reference\" "
                                     "colspan=\"{1}\">expected</th><th "
                                     "scope=\"col\">off by</th></tr>{2}</thead>\n<tbody>\n{3}</tbody></table>",
                                     caption, columns, names, body));
}

/// Stored column by column, drawn row by row.
Markup matrix(const RowPair& row, const std::vector<std::string>& texts, int side, const char* kind,
              const char* caption)
{
    const auto count = static_cast<std::size_t>(side);
    Markup body;
    if (texts.size() != count * count)
        return markup("<div class=\"{}\"><p>{}</p><p>{}</p></div>", kind, caption,
                      texts.empty() ? "nothing" : texts.front());
    for (std::size_t i = 0; i < count; ++i) {
        body += "<tr>";
        for (std::size_t j = 0; j < count; ++j)
            body += markup("<td class=\"number\">{}</td>", entry(texts[j * count + i], differs(row, j * count + i)));
        body += "</tr>";
    }
    return markup("<table class=\"matrix {}\"><caption>{}</caption><tbody>{}</tbody></table>", kind, caption, body);
}

Markup question(const std::vector<RowPair>& rows, const RowPair& row)
{
    if (row.question.empty()) return {};
    return unfolding(rows, row, markup("<pre class=\"question\"><code>{}</code></pre>", row.question));
}

Markup matrices_of(const std::vector<RowPair>& rows, int side, std::string_view caption)
{
    if (rows.empty()) return {};
    Markup result = markup("<h4>{}</h4>\n", caption);
    for (const RowPair& row : rows)
        result += scrolling(
            row.name,
            markup("<div class=\"matrices\"><p class=\"name\">{}<span class=\"note\">{}</span></p>{}{}{}</div>",
                   row.name, row.note, question(rows, row), matrix(row, row.yours, side, "of-yours", "yours"),
                   matrix(row, row.expected, side, "of-reference", "expected")));
    return result;
}

}

Markup rows_evidence(const RowsEvidence& evidence)
{
    const char* const first = evidence.side == 0 ? "The first wrong rows" : "The first that is wrong";
    const char* const worst = evidence.side == 0 ? "The worst of the other rows" : "The worst of the others";
    if (evidence.side != 0) {
        Markup result = matrices_of(evidence.first, evidence.side, first);
        result += matrices_of(evidence.worst, evidence.side, worst);
        return result;
    }
    const bool all = evidence.worst.empty() && evidence.first.size() == evidence.wrong;
    Markup result = markup("<div class=\"tables\">{}{}</div>\n",
                           table_of(evidence.first, evidence, all ? "Every wrong row" : first),
                           table_of(evidence.worst, evidence, worst));
    if (evidence.equal_columns > 0)
        result += markup("<p class=\"note\">{} more numbers of each row are equal in all of these.</p>\n",
                         evidence.equal_columns);
    return result;
}

}
