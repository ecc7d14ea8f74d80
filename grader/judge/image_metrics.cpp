#include "judge/image_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "judge/image_rule.hpp"

namespace umbral::grader {
namespace {

constexpr int radius = 5;

// The smallest rectangle that holds every differing pixel; empty for equal pictures.
cv::Rect differing_part(const Picture& a, const Picture& b)
{
    const std::vector<std::uint8_t> difference = channel_difference(a, b);
    const cv::Mat map(a.height, a.width, CV_8U, const_cast<std::uint8_t*>(difference.data()));
    return cv::boundingRect(map);
}

// The colour channels inside `part`, interleaved, as floats 0..1.
cv::Mat colours_in(const Picture& picture, const cv::Rect& part)
{
    std::vector<cv::Mat> planes;
    for (int c = 0; c < 3; ++c) {
        const int channel = c % picture.colours();
        cv::Mat plane(part.height, part.width, CV_32F);
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) plane.at<float>(y, x) = static_cast<float>(picture.row(channel, part.y + y)[part.x + x]) / 255.0F;
        planes.push_back(plane);
    }
    cv::Mat colours;
    cv::merge(planes, colours);
    return colours;
}

// Luma of Rec. 601, which makes grey of (v, v, v) exactly v.
cv::Mat luma_in(const Picture& picture, const cv::Rect& part)
{
    cv::Mat luma(part.height, part.width, CV_64F);
    for (int y = 0; y < part.height; ++y) {
        auto* out = luma.ptr<double>(y);
        const std::uint8_t* red = picture.row(0, part.y + y) + part.x;
        if (picture.colours() == 1) {
            for (int x = 0; x < part.width; ++x) out[x] = red[x];
            continue;
        }
        const std::uint8_t* green = picture.row(1, part.y + y) + part.x;
        const std::uint8_t* blue = picture.row(2, part.y + y) + part.x;
        for (int x = 0; x < part.width; ++x) out[x] = (299 * red[x] + 587 * green[x] + 114 * blue[x]) / 1000.0;
    }
    return luma;
}

// One minus the similarity, summed over the pixels of `inner`; `outer` is it with the window's radius round it, inside the picture.
double dissimilarity(const Picture& student, const Picture& expected, const cv::Rect& outer, const cv::Rect& inner)
{
    constexpr double c1 = (0.01 * 255) * (0.01 * 255);
    constexpr double c2 = (0.03 * 255) * (0.03 * 255);
    cv::Mat x = luma_in(student, outer);
    cv::Mat y = luma_in(expected, outer);
    // Moments about a common centre near both means lose no digits to the square of the mean.
    const double centre = (cv::mean(x)[0] + cv::mean(y)[0]) / 2;
    x -= centre;
    y -= centre;
    const auto blur = [](const cv::Mat& from) {
        cv::Mat to;
        cv::GaussianBlur(from, to, cv::Size(2 * radius + 1, 2 * radius + 1), 1.5, 1.5, cv::BORDER_REFLECT_101);
        return to;
    };
    const cv::Mat mean_x = blur(x);
    const cv::Mat mean_y = blur(y);
    const cv::Mat squares = blur(x.mul(x) + y.mul(y));
    const cv::Mat products = blur(x.mul(y));
    double sum = 0;
    for (int row = inner.y - outer.y; row < inner.y - outer.y + inner.height; ++row)
        for (int column = inner.x - outer.x; column < inner.x - outer.x + inner.width; ++column) {
            const double dx = mean_x.at<double>(row, column);
            const double dy = mean_y.at<double>(row, column);
            const double mx = dx + centre;
            const double my = dy + centre;
            const double variances = squares.at<double>(row, column) - dx * dx - dy * dy;
            const double covariance = products.at<double>(row, column) - dx * dy;
            sum += 1 - (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (variances + c2));
        }
    return sum;
}

cv::Rect grown(const cv::Rect& part, int by, const Picture& picture)
{
    return (part + cv::Size(2 * by, 2 * by) - cv::Point(by, by)) & cv::Rect(0, 0, picture.width, picture.height);
}

double similarity_in(const Picture& student, const Picture& expected, const cv::Rect& part)
{
    if (part.area() == 0) return 1;
    // Windows that hold no difference have similarity 1 exactly, so only those round `part` are computed.
    const cv::Rect inner = grown(part, radius, expected);
    const double pixels = static_cast<double>(expected.width) * expected.height;
    return 1 - dissimilarity(student, expected, grown(inner, radius, expected), inner) / pixels;
}

}

double structural_similarity(const Picture& student, const Picture& expected) { return similarity_in(student, expected, differing_part(student, expected)); }

ImageMetrics measure_image(const Picture& student, const Picture& expected)
{
    ImageMetrics metrics;
    metrics.psnr = std::numeric_limits<double>::infinity();
    const cv::Rect part = differing_part(student, expected);
    if (part.area() == 0) return metrics;
    const double pixels = static_cast<double>(expected.width) * expected.height;

    cv::Mat yours = colours_in(student, part);
    cv::Mat target = colours_in(expected, part);
    const double squares = cv::norm(yours, target, cv::NORM_L2SQR) * 255 * 255 / (3 * pixels);
    metrics.rmse = std::sqrt(squares);
    metrics.psnr = squares > 0 ? 10 * std::log10(255.0 * 255.0 / squares) : metrics.psnr;

    cv::cvtColor(yours, yours, cv::COLOR_RGB2Lab);
    cv::cvtColor(target, target, cv::COLOR_RGB2Lab);
    double sum = 0;
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            const double distance = cv::norm(yours.at<cv::Vec3f>(y, x) - target.at<cv::Vec3f>(y, x));
            sum += distance;
            metrics.max_lab = std::max(metrics.max_lab, distance);
        }
    metrics.mean_lab = sum / pixels;
    metrics.ssim = similarity_in(student, expected, part);
    return metrics;
}

void add_metrics(const ImageMetrics& metrics, std::map<std::string, double>& to)
{
    to["ssim"] = metrics.ssim;
    to["rmse"] = metrics.rmse;
    if (std::isfinite(metrics.psnr)) to["psnr"] = metrics.psnr;
    to["mean_delta_e"] = metrics.mean_lab;
    to["max_delta_e"] = metrics.max_lab;
}

}
