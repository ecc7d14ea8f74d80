#include "judge/buffer/rule.hpp"
#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/transforms.hpp"
#include "judge/judge_record.hpp"

namespace umbral::grader {

extern constinit const JudgeRecord buffer_judge;
constinit const JudgeRecord buffer_judge{
    .name = "buffer",
    .place = 2,
    .compares = "cells of a buffer exactly",
    .pairs = true,
    .look = Look::values,
    .judge = [](const Question& q) { return judge_buffer(q.check, q.student, q.expected, !q.briefly); },
    .resemblance = same_rows,
    .evidence = picture_evidence,
    .relation = {.possible = true, .moves = true, .scales = true, .presentable = [](const Tensor&) { return true; }},
};

}
