#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/config.hpp"
#include "cli/paths.hpp"
#include "judge/explain/explain.hpp"
#include "judge/image/rule.hpp"
#include "judge/judge.hpp"
#include "judge/picture/image_difference.hpp"
#include "judge/picture/image_metrics.hpp"
#include "judge/picture/picture.hpp"
#include "judge/statistics/stochastic.hpp"
#include "report/html/pages.hpp"
#include "report/paint.hpp"
#include "report/reasons.hpp"
#include "unit/evidence.hpp"

namespace umbral::grader {
namespace {

struct CompareOptions {
    std::string yours;
    std::string reference;
    std::string html;
    bool stochastic = false;
    bool json = false;
};

/// Comparing takes about 110 bytes of memory and 3 microseconds a pixel.
constexpr std::size_t most_pixels = std::size_t{1} << 24U;

Image read_picture(const std::string& path)
{
    try {
        Image image = read_png(path);
        if (const std::size_t pixels = std::size_t{1} * image.width * image.height; pixels > most_pixels)
            throw std::runtime_error(fmt::format("{}: expected at most {} pixels, got {} x {}; compare a part of it",
                                                 path, most_pixels, image.width, image.height));
        return image;
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

/// What both rules give, in the form of a check's result.
struct Found {
    bool agree = false;
    CheckResult result;
    std::optional<WorstRegion> worst;
    std::vector<Explanation> reasons{};  ///< what was done to one picture to make the other, best first
};

CheckResult blank(const CompareOptions& options)
{
    CheckResult result;
    result.name = options.stochastic ? "light, tile by tile" : "picture, pixel by pixel";
    result.kind = image_kind();
    result.max_score = 1000;
    return result;
}

Found by_pixels(const Check& check, const Tensor& yours, const Tensor& reference, const CompareOptions& options)
{
    Found found{false, blank(options), {}};
    const Judgement judgement = judge(check, yours, reference, nullptr);
    found.agree = judgement.right >= 1;
    found.result.message = judgement.message;
    found.result.metrics = judgement.metrics;
    found.result.error = judgement.error;
    found.result.first_difference = judgement.first_difference;
    return found;
}

Found by_tiles(const Check& check, const Tensor& yours, const Tensor& reference, const CompareOptions& options)
{
    Found found{false, blank(options), {}};
    const Picture left = to_picture(check, yours);
    const Picture right = to_picture(check, reference);
    const StochasticRule rule = apply_stochastic_rule(left, right);
    found.agree = rule.agree;
    found.result.message = rule.message();
    add_metrics(measure_image(left, right), found.result.metrics);
    found.result.metrics["worst_z"] = rule.worst_z;
    found.result.metrics["probability"] = rule.probability;
    found.result.metrics["tests"] = static_cast<double>(rule.tests);
    return found;
}

Found compare(const Check& check, const Tensor& yours, const Tensor& reference, const CompareOptions& options)
{
    Found found;
    if (yours.rows != reference.rows || yours.columns != reference.columns) {
        found.result = blank(options);
        found.result.message =
            fmt::format("The sizes differ: {} has {} x {} pixels, {} has {} x {}.", options.yours, yours.columns,
                        yours.rows, options.reference, reference.columns, reference.rows);
        return found;
    }
    found =
        options.stochastic ? by_tiles(check, yours, reference, options) : by_pixels(check, yours, reference, options);
    found.result.score = found.agree ? found.result.max_score : 0;
    found.worst = worst_region(check, yours, reference);
    if (!found.agree && !options.stochastic)
        found.reasons = ranked(explain_by_transform({{&check, &yours, &reference}}));
    return found;
}

void print_json(const Found& found, const CompareOptions& options)
{
    nlohmann::json json{{"format", "umbral-compare"},
                        {"version", 1},
                        {"yours", options.yours},
                        {"reference", options.reference},
                        {"rule", options.stochastic ? "stochastic" : "image"},
                        {"agree", found.agree},
                        {"message", found.result.message},
                        {"metrics", found.result.metrics},
                        {"worst", nullptr},
                        {"why", nlohmann::json::array()}};
    for (const Explanation& reason : found.reasons)
        json["why"].push_back(
            {{"name", reason.name}, {"sentence", reason.sentence}, {"confidence", reason.confidence}});
    if (found.worst) {
        const Window& worst = found.worst->worst;
        json["worst"] = {{"x", worst.x}, {"y", worst.y}, {"width", worst.width}, {"height", worst.height}};
    }
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void print_text(const Application& application, const Found& found, const CompareOptions& options)
{
    const Paint paint(application.style);
    fmt::print("\n  {} {}\n", paint.mark(found.agree ? Verdict::ok : Verdict::wrong),
               paint(Tone::strong, found.agree ? "The pictures agree." : "The pictures do not agree."));
    if (!found.result.message.empty()) fmt::print("    {}\n", paint.safe(found.result.message));
    const auto& metrics = found.result.metrics;
    const auto line = [&](const char* key, const char* words, const char* unit) {
        if (const auto metric = metrics.find(key); metric != metrics.end())
            fmt::print("    {:<28}{:.4g}{}\n", words, metric->second, unit);
    };
    if (!metrics.empty()) fmt::print("\n");
    line("ssim", "SSIM (1: the same)", "");
    line("psnr", "PSNR", " dB");
    line("rmse", "RMSE", " of 255 levels");
    line("mean_delta_e", "colour difference, mean", " (CIE 1976)");
    line("max_delta_e", "colour difference, largest", "");
    line("worst_z", "worst tile", " standard deviations");
    if (found.worst) {
        const Window& worst = found.worst->worst;
        fmt::print("    {:<28}{} x {} pixels from ({}, {})\n", "they differ most in", worst.width, worst.height,
                   worst.x, worst.y);
    }
    const char* label = "\n    Why: ";
    for (const std::string& sentence : reason_sentences(found.reasons)) {
        fmt::print("{}{}\n", label, paint.safe(sentence));
        label = "         ";
    }
    if (!options.html.empty()) fmt::print("\n    {}\n", paint.safe(options.html));
    fmt::print("\n");
}

void run(Application& application, const CompareOptions& options)
{
    expect_writable(options.html);
    Check check;
    check.name = "compare";
    check.judge = image_kind();
    const Tensor yours = as_tensor(read_picture(options.yours));
    const Tensor reference = as_tensor(read_picture(options.reference));
    const Found found = compare(check, yours, reference, options);
    if (!options.html.empty()) {
        html::CheckDetail detail;
        detail.evidence = evidence_of(check, {&yours, &reference}, found.agree);
        if (options.stochastic)
            detail.why = fmt::format("a right picture fails once in {:.0f}: noise explains everything else",
                                     1 / stochastic_alpha);
        write_output(options.html, html::comparison_html({options.yours, options.reference, found.result, detail,
                                                          found.reasons, found.agree, config::version}));
    }
    if (options.json)
        print_json(found, options);
    else
        print_text(application, found, options);
    if (!found.agree) application.exit_status = exit_not_right;
}

}

void add_compare(Command command, Application& application)
{
    auto options = std::make_shared<CompareOptions>();
    command.option("YOURS", options->yours, "The picture in question").required();
    command.option("REFERENCE", options->reference, "The picture that is right").required();
    command.flag(
        "--stochastic", options->stochastic,
        "For Monte Carlo pictures: compares the light of tiles, beyond what noise explains, instead of pixels");
    command.flag("--json", options->json, "As JSON");
    command.option("--html", options->html, "Also writes a page that shows both pictures and where they differ");
    command.footer(
        "Exit status: 0 the pictures agree; 1 they do not, or differ in size; 2 a file is missing, empty or no PNG.");
    command.runs([&application, options] { run(application, *options); });
}

}
