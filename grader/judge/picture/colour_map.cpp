#include "judge/picture/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace umbral::grader {
namespace {

/// The published table: 256 colours in a row, blue first.
cv::Mat magma_table()
{
    cv::Mat levels(1, 256, CV_8U);
    for (int level = 0; level < 256; ++level) levels.at<unsigned char>(level) = static_cast<unsigned char>(level);
    cv::Mat colours;
    cv::applyColorMap(levels, colours, cv::COLORMAP_MAGMA);
    return colours;
}

}

glm::u8vec4 magma(double share)
{
    static const cv::Mat table = magma_table();
    const double known = std::isnan(share) ? 1 : std::clamp(share, 0.0, 1.0);
    const auto& colour = table.at<cv::Vec3b>(static_cast<int>(std::lround(255 * known)));
    return {colour[2], colour[1], colour[0], 255};
}

}
