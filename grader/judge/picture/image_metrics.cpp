#include "judge/picture/image_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "judge/picture/image_rule.hpp"

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
    cv::Mat colours(part.height, part.width, CV_32FC3);
    for (int y = 0; y < part.height; ++y)
        for (int c = 0; c < 3; ++c) {
            const std::uint8_t* from = picture.row(c % picture.colours(), part.y + y) + part.x;
            float* to = colours.ptr<float>(y) + c;
            for (int x = 0; x < part.width; ++x) to[3 * x] = static_cast<float>(from[x]) / 255.0F;
        }
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

// Means, mean sum of squares and mean product over a window, for a row of windows.
struct Moments {
    std::vector<double> x, y, squares, products;
    explicit Moments(std::size_t size) : x(size), y(size), squares(size), products(size) {}
};

std::array<double, radius + 1> gaussian()
{
    std::array<double, radius + 1> weights{};
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        weights[static_cast<std::size_t>(i)] = std::exp(-i * i / (2 * 1.5 * 1.5));
        sum += (i == 0 ? 1 : 2) * weights[static_cast<std::size_t>(i)];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// Sums the window's columns: the four fields in one pass over the eleven rows of the two padded pictures.
void sum_columns(const cv::Mat& x, const cv::Mat& y, int row, const std::array<double, radius + 1>& weights,
                 Moments& out)
{
    const std::size_t size = out.x.size();
    for (auto* field : {&out.x, &out.y, &out.squares, &out.products}) std::fill(field->begin(), field->end(), 0.0);
    double* __restrict sum_x = out.x.data();
    double* __restrict sum_y = out.y.data();
    double* __restrict squares = out.squares.data();
    double* __restrict products = out.products.data();
    for (int k = -radius; k <= radius; ++k) {
        const double weight = weights[static_cast<std::size_t>(std::abs(k))];
        const double* __restrict a = x.ptr<double>(row + radius + k);
        const double* __restrict b = y.ptr<double>(row + radius + k);
        for (std::size_t i = 0; i < size; ++i) {
            const double p = weight * a[i];
            const double q = weight * b[i];
            sum_x[i] += p;
            sum_y[i] += q;
            squares[i] += p * a[i] + q * b[i];
            products[i] += p * b[i];
        }
    }
}

void sum_rows(const std::vector<double>& from, const std::array<double, radius + 1>& weights, std::vector<double>& to)
{
    const double* __restrict source = from.data() + radius;
    double* __restrict target = to.data();
    for (std::size_t i = 0; i < to.size(); ++i) target[i] = weights[0] * source[i];
    for (std::size_t k = 1; k <= radius; ++k)
        for (std::size_t i = 0; i < to.size(); ++i) target[i] += weights[k] * (*(source + i - k) + source[i + k]);
}

// One minus the similarity, summed over the pixels of `inner`; `outer` is it with the window's radius round it, inside
// the picture.
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
    cv::copyMakeBorder(x, x, radius, radius, radius, radius, cv::BORDER_REFLECT_101);
    cv::copyMakeBorder(y, y, radius, radius, radius, radius, cv::BORDER_REFLECT_101);
    const auto weights = gaussian();
    Moments columns(static_cast<std::size_t>(x.cols));
    Moments mean(static_cast<std::size_t>(outer.width));
    const auto first = static_cast<std::size_t>(inner.x - outer.x);
    double sum = 0;
    for (int row = inner.y - outer.y; row < inner.y - outer.y + inner.height; ++row) {
        sum_columns(x, y, row, weights, columns);
        sum_rows(columns.x, weights, mean.x);
        sum_rows(columns.y, weights, mean.y);
        sum_rows(columns.squares, weights, mean.squares);
        sum_rows(columns.products, weights, mean.products);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(inner.width); ++i) {
            const double mx = mean.x[i] + centre;
            const double my = mean.y[i] + centre;
            const double variances = mean.squares[i] - mean.x[i] * mean.x[i] - mean.y[i] * mean.y[i];
            const double covariance = mean.products[i] - mean.x[i] * mean.y[i];
            sum += 1 - (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (variances + c2));
        }
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

double structural_similarity(const Picture& student, const Picture& expected)
{
    return similarity_in(student, expected, differing_part(student, expected));
}

ImageMetrics measure_image(const Picture& student, const Picture& expected)
{
    // A grader has a worker for each processor already: with threads below them, two workers took as long as one.
    cv::setNumThreads(1);
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
            const float* a = yours.ptr<float>(y) + 3 * x;
            const float* b = target.ptr<float>(y) + 3 * x;
            const double distance = std::sqrt(
                double{(a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2])});
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
