#pragma once

#include <map>
#include <string>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// The usual measures of how far two pictures lie apart. They are reported, they never decide.
struct ImageMetrics {
    double rmse = 0;      ///< levels, over all colour channels
    double psnr = 0;      ///< decibel against 255; infinite for equal pictures
    double ssim = 1;      ///< structural similarity of the luma, -1 .. 1
    double mean_lab = 0;  ///< mean CIE 1976 colour difference
    double max_lab = 0;   ///< the largest one
};

/// Measures two pictures of one size; alpha does not count. Only the rectangle where they differ costs time.
[[nodiscard]] ImageMetrics measure_image(const Picture& student, const Picture& expected);

/// Mean structural similarity of the luma: Gaussian window 11 x 11, sigma 1.5, K1 0.01, K2 0.03, computed in double
/// with moments about a common centre (single precision gives .9998 instead of .999992 for constant 255 against 254).
/// Pixels beyond the edge are mirrored. Based on: Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli. Image Quality
/// Assessment: From Error Visibility to Structural Similarity. 2004.
[[nodiscard]] double structural_similarity(const Picture& student, const Picture& expected);

/// Finite metrics under their names in reports: "ssim", "psnr" (left out if infinite), "rmse", "mean_delta_e",
/// "max_delta_e".
void add_metrics(const ImageMetrics& metrics, std::map<std::string, double>& to);

}
