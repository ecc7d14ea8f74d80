#include <array>
#include <cstdio>
#include <opencv2/core.hpp>
#include <string_view>

#include "bench/best_time.hpp"
#include "judge/picture/image_difference.hpp"
#include "judge/picture/image_metrics.hpp"
#include "judge/picture/image_rule.hpp"
#include "judge/rules.hpp"
#include "noise_runs.hpp"

namespace {

using namespace umbral::grader;

int rounds = 15;

/// Prints and returns milliseconds.
template <class Work>
double report(const char* what, Work work)
{
    const double time = best_milliseconds(work, rounds);
    std::printf("%-46s %8.3f ms\n", what, time);
    return time;
}

}

// Processor time of the image judge at 512 x 512, one thread, best of 15, with --quick of 2. The last lines are those
// of the README.
int main(int count, char** words)
{
    if (count > 1 && std::string_view(words[1]) == "--quick") rounds = 2;
    cv::setNumThreads(1);
    const umbral::Tensor right = test::balls(512);
    umbral::Random random(1);
    const auto noisy = [&](std::uint32_t span) {
        return test::repaint(right, [&](int x, int y) {
            test::Colour colour = test::pixel(right, x, y);
            for (glm::length_t c = 0; c < 3; ++c)
                colour[c] = test::byte(colour[c] + random.below(span) - (span - 1) / 2.0);
            return colour;
        });
    };
    const umbral::Tensor same = right;
    const umbral::Tensor close = noisy(3);
    const umbral::Tensor far = noisy(121);
    const Check check = test::check_of(JudgeKind{"image"});
    const double equal = report("equal", [&] { (void)judge(check, same, right, nullptr); });
    std::vector<std::array<double, 2>> sums;  // the rule, and all metrics beside it
    for (const auto& [name, student] :
         {std::pair{"one level of noise", &close}, std::pair{"every pixel far off", &far}}) {
        std::printf("%s\n", name);
        const double rule =
            report("  rule and conversion", [&] { (void)fraction_right(check, *student, right, nullptr); });
        report("  to_picture, one picture", [&] { (void)to_picture(check, right); });
        const Picture a = to_picture(check, *student);
        const Picture b = to_picture(check, right);
        report("  rule alone", [&] { (void)apply_image_rule(a, b); });
        report("  SSIM alone", [&] { (void)structural_similarity(a, b); });
        const double metrics = report("  SSIM, PSNR, RMSE, Lab", [&] { (void)measure_image(a, b); });
        report("  judge: rule, metrics, worst region", [&] { (void)judge(check, *student, right, nullptr); });
        sums.push_back({rule, rule + metrics});
    }
    std::printf("noise, three channels\n");
    const auto light = [](int x, int y) { return test::floor_and_ball(x / 8, y / 8); };
    const umbral::Tensor expected = test::noisy(random, 512, 512, 3, 1, light);
    const umbral::Tensor student = test::noisy(random, 512, 512, 3, 1, light);
    const Check noise = test::noise_check();
    report("  judge, floats", [&] { (void)judge(noise, student, expected, nullptr); });
    const umbral::Tensor expected_bytes = test::as_bytes(expected);
    const umbral::Tensor student_bytes = test::as_bytes(student);
    report("  judge, bytes", [&] { (void)judge(noise, student_bytes, expected_bytes, nullptr); });
    report("  best control, floats", [&] { (void)best_control(noise, expected, nullptr, 1); });
    std::printf(
        "\n%.2f ms if equal; %.1f ms with one level of noise, %.1f ms where every pixel is wrong, conversion "
        "included;\n"
        "with SSIM, PSNR, RMSE and Lab beside it %.0f ms\n",
        equal, sums[0][0], sums[1][0], sums[1][1]);
    return 0;
}
