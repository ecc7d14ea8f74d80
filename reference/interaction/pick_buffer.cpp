// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 2.1). 2006, section 5.2
// (selection); and, for the matrix, gluPickMatrix of the OpenGL Graphics System Utility Library (version 1.3).

#include <algorithm>
#include <umbral/interaction/pick_buffer.hpp>
#include <utility>

namespace umbral::interaction {
namespace {

constexpr std::size_t words_before_names = 3;

/// Depths are spread over all numbers of 32 bits: more than a float can hold.
std::uint32_t depth_word(double depth) { return static_cast<std::uint32_t>(depth * 4294967295.0 + 0.5); }

class WordBuffer : public SelectionBuffer {
public:
    explicit WordBuffer(std::size_t capacity) : capacity_(capacity) {}

    void init_names() override
    {
        write_record();
        names_.clear();
    }

    bool load_name(std::uint32_t name) override
    {
        if (names_.empty()) return false;
        write_record();
        names_.back() = name;
        return true;
    }

    bool push_name(std::uint32_t name) override
    {
        if (names_.size() == most_names) return false;
        write_record();
        names_.push_back(name);
        return true;
    }

    bool pop_name() override
    {
        if (names_.empty()) return false;
        write_record();
        names_.pop_back();
        return true;
    }

    void note_primitive(double min_depth, double max_depth) override
    {
        if (!noted_) noted_ = Range{min_depth, max_depth};
        noted_->least = std::min(noted_->least, min_depth);
        noted_->greatest = std::max(noted_->greatest, max_depth);
    }

    int finish() override
    {
        write_record();
        const int result = is_full_ ? -1 : records_;
        finished_ = std::exchange(words_, {});
        names_.clear();
        is_full_ = false;
        records_ = 0;
        return result;
    }

    std::span<const std::uint32_t> words() const override { return finished_; }

private:
    struct Range {
        double least;
        double greatest;
    };

    void write_record()
    {
        if (!noted_) return;
        const Range depths = *noted_;
        noted_.reset();
        if (words_.size() + words_before_names + names_.size() > capacity_) {
            is_full_ = true;
            return;
        }
        words_.push_back(static_cast<std::uint32_t>(names_.size()));
        words_.push_back(depth_word(depths.least));
        words_.push_back(depth_word(depths.greatest));
        words_.insert(words_.end(), names_.begin(), names_.end());
        ++records_;
    }

    std::size_t capacity_;
    std::vector<std::uint32_t> words_;     // of this selection
    std::vector<std::uint32_t> finished_;  // of the last one
    std::vector<std::uint32_t> names_;     // the bottom of the stack first
    std::optional<Range> noted_;           // of the primitives since the last record
    int records_ = 0;
    bool is_full_ = false;
};

}

glm::mat4 pick_matrix(const glm::ivec2& pixel, float size, const glm::ivec2& picture)
{
    const glm::dvec2 wide(picture);
    // The square's centre in OpenGL's window coordinates, whose y grows upwards.
    const glm::dvec2 centre(pixel.x + 0.5, wide.y - (pixel.y + 0.5));
    const glm::dvec2 factor = wide / double{size};
    const glm::dvec2 shift = (wide - 2.0 * centre) / double{size};
    glm::dmat4 matrix(1);
    matrix[0][0] = factor.x;
    matrix[1][1] = factor.y;
    matrix[3] = glm::dvec4(shift, 0, 1);
    return glm::mat4(matrix);
}

std::optional<std::vector<SelectionRecord>> parse_selection(std::span<const std::uint32_t> buffer, int count)
{
    if (count < 0) return std::nullopt;
    std::vector<SelectionRecord> records;
    for (int i = 0; i < count; ++i) {
        if (buffer.size() < words_before_names) return std::nullopt;
        const std::size_t names = buffer[0];
        const std::span<const std::uint32_t> behind = buffer.subspan(words_before_names);
        if (behind.size() < names) return std::nullopt;
        const auto first = behind.begin();
        records.push_back({buffer[1], buffer[2], {first, first + static_cast<std::ptrdiff_t>(names)}});
        buffer = behind.subspan(names);
    }
    return records;
}

std::optional<std::size_t> nearest_record(std::span<const SelectionRecord> records)
{
    if (records.empty()) return std::nullopt;
    const auto nearest =
        std::min_element(records.begin(), records.end(),
                         [](const SelectionRecord& a, const SelectionRecord& b) { return a.min_depth < b.min_depth; });
    return static_cast<std::size_t>(nearest - records.begin());
}

std::unique_ptr<SelectionBuffer> make_selection_buffer(std::size_t words)
{
    return std::make_unique<WordBuffer>(words);
}

}
