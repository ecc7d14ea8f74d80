#include "judge/events/events.hpp"
#include "judge/events/rule.hpp"
#include "judge/judge_record.hpp"

namespace umbral::grader {

extern constinit const JudgeRecord events_judge;
constinit const JudgeRecord events_judge{
    .name = "events",
    .place = 0,
    .compares = "sequences of events",
    .free_rows = true,
    .keys = 1,
    .nothing_is_empty = true,
    .judge = [](const Question& q) { return judge_events(q.check, q.student, q.expected, q.names); },
    .resemblance = same_events,
    .columns = event_columns,
    .kinds = event_kinds,
    .evidence = events_evidence,
};

}
