#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/buffer/buffer_classes.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t cell_reach = 3;    // cells to each side of the centre
constexpr std::size_t widest_name = 3;   // ids with more digits are told apart by letters
constexpr std::size_t most_letters = 4;  // that the legend explains

Box window_of(const BufferCells& cells, std::size_t centre)
{
    const std::size_t x = centre % cells.columns;
    const std::size_t y = centre / cells.columns;
    return {x - std::min(x, cell_reach), y - std::min(y, cell_reach), std::min(x + cell_reach, cells.columns - 1),
            std::min(y + cell_reach, cells.rows - 1)};
}

template <class Visit>
void for_each_cell(const BufferCells& cells, const Box& box, Visit visit)
{
    for (std::size_t y = box.top; y <= box.bottom; ++y)
        for (std::size_t x = box.left; x <= box.right; ++x) visit(y * cells.columns + x);
}

/// How a cell's value is drawn, and what the signs mean.
class Signs {
public:
    Signs(const BufferCells& cells, BufferKind kind, const Box& box) : cells_(cells), kind_(kind)
    {
        if (kind != BufferKind::depth) return;
        for (const TensorView* view : {&cells.yours, &cells.expected})
            for_each_cell(cells, box, [&](std::size_t cell) {
                if (!view->present(cell) || is_background(*view, cell) || !std::isfinite(view->cell(cell)[0])) return;
                low_ = std::min(low_, view->cell(cell)[0]);
                high_ = std::max(high_, view->cell(cell)[0]);
            });
    }

    std::string sign(const TensorView& view, std::size_t cell)
    {
        if (!view.present(cell) || is_background(view, cell)) return ".";
        const auto values = view.cell(cell);
        if (!all_finite(values)) return "!";
        if (kind_ == BufferKind::depth) return std::to_string(level(values[0]));
        std::string text = number_text(values[0]);
        if (values.size() == 1 && text.size() <= widest_name) return text;
        return letter(cell_text(view, cell));
    }

    [[nodiscard]] std::string legend() const
    {
        std::string text;
        if (kind_ == BufferKind::depth && low_ <= high_)
            text = fmt::format(" 0..9 depths {}..{},", number_text(low_), number_text(high_));
        for (std::size_t i = 0; i < std::min(letters_.size(), most_letters); ++i)
            text += fmt::format(" {} {},", char('a' + i), letters_[i]);
        return text + " . background, > wrong";
    }

private:
    [[nodiscard]] bool is_background(const TensorView& view, std::size_t cell) const
    {
        return view.present(cell) == cells_.expected.present(cells_.background) &&
               std::ranges::equal(view.cell(cell), cells_.expected.cell(cells_.background));
    }
    [[nodiscard]] int level(double value) const
    {
        return high_ > low_ ? static_cast<int>(std::lround(9 * (value - low_) / (high_ - low_))) : 5;
    }
    std::string letter(const std::string& text)
    {
        auto found = std::ranges::find(letters_, text);
        if (found == letters_.end()) found = letters_.insert(letters_.end(), text);
        const auto index = static_cast<std::size_t>(found - letters_.begin());
        return index < 26 ? std::string(1, static_cast<char>('a' + index)) : "?";
    }

    const BufferCells& cells_;
    BufferKind kind_;
    double low_ = INFINITY;
    double high_ = -INFINITY;
    std::vector<std::string> letters_;
};

// Normals and coordinates differ from cell to cell: what became of each cell says more than its name.
const char* state_sign(CellState state)
{
    switch (state) {
        case CellState::background: return ".";
        case CellState::right: return "#";
        case CellState::missing: return "-";
        case CellState::extra: return "+";
        case CellState::other: break;
    }
    return "~";
}

std::string state_sketch(const BufferCells& cells, const Box& box, const std::string& place)
{
    std::string text;
    for_each_cell(cells, box, [&](std::size_t cell) {
        text += state_sign(cells.states[cell]);
        if (cell % cells.columns == box.right) text += '\n';
    });
    return text + place + " # right - missing + extra ~ wrong value . background";
}

}

std::string buffer_sketch(const BufferCells& cells, BufferKind kind, std::size_t centre)
{
    const Box box = window_of(cells, centre);
    const std::string place = fmt::format("x {}..{}, y {}..{};", box.left, box.right, box.top, box.bottom);
    if (kind == BufferKind::normals || kind == BufferKind::texture ||
        (kind == BufferKind::cells && cells.expected.components() > 1))
        return state_sketch(cells, box, place);
    Signs signs(cells, kind, box);
    std::vector<std::string> yours;
    std::vector<std::string> expected;
    std::size_t width = 1;
    for_each_cell(cells, box, [&](std::size_t cell) {
        yours.push_back(signs.sign(cells.yours, cell));
        expected.push_back(signs.sign(cells.expected, cell));
        width = std::max({width, yours.back().size(), expected.back().size()});
    });
    const std::size_t columns = box.right - box.left + 1;
    std::string text = fmt::format("{:<{}}expected\n", "yours", std::max<std::size_t>(columns * (width + 1) + 3, 8));
    for (std::size_t row = 0; row * columns < yours.size(); ++row) {
        std::string left;
        std::string right;
        for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
            const std::size_t cell = (box.top + row) * cells.columns + box.left + i % columns;
            left += fmt::format("{:>{}}", (cells.wrong(cell) ? ">" : "") + yours[i], width + 1);
            right += fmt::format(" {:>{}}", expected[i], width);
        }
        text += fmt::format("{:<{}}{}\n", left, std::max<std::size_t>(columns * (width + 1) + 3, 8), right);
    }
    return text + place + signs.legend();
}

}
