#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbral/record/changes.hpp>
#include <umbral/record/recorder.hpp>

namespace umbral::grader {

/// Calls of one function, with the same numbers in their arguments.
struct QuestionKind {
    std::string function;                         ///< "umbral::raytracing::intersect"
    std::vector<std::string> features;            ///< "0.origin.x": umbral/record/features.hpp
    std::vector<std::vector<std::string>> words;  ///< what 0, 1, … of each mean: {"false", "true"}; or none
    std::map<std::uint32_t, std::vector<double>> questions;  ///< the numbers in each
};

/// Questions that follow each other.
struct QuestionSpan {
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    friend bool operator==(const QuestionSpan&, const QuestionSpan&) = default;
};

/// A rectangle of a picture that has questions of its own.
struct QuestionTile {
    QuestionSpan questions;
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t columns = 0;  ///< of the picture
};

/// What a trusted run told of its questions. They are counted from 0.
struct QuestionLog {
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> rows;  ///< for each row its question + 1, or 0
    std::map<std::string, QuestionSpan, std::less<>> wholes;              ///< those that led to a picture
    std::map<std::string, std::vector<QuestionTile>, std::less<>> tiles;
    std::map<std::uint32_t, std::string> code;
    std::vector<QuestionKind> kinds;
    std::vector<QuestionKind> sized;    ///< with how many elements the lists in the answers have, in place of features
    std::vector<OtherQuestion> others;  ///< that can be asked in place of these
    std::vector<OtherQuestion> moves;   ///< small changes of these
    /// For each function that objects were asked by: those that made them, or may have changed them before.
    std::map<std::string, std::vector<std::string>, std::less<>> histories;

    /// The question behind a row of a table, or behind a cell of a picture that was asked cell by cell. Nothing if that
    /// is not known.
    [[nodiscard]] std::optional<std::uint32_t> question_of(std::string_view value, std::size_t cell,
                                                           std::size_t cells) const;
    /// All that is known of what was asked for a row or a cell: that question, or those of its tile, or all that led to
    /// the picture.
    [[nodiscard]] QuestionSpan questions_of(std::string_view value, std::size_t cell, std::size_t cells) const;
    /// Which of the rows of a table that one question led to is this one, from 0 on, and how many there are; {0, 0} if
    /// that is not known.
    [[nodiscard]] std::pair<std::size_t, std::size_t> place_of_row(std::string_view value, std::size_t row) const;
    /// The kind of a question, or null.
    [[nodiscard]] const QuestionKind* kind_of(std::uint32_t question) const;
};

/// Reads what a run with an Inquiry left among its tensors. What does not fit together is left out.
[[nodiscard]] QuestionLog read_questions(const Recorder::Tensors& tensors);

}
