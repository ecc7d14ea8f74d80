#pragma once

#include <filesystem>

#include "bench/judges/picture_pair.hpp"

namespace umbral::grader {

/// Has the scenes drawn into `folder` by `program` (umbral-bench-scenes), with so many pixels on most pictures' side.
/// Throws std::runtime_error if it cannot be run or fails.
void draw_scenes(const std::filesystem::path& program, const std::filesystem::path& folder, int side = 256);

/// Reads `folder`/pictures.json and hands on each variant beside the expected picture, then the expected picture under
/// the operators on pixels (noisy scenes only under those that keep noise as it is: none). Throws std::runtime_error
/// with the file and what is wrong with it.
void visit_scenes(const std::filesystem::path& folder, const VisitPair& visit);

}
