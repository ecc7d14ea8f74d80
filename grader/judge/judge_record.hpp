#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <umbral/core/grid.hpp>
#include <utility>
#include <vector>

#include "judge/evidence/evidence.hpp"
#include "judge/explain/confidence.hpp"
#include "judge/judge.hpp"
#include "model/caps.hpp"
#include "model/named_rows.hpp"

namespace umbral {
class Field;
}

namespace umbral::grader {

struct FailingCheck;
struct NamedTransform;
struct RowKind;

/// How people look at what a check compares: not at all, as a buffer of values, as colours on a screen, or as amounts
/// of light, which are noisy and shown as sRGB.
enum class Look : std::uint8_t { none, values, colours, light };

/// What a judge is asked. Both tensors are well formed and of one type; of one shape too, but for judges with free
/// rows.
struct Question {
    const Check& check;
    const Tensor& student;
    const Tensor& expected;
    const Tensor* margin = nullptr;  ///< see judge()
    const Tensor* names = nullptr;
    bool briefly = false;  ///< only `right` is needed
};

/// How a judge's checks can hold two values of the student's own run against each other (model/relation.hpp).
struct RelationRules {
    bool possible = false;
    bool moves = false;                ///< has pixels, which can be moved
    bool scales = false;               ///< has amounts, which can be multiplied …
    bool whole_numbers_scale = false;  ///< … in tensors of whole numbers too
    bool (*presentable)(const Tensor&) =
        nullptr;  ///< can it be held up as the expected side? Null: if all its values are finite
    Tensor (*moved)(const Tensor& tensor, const std::array<int, 2>& shift) = nullptr;  ///< null: cells are moved
};

/// A field of a check that one judge alone takes: demanded by it unless it is optional, refused with any other.
struct OwnField {
    std::string_view name;
    std::string_view schema;  ///< its JSON schema, for docs/schemas/exercise.schema.json
    bool optional = false;
};

/// All that is particular to one judge. A new one is a folder grader/judge/<name> that defines such a record, and its
/// line in judges.cpp: all else asks the record. Null pointers and false mean what is said there.
struct JudgeRecord {
    std::string_view name;
    /// From exact to vague: exact lists 0, numbers 1, intermediate buffers 2, what is counted or derived 3, the colour
    /// picture 4. What a student is shown first follows this, and checks of one place the manifest: a mistake that a
    /// number names, a picture only hints at.
    int place = 3;
    std::string_view compares;  ///< what it compares, in a few words of a sentence: "numbers row by row"

    // What a check takes in the manifest, beside the fields that all take.
    bool needs_tolerance = false;
    bool pairs = false;  ///< may rows 2k and 2k + 1 count together?
    std::span<const OwnField> own_fields{};
    void (*read_own)(const Field& check, Check& to) = nullptr;
    std::string_view schema_of_check{};  ///< JSON schema of what else `read_own` demands of a check; empty: nothing
    int most_in_course = 0;              ///< checks in all units together; 0: any number

    // What is recorded.
    bool free_rows = false;                    ///< numbers of rows may differ
    std::size_t keys = 0;                      ///< numbers at the beginning of a row that say what it is about
    bool nothing_is_empty = false;             ///< recorded row by row: nothing at all is an empty table
    bool plain_values = true;                  ///< the values themselves are compared, and not what is counted in them
    std::size_t more_cells = caps::rows_more;  ///< so many more than expected are read
    bool counts_work = false;                  ///< its values count the work of code that was compiled for it
    bool is_of_drawing = false;                ///< its values say how pictures are drawn, and are worth what is drawn
    Look look = Look::none;
    bool (*can_be_drawn)(const Tensor&) = nullptr;  ///< null: whatever has a look

    // Judging.
    Judgement (*judge)(const Question& question) = nullptr;
    /// Null: common_controls (controls.hpp).
    std::vector<std::pair<std::string, Tensor>> (*controls)(const Check& check, const Tensor& expected,
                                                            std::uint64_t seed) = nullptr;
    /// What is borderline (Judgement::borderline) is run again with a fresh seed, and both runs decide. Null: nothing
    /// is.
    Judgement (*judge_both)(const Judgement& first, const Judgement& second) = nullptr;
    /// Of right work's metrics: which parameter of the check leaves it too little room, in a sentence; empty if none
    /// does. Null: none can.
    std::string (*too_narrow)(const Check& check, const std::map<std::string, double>& metrics) = nullptr;

    // Explaining.
    /// resemblance() of a failing check, where both results can be judged.
    Resemblance (*resemblance)(const FailingCheck& failing, const Tensor& mistake) = nullptr;
    /// What is wrong with the student's values by themselves, whether the check notices or not. Null: nothing is known.
    std::optional<Explanation> (*fault)(const FailingCheck& one) = nullptr;
    /// What each number of a row is called, by the text that the driver records for that; none where it has no name of
    /// its own. Null: as columns.hpp says, or nothing where rows are free.
    std::vector<std::string> (*columns)(std::string_view names, std::size_t components) = nullptr;
    /// What kinds of rows are called, by the code that they begin with: "zoom" for 3. Null: there are no kinds.
    std::map<double, NamedRows> (*kinds)(std::string_view names, std::size_t components) = nullptr;
    const RowKind& (*rows)() = nullptr;                     ///< how single rows are compared; null: as rows of numbers
    std::vector<NamedTransform> (*transforms)() = nullptr;  ///< those that are tried on its results first
    std::optional<double> (*likeness)(const Tensor& student,
                                      const Tensor& reference) = nullptr;  ///< null: by correlation

    // Showing.
    Grid<std::uint8_t> (*difference_map)(const Check& check, const Tensor& student,
                                         const Tensor& expected) = nullptr;  ///< null: pixel by pixel
    Evidence (*evidence)(const Check& check, const Observation& observation, bool right) = nullptr;

    RelationRules relation{};
};

}
