#pragma once

#include "model/scorecard.hpp"

namespace umbral::grader::test {

inline Fingerprint fingerprint()
{
    return {"0.1.0", "2a63927", "Some CPU", "g++ 12.2", "llvmpipe 22.3.6", "glibc 2.36", {"landlock 4", "seccomp"}};
}

/// One unit with everything filled in, one that never ran, one that is not the student's fault.
inline SubmissionResult submission()
{
    CheckResult good{.name = "head-on/t",
                     .kind = JudgeKind{"numbers"},
                     .hard = true,
                     .score = 1000,
                     .max_score = 1000,
                     .error = 2.5,
                     .reference_error = 0.5,
                     .message = "",
                     .metrics = {{"ulps", 2.5}},
                     .first_difference = std::nullopt,
                     .artefacts = {}};
    CheckResult bad{.name = "picture/normals",
                    .kind = JudgeKind{"image"},
                    .hidden = true,
                    .score = 250,
                    .max_score = 3000,
                    .error = std::nullopt,
                    .reference_error = std::nullopt,
                    .message = "too dark",
                    .metrics = {{"psnr", 31.5}, {"ssim", 0.5}},
                    .first_difference = Difference{"pixel (120, 33)", "0.1", "0.9"},
                    .artefacts = {{"triptych", "pictures/normals.png"}}};
    UnitResult ran{.id = "raytracing/sphere",
                   .digest = std::string(64, 'a'),
                   .verdict = Verdict::partial,
                   .score = 1250,
                   .max_score = 4000,
                   .seconds = 0.25,
                   .reference_seconds = 0.125,
                   .checks = {good, bad},
                   .message = "",
                   .explanations = {{"transposed", "Your matrix is transposed.", 0.75},
                                    {"mistake: far_root", "You return the far root.", 0.5}},
                   .output = "hello\n",
                   .seed = 18446744073709551615U};
    ran.curve = UnitCurve{"ray-sphere", "head-on/t",     "picture",
                          "ulp",        {"", 2.5, 0.25}, {{"school formula", 4000, 0.125}, {"reference", 0.5, 0.25}}};
    UnitResult absent{.id = "lighting/phong",
                      .digest = std::string(64, 'b'),
                      .verdict = Verdict::missing,
                      .score = 0,
                      .max_score = 2000,
                      .checks = {},
                      .message = "phong.frag was not handed in",
                      .explanations = {},
                      .output = ""};
    UnitResult fault{.id = "meshes/normals",
                     .digest = "",
                     .verdict = Verdict::grader_fault,
                     .score = 0,
                     .max_score = 5000,
                     .checks = {},
                     .message = "no memory",
                     .explanations = {},
                     .output = ""};
    return {"student-1", 0, 0, {ran, absent, fault}};
}

}
