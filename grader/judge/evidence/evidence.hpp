#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <umbral/core/grid.hpp>
#include <variant>
#include <vector>

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

// What a page shows of a check beside its words: plain data, of few kinds. Judges make it from recordings; reports draw
// the kinds, and know no judges.

/// A part of two pictures, pixel by pixel.
struct Magnified {
    int x = 0;  ///< of its left top pixel in the whole picture
    int y = 0;
    Image yours;
    Image reference;
    Image difference;
    std::vector<std::string> texts;              ///< every value that occurs in it, in words, once
    std::vector<std::uint16_t> yours_texts;      ///< for each pixel, row by row, which of them the student has …
    std::vector<std::uint16_t> reference_texts;  ///< … and which the reference
    std::vector<std::uint8_t> levels;            ///< how far they lie apart, 0 .. 255
};

struct PixelPair {
    int x = 0;
    int y = 0;
    std::string yours;
    std::string reference;
    int level = 0;
};

/// Two pictures or buffers. Without `reference` they are equal, or cannot be compared, which `problem` says.
struct PictureEvidence {
    Image yours;
    std::optional<Image> reference;
    std::optional<Image> difference;
    int largest = 0;            ///< of the differences, in levels of 255
    bool graded = true;         ///< differences have sizes; otherwise cells are equal or not
    std::size_t differing = 0;  ///< pixels that differ at all
    std::optional<Magnified> worst;
    std::vector<PixelPair> pixels;  ///< those that differ most within `worst`
    std::string problem;
    std::string expected_side = "reference";  ///< what stands over the pictures that are not yours
};

/// One row of a table of numbers, or one matrix, by components (matrices column by column).
struct RowPair {
    std::string name;                ///< "row 17", or what a colleague of it is called
    std::vector<std::string> yours;  ///< one text instead if there is nothing
    std::vector<std::string> expected;
    std::vector<bool> differs;  ///< by component
    std::string note;           ///< "320 ulp", "missing"
    std::size_t cell = 0;       ///< of the recording
    std::string question{};     ///< what was asked there, as code; empty where that is not known
};

struct RowsEvidence {
    int side = 0;                       ///< 3 or 4: rows are matrices; 0: they are not
    std::vector<std::string> headings;  ///< of the components, where they have names
    std::size_t equal_columns = 0;      ///< of many named components, those that are left out: equal in all rows shown
    std::vector<RowPair> first;         ///< the first wrong rows
    std::vector<RowPair> worst;         ///< the worst of the others
    std::size_t rows = 0;               ///< that count
    std::size_t wrong = 0;
};

enum class LineKind : std::uint8_t { same, changed, missing, extra, omitted };

/// Two lines beside each other, with their numbers; nothing where there is none on that side.
struct LinePair {
    LineKind kind = LineKind::same;
    std::optional<std::size_t> yours_number{};
    std::optional<std::size_t> expected_number{};
    std::string yours;
    std::string expected;
    std::size_t omitted = 0;  ///< equal lines left out here
};

/// Two lists in their order: calls, events.
struct LinesEvidence {
    std::string what;  ///< "calls", "events"
    std::vector<LinePair> lines;
    std::size_t missing = 0;
    std::size_t extra = 0;
    std::size_t changed = 0;
    bool cut = false;  ///< there are more lines than are shown
};

struct FragmentsEvidence {
    std::string sketch;  ///< in characters, from the judge
    int x = 0;           ///< pixel of the picture's left top cell
    int y = 0;
    std::optional<Image> picture;  ///< a pixel for each place: what is right, missing, extra, of another value
    std::size_t right = 0;
    std::size_t missing = 0;
    std::size_t extra = 0;
    std::size_t changed = 0;
    RowsEvidence rows;
};

struct CostPoint {
    double size = 0;
    std::optional<double> yours;
    std::optional<double> reference;
};

struct CostEvidence {
    std::vector<CostPoint> points;
    double growth = 1;  ///< the largest exponent allowed
};

using Evidence =
    std::variant<std::monostate, PictureEvidence, RowsEvidence, LinesEvidence, FragmentsEvidence, CostEvidence>;

/// What was recorded for one check. `margin`, `names` and `sketch` may be null or empty.
struct Observation {
    const Tensor* yours = nullptr;
    const Tensor* expected = nullptr;
    const Tensor* margin = nullptr;
    const Tensor* names = nullptr;
    std::string sketch{};  ///< the judgement's
};

}
