#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/transforms.hpp"
#include "judge/image/rule.hpp"
#include "judge/judge_record.hpp"
#include "judge/picture/picture.hpp"

namespace umbral::grader {

extern constinit const JudgeRecord image_judge;
constinit const JudgeRecord image_judge{
    .name = "image",
    .place = 4,
    .compares = "pictures",
    .look = Look::colours,
    .judge = [](const Question& q) { return judge_image(q.check, q.student, q.expected, !q.briefly); },
    .resemblance = same_picture,
    .transforms = image_transforms,
    .evidence = picture_evidence,
    .relation = {.possible = true, .moves = true, .scales = true, .whole_numbers_scale = true, .presentable = complete},
};

}
