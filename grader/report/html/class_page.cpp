#include <algorithm>
#include <cmath>

#include "report/clusters.hpp"
#include "report/hidden.hpp"
#include "report/html/bars.hpp"
#include "report/html/class_statistics.hpp"
#include "report/html/document.hpp"
#include "report/html/sections.hpp"
#include "report/paint.hpp"
#include "report/reasons.hpp"

namespace umbral::grader::html {
namespace {

/// Relative links to a submission's files. Ids are letters, digits, '.', '_' and '-' (is_submission_id), so that no
/// name needs encoding; anything else gets no link.
std::string link_to(const std::string& id, const char* file)
{
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
               c == '-';
    };
    return !id.empty() && std::ranges::all_of(id, plain) ? fmt::format("{}/{}", id, file) : "#";
}

std::string title_of(const std::string& id, const ClassPageOptions& options)
{
    const auto found = options.titles.find(id);
    return found == options.titles.end() || found->second.empty() ? id : found->second;
}

double share_of(Millipoints score, Millipoints max_score)
{
    return max_score > 0 ? static_cast<double>(score) / static_cast<double>(max_score) : 0;
}

Markup unit_cell(const SubmissionResult& submission, const std::string& id)
{
    for (std::size_t i = 0; i < submission.units.size(); ++i) {
        const UnitResult& unit = submission.units[i];
        if (unit.id != id) continue;
        const Verdict verdict = shown_verdict(unit);
        const double share = share_of(unit.score, unit.max_score);
        // Five steps of one colour: more credit is more of it.
        const char* depth = verdict == Verdict::grader_fault ? "fault"
                            : share >= 1                     ? "c4"
                            : share >= 0.67                  ? "c3"
                            : share >= 0.34                  ? "c2"
                            : share > 0                      ? "c1"
                                                             : "c0";
        return markup(
            "<td class=\"credit {}\" data-sort=\"{}\"><a href=\"{}#u{}\">{}<span class=\"words\">{}</span></a></td>",
            depth, verdict == Verdict::grader_fault ? -1 : unit.score, link_to(submission.id, "report.html"), i + 1,
            verdict == Verdict::grader_fault ? "–" : points_text(unit.score), in_words(verdict));
    }
    return "<td class=\"credit\" data-sort=\"-2\">·</td>";
}

/// A column that the script makes sortable: it puts a button round the name.
Markup sortable(std::string_view name, std::string_view more = {})
{
    return markup("<th scope=\"col\" data-sort-by class=\"{}\">{}</th>", more, name);
}

Markup class_table(const ClassResult& result, const std::vector<UnitStatistics>& units, const ClassPageOptions& options)
{
    Markup head = sortable("Submission", "named");
    head += sortable("Total", "number");
    for (const UnitStatistics& unit : units) head += sortable(title_of(unit.id, options));
    head += "<th scope=\"col\">Data</th>";
    Markup body;
    for (const SubmissionResult& submission : result.submissions) {
        const Markup instructor = options.instructor_reports ? markup(" <a href=\"{}\">hidden too</a>",
                                                                      link_to(submission.id, "report.instructor.html"))
                                                             : Markup();
        body += markup(
            "<tr><th scope=\"row\" data-sort=\"{0}\"><a href=\"{1}\">{0}</a>{2}{6}</th><td class=\"number total\" "
            "data-sort=\"{3}\">{4}<span class=\"of\"> / "
            "{5}</span></td>",
            submission.id, link_to(submission.id, "report.html"), instructor, submission.score,
            points_text(submission.score), points_text(submission.max_score),
            submission.folder.empty() ? Markup() : markup(" <span class=\"id\">{}</span>", submission.folder));
        for (const UnitStatistics& unit : units) body += unit_cell(submission, unit.id);
        body += markup(
            "<td class=\"data\"><a href=\"{}\" download>JSON</a> <a href=\"{}\" download>student’s</a></td></tr>\n",
            link_to(submission.id, "report.json"), link_to(submission.id, "report.student.json"));
    }
    return scrolling(
        "Submissions",
        markup("<table class=\"class\" data-sortable><thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table>", head,
               body));
}

Markup distribution(const UnitStatistics& unit)
{
    const std::size_t most = std::max<std::size_t>(1, *std::max_element(unit.by_share.begin(), unit.by_share.end()));
    Markup bars;
    for (std::size_t i = 0; i < unit.by_share.size(); ++i) {
        const double height =
            unit.by_share[i] == 0
                ? 0
                : std::max(2.0, 26.0 * static_cast<double>(unit.by_share[i]) / static_cast<double>(most));
        bars += markup("<rect class=\"{}\" x=\"{}\" y=\"{:.1f}\" width=\"10\" height=\"{:.1f}\"/>",
                       i == 0    ? "none"
                       : i == 10 ? "all"
                                 : "some",
                       12 * i, 28 - height, height);
    }
    return markup(
        "<svg class=\"distribution\" viewBox=\"0 0 130 30\" width=\"130\" height=\"30\" role=\"img\" aria-label=\"{} "
        "with nothing, {} between, {} with "
        "everything\">{}<path d=\"M0 "
        "28.5H130\"/></svg>",
        unit.by_share.front(), unit.graded - unit.by_share.front() - unit.by_share.back(), unit.by_share.back(), bars);
}

Markup statistics(const std::vector<UnitStatistics>& units, const ClassPageOptions& options)
{
    Markup rows;
    for (const UnitStatistics& unit : units)
        rows += markup(
            "<tr><th scope=\"row\">{} <span class=\"id\">{}</span></th><td class=\"number\">{} of {}</td><td "
            "class=\"number\">{:.0f} %</td><td>{}</td></tr>\n",
            title_of(unit.id, options), unit.id, unit.right, unit.graded, 100 * unit.median, distribution(unit));
    return markup("<section aria-labelledby=\"by-unit\"><h2 id=\"by-unit\">Unit by unit</h2>\n{}</section>\n",
                  scrolling("Units", markup("<table class=\"statistics\"><thead><tr><th scope=\"col\">Unit</th><th "
                                            "scope=\"col\" class=\"number\">All right</th><th scope=\"col\" "
                                            "class=\"number\">Median credit</th><th scope=\"col\">From nothing to "
                                            "everything</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                                            rows)));
}

Markup whose(const std::vector<std::size_t>& places, const ClassResult& result)
{
    Markup who;
    for (const std::size_t s : places)
        who += markup("{}<a href=\"{}\">{}</a>", who.empty() ? "" : ", ",
                      link_to(result.submissions[s].id, "report.html"), result.submissions[s].id);
    return markup("<details class=\"whose\"><summary>{} {}</summary><p>{}</p></details>", places.size(),
                  places.size() == 1 ? "submission" : "submissions", who);
}

Markup cluster_item(const Cluster& cluster, std::size_t graded, const ClassResult& result)
{
    const bool several = cluster.sentences.size() > 1;
    const std::string sure = cluster.sentences.empty() ? ""
                                                       : fmt::format(" ({}{})", sure_words(cluster.confidence),
                                                                     several ? " one of these" : "");
    Markup why;
    for (std::size_t i = 0; i < cluster.sentences.size(); ++i)
        why += markup("<p>{}{}</p>", !several ? "" : i == 0 ? "Either: " : "Or: ", cluster.sentences[i]);
    return markup("<li><p class=\"count\">{} of {}</p><div><h4>{}<span class=\"sure\">{}</span></h4>{}{}</div></li>\n",
                  cluster.who.size(), graded, cluster.name, sure, why, whose(cluster.who, result));
}

/// What nobody could judge: of each unit who handed in nothing that could be read.
Markup missing_list(const std::vector<UnitClusters>& units, const ClassResult& result, const ClassPageOptions& options)
{
    Markup items;
    for (const UnitClusters& unit : units)
        if (!unit.missing.empty())
            items += markup(
                "<li><p class=\"count\">{} of {}</p><div><h4>{} <span class=\"id\">{}</span></h4>{}</div></li>\n",
                unit.missing.size(), unit.graded, title_of(unit.unit, options), unit.unit, whose(unit.missing, result));
    if (items.empty()) return {};
    return markup(
        "<h3 class=\"cause-of\">Not handed in</h3>\n<p class=\"note\">Or not readable: each report says what was found "
        "instead.</p>\n<ul "
        "class=\"clusters\">\n{}</ul>\n",
        items);
}

Markup cluster_list(const ClassResult& result, const ClassPageOptions& options)
{
    Markup sections;
    const std::vector<UnitClusters> units = clusters(result);
    for (const UnitClusters& unit : units) {
        if (unit.submissions() == 0) continue;
        Markup items;
        for (const auto* kind : {&unit.explained, &unit.ambiguous, &unit.unexplained})
            for (const Cluster& cluster : *kind) items += cluster_item(cluster, unit.graded, result);
        sections +=
            markup("<h3 class=\"cause-of\">{} <span class=\"id\">{}</span></h3>\n<ul class=\"clusters\">\n{}</ul>\n",
                   title_of(unit.unit, options), unit.unit, items);
    }
    sections += missing_list(units, result, options);
    if (sections.empty()) return {};
    return markup(
        "<section aria-labelledby=\"why\"><h2 id=\"why\">Why, and who</h2>\n<p class=\"note\">Failing work by what "
        "explains it best; below that what "
        "one of several reasons explains, then what none does.</p>\n{}</section>\n",
        sections);
}

}

std::string class_html(const ClassResult& result, const ClassPageOptions& options)
{
    const std::vector<UnitStatistics> units = unit_statistics(result);
    std::vector<double> shares;
    // Whose units all failed by our fault earned no zero.
    for (const SubmissionResult& submission : result.submissions)
        if (submission.max_score > 0) shares.push_back(share_of(submission.score, submission.max_score));
    std::sort(shares.begin(), shares.end());
    const double median = shares.empty() ? 0 : (shares[(shares.size() - 1) / 2] + shares[shares.size() / 2]) / 2;

    Document document;
    document.title = "Class – Umbral";
    document.bar = markup("<span class=\"brand\">Umbral</span><span class=\"who\">class</span>{}", theme_button());
    document.main = markup(
        "<section class=\"summary\" aria-labelledby=\"title\"><h1 id=\"title\">The class</h1>\n<p "
        "class=\"headline\">{} {}, {} {}; median credit {:.0f} %. <a "
        "href=\"class.json\" "
        "download>class.json</a></p>\n{}<p class=\"filter\" data-script hidden><label for=\"filter\">Show only</label> "
        "<input id=\"filter\" type=\"search\" "
        "placeholder=\"name or verdict\" autocomplete=\"off\"> <span id=\"shown\" aria-live=\"polite\"></span></p>\n",
        result.submissions.size(), result.submissions.size() == 1 ? "submission" : "submissions", units.size(),
        units.size() == 1 ? "unit" : "units", 100 * median, class_notices(result));
    document.main += class_table(result, units, options);
    document.main += "</section>\n";
    document.main += cluster_list(result, options);
    document.main += statistics(units, options);
    document.footer = fingerprint_footer(result.fingerprint);
    return document_html(document);
}

}
