#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <umbral/core/random.hpp>
#include <vector>

#include "collect/sources.hpp"
#include "judge/cost/cost.hpp"
#include "judge/judge.hpp"
#include "judge/make.hpp"
#include "judge/trace/trace_counts.hpp"
#include "report/html/pages.hpp"
#include "unit/evidence.hpp"
#include "worker/case_results.hpp"

// Writes pages with evidence of every kind and the worst of texts into a folder, for the browser to try. The evidence
// is made from recordings, by the same functions as when a class is graded.
namespace {

using namespace umbral;
using namespace umbral::grader;

using test::floats;
using test::table;
using test::text;

/// A shaded ball before a chequered ground; `mistake` lights it from the other side and moves it.
Tensor picture(int width, int height, bool mistake)
{
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = (x - width * (mistake ? 0.52 : 0.5)) / (0.35 * height);
            const double v = (y - height * 0.5) / (0.35 * height);
            const double square = u * u + v * v;
            const double light =
                square < 1 ? std::max(0.1, (mistake ? 0.6 : -0.6) * u - 0.5 * v + 0.6 * std::sqrt(1 - square)) : 0;
            const bool dark = (x / 24 + y / 24) % 2 == 0;
            const double ground = dark ? 0.25 : 0.45;
            for (const double tint : {1.0, 0.8, 0.55})
                bytes.push_back(static_cast<std::uint8_t>(255 * std::min(1.0, square < 1 ? light * tint : ground)));
            bytes.push_back(255);
        }
    return {Element::uint8,
            static_cast<std::uint32_t>(height),
            static_cast<std::uint32_t>(width),
            4,
            [&] {
                std::vector<std::byte> copy(bytes.size());
                std::memcpy(copy.data(), bytes.data(), bytes.size());
                return copy;
            }(),
            {}};
}

Tensor ids(int side, int shift)
{
    std::vector<std::uint32_t> cells;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            cells.push_back(std::hypot(x - side / 2 - shift, y - side / 2) < side / 3.0 ? 7U : y > side / 2 ? 3U : 0U);
    Tensor tensor = table(Element::uint32, 1, cells);
    tensor.rows = tensor.columns = static_cast<std::uint32_t>(side);
    return tensor;
}

/// Fragments of a right-angled triangle with one colour component; `mistake` forgets the diagonal and gets one corner's
/// colour wrong.
Tensor fragments(bool mistake)
{
    std::vector<float> rows;
    for (int y = 0; y < 14; ++y)
        for (int x = 0; x < 14 - y - (mistake ? 1 : 0); ++x)
            rows.insert(rows.end(), {0, float(x + 4), float(y + 2), mistake && x + y < 3 ? 0.5F : 0.0625F * float(x)});
    if (mistake) rows.insert(rows.end(), {0, 20, 3, 1, 0, 4, 2, 0.5F});
    return floats(rows, 4);
}

/// A frame's calls; `mistake` uploads every frame, and draws the old way.
std::string calls(bool mistake)
{
    std::string lines = "glClearColor 0 0 0 1\nglClear 16384\nglGenBuffers 1 1\nglBindBuffer 34962 1\n";
    for (int i = 0; i < 40; ++i) {
        if (mistake && i == 12) lines += "glBufferData 34962 4096 1 35044 | 4096\n";
        if (mistake && i == 30) continue;
        lines += "glUniform1i " + std::to_string(i) + " " + std::to_string(mistake && i == 20 ? 99 : 2 * i) + "\n";
    }
    return lines + (mistake ? "glBegin 4\nglVertex3f 0 0 0\nglEnd\n" : "glDrawArrays 4 0 3\n");
}

struct Scene {
    UnitResult unit;
    html::UnitDetail detail;
};

void add(Scene& scene, Check check, const Tensor& yours, const Tensor& expected, const Tensor* names = nullptr)
{
    check.points = 1000;
    const Judgement judgement = judge(check, yours, expected, nullptr, names);
    CheckResult result = blank_result(check);
    result.score = points_for(check, judgement.right, 0);
    result.error = judgement.error;
    if (check.hard) result.reference_error = 0.5;
    result.message = judgement.message;
    result.metrics = judgement.metrics;
    result.first_difference = judgement.first_difference;
    result.sketch = judgement.sketch;
    html::CheckDetail detail = describe(check);
    detail.evidence =
        evidence_of(check, {&yours, &expected, nullptr, names, result.sketch}, result.score == check.points);
    scene.detail.checks[check.name] = std::move(detail);
    scene.unit.score += result.score;
    scene.unit.max_score += result.max_score;
    scene.unit.checks.push_back(std::move(result));
}

Check check(const std::string& name, JudgeKind kind)
{
    Check made;
    made.name = name;
    made.judge = kind;
    made.why = "counted roundings: one root, one addition and one division";
    if (kind == JudgeKind{"numbers"} || kind == JudgeKind{"matrices"}) made.tolerance.ulps = 4;
    return made;
}

Scene everything()
{
    Scene scene;
    scene.unit.id = "made-up/every-kind";
    scene.detail.title = "Evidence of every kind";
    scene.unit.verdict = Verdict::partial;
    scene.unit.explanations = {
        {"mistake: other_side",
         "The light comes from the other side: the vector to the light is its place minus the point.", 0.8},
        {"shifted", "Everything is shifted by seven pixels to the right.", 0.2}};
    scene.unit.output = "light (0.3, 0.5, 0.8)\nlooks fine to me\n";
    scene.unit.message = "picture/small: took too long: 5.0 s, the limit is 5 s\n";
    scene.unit.seconds = 1.234;
    scene.unit.reference_seconds = 0.021;
    add(scene, check("picture/colours", JudgeKind{"image"}), picture(320, 240, true), picture(320, 240, false));
    add(scene, check("picture/small", JudgeKind{"image"}), picture(20, 12, true), picture(20, 12, false));
    add(scene, check("picture/wide", JudgeKind{"image"}), picture(900, 90, true), picture(900, 90, false));
    add(scene, check("picture/ids", JudgeKind{"buffer"}), ids(64, 3), ids(64, 0));
    add(scene, check("picture/other size", JudgeKind{"image"}), picture(60, 40, true), picture(64, 48, false));
    Check hard = check("numbers/far away", JudgeKind{"numbers"});
    hard.hard = true;
    std::vector<float> right;
    std::vector<float> wrong;
    Random random(1);
    for (int i = 0; i < 90; ++i) {
        right.push_back(random.uniform(-9, 9));
        wrong.push_back(i % 3 == 0 ? right.back() * 1.25F : i == 40 ? NAN : right.back());
    }
    add(scene, hard, floats(wrong, 3), floats(right, 3));
    add(scene, check("numbers/almost", JudgeKind{"numbers"}), floats({1.0000001F, 2.00001F, 3}), floats({1, 2, 3}));
    std::vector<float> matrix(32);
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = random.uniform(-2, 2);
    std::vector<float> transposed = matrix;
    for (std::size_t i = 0; i < 32; ++i) transposed[i] = matrix[i / 16 * 16 + i % 4 * 4 + i % 16 / 4];
    add(scene, check("view/matrices", JudgeKind{"matrices"}), floats(transposed, 16), floats(matrix, 16));
    add(scene, check("triangle/fragments", JudgeKind{"fragments"}), fragments(true), fragments(false));
    Check trace = check("frame/calls", JudgeKind{"trace"});
    trace.own = TraceParameters{{"draw calls", "deprecated calls"}};
    add(scene, trace, text(calls(true)), text(calls(false)));
    const Tensor names = text("1 press\n2 drag\n3 zoom\n");
    add(scene, check("mouse/events", JudgeKind{"events"}),
        floats({1, 10, 20, 2, 11, 20, 2, 12, 20, 3, 0.5F, 0, 3, 2, 0}, 3),
        floats({1, 10, 20, 2, 11, 20, 2, 13, 20, 2, 14, 20, 3, 2, 0}, 3), &names);
    std::vector<double> quadratic;
    std::vector<double> linear;
    for (const double size : {10.0, 30.0, 100.0, 300.0, 1000.0}) {
        quadratic.insert(quadratic.end(), {size, 3 * size * size + 40});
        linear.insert(linear.end(), {size, 12 * size + 55});
    }
    Check growth = check("growth/blocks", JudgeKind{"cost"});
    growth.own = CostParameters{};
    add(scene, growth, table(Element::float64, 2, quadratic), table(Element::float64, 2, linear));
    return scene;
}

/// Names, texts and values that would break a page that does not escape, wrap or bound them.
Scene hostile()
{
    const std::string bad = "</script><img src=x onerror=alert(1)>\"'&\x1b[31m\xff\u202E";
    const std::string endless(600, 'w');
    Scene scene;
    scene.unit.id = endless;
    scene.detail.title = bad + endless;
    scene.unit.verdict = Verdict::wrong;
    scene.unit.output = bad + endless + "\n" + endless;
    scene.unit.message = bad;
    scene.unit.explanations = {{bad, bad + endless, 0.5}};
    Check named = check(bad + endless, JudgeKind{"numbers"});
    named.why = endless;
    add(scene, named, floats({NAN, INFINITY, 1e38F, -1e-38F}), floats({1, 2, 3, 4}));
    return scene;
}

Scene right()
{
    Scene scene;
    scene.unit.id = "made-up/right";
    scene.detail.title = "All right";
    scene.unit.verdict = Verdict::ok;
    scene.unit.seconds = scene.unit.reference_seconds = 0.02;
    add(scene, check("numbers/t", JudgeKind{"numbers"}), floats({1, 2}), floats({1, 2}));
    add(scene, check("picture/colours", JudgeKind{"image"}), picture(256, 256, false), picture(256, 256, false));
    return scene;
}

Scene broken()
{
    Scene scene;
    scene.unit.id = "made-up/broken";
    scene.detail.title = "Does not compile";
    scene.unit.verdict = Verdict::compile_error;
    scene.unit.max_score = 10000;
    scene.unit.message =
        "sphere.cpp:12:31: error: expected ';' before 'return'\n   12 |     const float a = dot(d, d)\n      |         "
        "                      ^\n";
    return scene;
}

/// A class of forty with `units` units, whose names and titles are as long as they come.
ClassResult class_of(int units)
{
    ClassResult result;
    for (int s = 0; s < 40; ++s) {
        SubmissionResult submission;
        submission.id = "student-" + std::to_string(100 + s) + "-with-a-long-name";
        for (int u = 0; u < units; ++u) {
            UnitResult unit;
            unit.id = "transformations/unit-" + std::to_string(u + 1);
            unit.max_score = 10000;
            unit.score = 10000 * ((s + u) % 5) / 4;
            unit.verdict = unit.score == 0                ? Verdict::not_implemented
                           : unit.score == unit.max_score ? Verdict::ok
                                                          : Verdict::partial;
            submission.units.push_back(std::move(unit));
        }
        add_up(submission);
        result.submissions.push_back(std::move(submission));
    }
    return result;
}

}

int main(int count, char** words)
{
    if (count != 2) return 2;
    const std::filesystem::path folder = words[1];
    std::filesystem::create_directories(folder);
    SubmissionResult submission;
    submission.id = "worst-cases";
    html::UnitDetails details;
    for (Scene& scene : std::vector<Scene>{everything(), hostile(), right(), broken()}) {
        details[scene.unit.id] = std::move(scene.detail);
        submission.units.push_back(std::move(scene.unit));
    }
    add_up(submission);
    Fingerprint fingerprint{"0.1.0",     "0123456789ab",           "a processor", "a compiler", "what draws",
                            "a library", {"landlock 4", "seccomp"}};
    write_text(folder / "worst.html", html::report_html(submission, fingerprint, details));
    Image goal(64, 48, glm::u8vec4(40, 120, 200, 255));
    const std::vector<html::CatalogueEntry> entries = {
        {"meshes",
         "meshes/one",
         "A <b>title</b> & \"more\"",
         10000,
         {"problem 1", "lab <2>"},
         "2 checks: numbers, image; 1 hidden",
         html::encode(goal)},
        {"meshes", "meshes/" + std::string(80, 'x'), std::string(200, 'w'), 1, {}, "1 check: numbers", {}},
        {"transforms", "transforms/two", "Two", 2500, {"problem 2"}, "1 check: image", html::encode(goal)}};
    write_text(folder / "catalogue.html", html::catalogue_html(entries, "en", "0.1.0"));
    for (const int units : {1, 8, 46}) {
        html::ClassPageOptions options;
        for (int u = 0; u < units; ++u)
            options.titles["transformations/unit-" + std::to_string(u + 1)] =
                "Where a ray meets a sphere, number " + std::to_string(u + 1);
        write_text(folder / ("class-" + std::to_string(units) + ".html"), html::class_html(class_of(units), options));
    }
    write_text(folder / "empty.html", html::report_html({}, {}, {}));
    std::printf("%s\n", (folder / "worst.html").c_str());
    return 0;
}
