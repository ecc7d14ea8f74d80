// alternative: records are kept as they are, and become words at the end; the square's corners give the matrix; the
// nearest by sorting
#include <deque>
#include <umbral/interaction/pick_buffer.hpp>

namespace umbral::interaction {
namespace {

struct Selection {
    std::deque<std::uint32_t> names;
    std::vector<SelectionRecord> records;
    std::optional<SelectionRecord> open;

    void close()
    {
        if (!open) return;
        open->names.assign(names.begin(), names.end());
        records.push_back(*open);
        open.reset();
    }
};

std::uint32_t scaled(long double depth) { return static_cast<std::uint32_t>(depth * 4294967295.0L + 0.5L); }

class RecordKeeper : public SelectionBuffer {
public:
    explicit RecordKeeper(std::size_t words) : room_(words) {}

    void init_names() override
    {
        current_.close();
        current_.names.clear();
    }

    bool load_name(std::uint32_t name) override { return pop_name() && push_name(name); }

    bool push_name(std::uint32_t name) override
    {
        const bool fits = current_.names.size() < most_names;
        if (fits) {
            current_.close();
            current_.names.push_back(name);
        }
        return fits;
    }

    bool pop_name() override
    {
        if (current_.names.empty()) return false;
        current_.close();
        current_.names.pop_back();
        return true;
    }

    void note_primitive(double min_depth, double max_depth) override
    {
        if (!current_.open) current_.open = SelectionRecord{~0U, 0, {}};
        current_.open->min_depth = std::min(current_.open->min_depth, scaled(min_depth));
        current_.open->max_depth = std::max(current_.open->max_depth, scaled(max_depth));
    }

    int finish() override
    {
        current_.close();
        const Selection done = std::exchange(current_, {});
        words_.clear();
        for (const SelectionRecord& record : done.records) {
            words_.insert(words_.end(),
                          {static_cast<std::uint32_t>(record.names.size()), record.min_depth, record.max_depth});
            for (const std::uint32_t name : record.names) words_.push_back(name);
        }
        if (words_.size() <= room_) return static_cast<int>(done.records.size());
        words_.resize(room_);
        return -1;
    }

    std::span<const std::uint32_t> words() const override { return words_; }

private:
    std::size_t room_;
    Selection current_;
    std::vector<std::uint32_t> words_;
};

}

glm::mat4 pick_matrix(const glm::ivec2& pixel, float size, const glm::ivec2& picture)
{
    // The square's borders in normalised device coordinates go to -1 and 1.
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 2; ++axis) {
        const double from_top_or_left = pixel[axis] + 0.5;
        const double centre = axis == 0 ? from_top_or_left : picture[axis] - from_top_or_left;
        const double low = 2 * (centre - size / 2.0) / picture[axis] - 1;
        const double high = 2 * (centre + size / 2.0) / picture[axis] - 1;
        matrix[axis][axis] = float(2 / (high - low));
        matrix[3][axis] = float(-(high + low) / (high - low));
    }
    return matrix;
}

std::optional<std::vector<SelectionRecord>> parse_selection(std::span<const std::uint32_t> buffer, int count)
{
    std::vector<SelectionRecord> found;
    auto word = buffer.begin();
    const auto left = [&] { return static_cast<std::size_t>(buffer.end() - word); };
    for (int i = count; i != 0; --i) {
        if (i < 0 || left() < 3) return std::nullopt;
        const std::size_t names = *word++;
        SelectionRecord record;
        record.min_depth = *word++;
        record.max_depth = *word++;
        if (left() < names) return std::nullopt;
        std::copy_n(word, names, std::back_inserter(record.names));
        word += static_cast<std::ptrdiff_t>(names);
        found.push_back(std::move(record));
    }
    return found;
}

std::optional<std::size_t> nearest_record(std::span<const SelectionRecord> records)
{
    std::vector<std::size_t> order(records.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return records[a].min_depth < records[b].min_depth; });
    if (order.empty()) return std::nullopt;
    return order.front();
}

std::unique_ptr<SelectionBuffer> make_selection_buffer(std::size_t words)
{
    return std::make_unique<RecordKeeper>(words);
}

}
